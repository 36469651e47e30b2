// Copyright the limpet authors. GPL-3.0-or-later.
//
// Random lattice polyhedra: cells joined by their faces, sheared. Some of their vertices have four faces, of
// which two lie in one plane, or six, of which pairs lie in one plane and touch in that vertex only.
#include <array>
#include <limpet/simulation/box_world.hpp>
#include <limpet/simulation/shapes_internal.hpp>
#include <limpet/survey/random.hpp>
#include <set>
#include <vector>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;
using Cell = std::array<int, 3>;

/// Of the eight cells round a vertex, a bit each (x, y and z are the bits of its number): those that are
/// connected by faces with the first of `cells`, within these.
unsigned connected(unsigned cells) {
  unsigned group = cells & (~cells + 1);
  for (unsigned before = 0; group != before;) {
    before = group;
    const unsigned beside = (group & 0x55) << 1 | (group & 0xaa) >> 1 | (group & 0x33) << 2 |
                            (group & 0xcc) >> 2 | (group & 0x0f) << 4 | (group & 0xf0) >> 4;
    group |= beside & cells;
  }
  return group;
}

/// Does the surface of the solid cells pass a vertex in one sheet, or not at all?
bool is_one_sheet(const std::set<Cell>& solid, const Cell& vertex) {
  unsigned cells = 0;
  for (int i = 0; i < 8; ++i)
    if (solid.contains({vertex[0] - 1 + (i & 1), vertex[1] - 1 + (i >> 1 & 1), vertex[2] - 1 + (i >> 2)}))
      cells |= 1u << i;
  const unsigned empty = ~cells & 0xff;
  return connected(cells) == cells && connected(empty) == empty;
}

/// Makes a cell solid, unless the surface would touch itself in an edge or a vertex.
bool add(std::set<Cell>& solid, const Cell& c) {
  if (!solid.insert(c).second) return false;
  for (int i = 0; i < 8; ++i)
    if (!is_one_sheet(solid, {c[0] + (i & 1), c[1] + (i >> 1 & 1), c[2] + (i >> 2)})) {
      solid.erase(c);
      return false;
    }
  return true;
}

}  // namespace

Mesh make_cells(int count, std::uint64_t seed) {
  survey::Random random(seed);
  std::vector<Cell> cells{{0, 0, 0}};
  std::set<Cell> solid{cells.front()};
  while (static_cast<int>(cells.size()) < count) {
    Cell next = cells[random.below(cells.size())];
    const auto axis = random.below(3);
    next[axis] += random.below(2) == 0 ? -1 : 1;
    if (add(solid, next)) cells.push_back(next);
  }
  BoxWorld world;
  for (const Cell& c : cells) world.add(Vector3d(c[0], c[1], c[2]), Vector3d(c[0] + 1, c[1] + 1, c[2] + 1));
  Mesh mesh = world.surface();
  const auto shear = [&] { return (static_cast<double>(random.below(49)) - 24) / 64; };
  const double xy = shear(), xz = shear(), yz = shear();
  for (Vector3d& p : mesh.vertices) p = Vector3d(p.x() + xy * p.y() + xz * p.z(), p.y() + yz * p.z(), p.z());
  return mesh;
}

}  // namespace limpet::simulation
