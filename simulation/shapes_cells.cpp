// Copyright the limpet authors. GPL-3.0-or-later.
//
// Random lattice polyhedra: cells joined by their faces, sheared. Some of their vertices have four faces, of
// which two lie in one plane, or six, of which pairs lie in one plane and touch in that vertex only.
#include <algorithm>
#include <array>
#include <limpet/simulation/shapes_internal.hpp>
#include <limpet/survey/random.hpp>
#include <vector>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;
using Cell = std::array<int, 3>;

constexpr int kLargestSide = 41;  ///< of the lattice: room for far more cells than a name may ask for

Cell moved(Cell cell, int axis, int by) {
  cell[static_cast<std::size_t>(axis)] += by;
  return cell;
}

class Lattice {
 public:
  explicit Lattice(int side) : side_(side), solid_(static_cast<std::size_t>(side * side * side)) {}

  bool solid(const Cell& c) const { return contains(c) && solid_[index(c)]; }
  /// Is there room for another cell on every side of it?
  bool is_inside(const Cell& c) const {
    return std::all_of(c.begin(), c.end(), [&](int x) { return x > 0 && x + 1 < side_; });
  }

  /// Makes a cell solid, unless the surface would touch itself in an edge or a vertex.
  bool add(const Cell& c) {
    solid_[index(c)] = true;
    for (int corner = 0; corner < 8; ++corner)
      if (!is_one_sheet_at({c[0] + (corner & 1), c[1] + (corner >> 1 & 1), c[2] + (corner >> 2)})) {
        solid_[index(c)] = false;
        return false;
      }
    return true;
  }

 private:
  bool contains(const Cell& c) const {
    return std::all_of(c.begin(), c.end(), [&](int x) { return x >= 0 && x < side_; });
  }
  std::size_t index(const Cell& c) const {
    const auto side = static_cast<std::size_t>(side_);
    return (static_cast<std::size_t>(c[2]) * side + static_cast<std::size_t>(c[1])) * side +
           static_cast<std::size_t>(c[0]);
  }

  /// Around a vertex the surface is one sheet if the solid ones of the eight cells are connected by faces,
  /// and the empty ones, too.
  bool is_one_sheet_at(const Cell& vertex) const {
    std::array<bool, 8> kind{}, seen{};
    for (int i = 0; i < 8; ++i)
      kind[static_cast<std::size_t>(i)] =
          solid({vertex[0] - 1 + (i & 1), vertex[1] - 1 + (i >> 1 & 1), vertex[2] - 1 + (i >> 2)});
    int groups = 0, kinds = 0;
    for (const bool wanted : {false, true}) {
      bool any = false;
      for (std::size_t first = 0; first < 8; ++first) {
        if (kind[first] != wanted) continue;
        any = true;
        if (seen[first]) continue;
        ++groups;
        std::vector<std::size_t> going{first};
        seen[first] = true;
        while (!going.empty()) {
          const std::size_t at = going.back();
          going.pop_back();
          for (const std::size_t axis : {1u, 2u, 4u}) {
            const std::size_t next = at ^ axis;
            if (kind[next] != wanted || seen[next]) continue;
            seen[next] = true;
            going.push_back(next);
          }
        }
      }
      kinds += any;
    }
    return groups == kinds;
  }

  int side_;
  std::vector<bool> solid_;
};

/// The four corners of the face of a cell towards `by` along an axis, anticlockwise seen from there.
std::array<Cell, 4> face_corners(const Cell& c, int axis, int by) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Cell base = c;
  if (by > 0) base = moved(base, axis, 1);
  std::array<Cell, 4> corners{base, moved(base, u, 1), moved(moved(base, u, 1), v, 1), moved(base, v, 1)};
  if (by < 0) std::swap(corners[1], corners[3]);
  return corners;
}

}  // namespace

Mesh make_cells(int count, std::uint64_t seed) {
  survey::Random random(seed);
  const int side = std::min(2 * count + 3, kLargestSide), middle = side / 2;
  Lattice lattice(side);
  std::vector<Cell> cells{{middle, middle, middle}};
  lattice.add(cells.front());
  while (static_cast<int>(cells.size()) < count) {
    const Cell& beside = cells[random.below(cells.size())];
    const int axis = static_cast<int>(random.below(3));
    const Cell next = moved(beside, axis, random.below(2) == 0 ? -1 : 1);
    if (!lattice.is_inside(next) || lattice.solid(next) || !lattice.add(next)) continue;
    cells.push_back(next);
  }
  const auto shear = [&] { return (static_cast<double>(random.below(49)) - 24) / 64; };
  const Vector3d along_x(1, 0, 0), along_y(shear(), 1, 0), along_z(shear(), shear(), 1);

  std::vector<Vector3d> vertices;
  std::vector<std::vector<int>> quads;
  for (const Cell& cell : cells)
    for (int axis = 0; axis < 3; ++axis)
      for (const int by : {-1, 1}) {
        if (lattice.solid(moved(cell, axis, by))) continue;
        auto& quad = quads.emplace_back();
        for (const Cell& corner : face_corners(cell, axis, by)) {
          quad.push_back(static_cast<int>(vertices.size()));
          vertices.emplace_back((corner[0] - middle) * along_x + (corner[1] - middle) * along_y +
                                (corner[2] - middle) * along_z);
        }
      }
  return make_mesh(vertices, quads);
}

}  // namespace limpet::simulation
