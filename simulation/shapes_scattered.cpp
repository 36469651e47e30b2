// Copyright the limpet authors. GPL-3.0-or-later.
#include <array>
#include <cmath>
#include <limpet/simulation/box_world.hpp>
#include <limpet/simulation/shapes_internal.hpp>
#include <limpet/survey/random.hpp>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;

/// Coordinates are whole numbers of 1/64 until the end, so equal means equal.
constexpr double kUnit = 1.0 / 64;

int between(survey::Random& random, int low, int high) {
  return low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low) + 1));
}

Vector3d point(int x, int y, int z) { return kUnit * Vector3d(x, y, z); }

/// A box on the floor and perhaps a smaller one on top of it, in from the lower one's sides but where that
/// side is a wall.
void add_furniture(BoxWorld& world, survey::Random& random, const std::array<int, 4>& footprint, int length,
                   int width) {
  const auto [x0, y0, x1, y1] = footprint;
  const int height = between(random, 26, 70);
  world.add(point(x0, y0, 0), point(x1, y1, height));
  const int top_x0 = x0 == 0 ? 0 : x0 + between(random, 16, 18);
  const int top_y0 = y0 == 0 ? 0 : y0 + between(random, 16, 18);
  const int top_x1 = x1 == length ? length : x1 - between(random, 16, 18);
  const int top_y1 = y1 == width ? width : y1 - between(random, 16, 18);
  const int top_height = between(random, 20, 50);
  if (random.uniform() < 0.75)
    world.add(point(top_x0, top_y0, height), point(top_x1, top_y1, height + top_height));
}

}  // namespace

Mesh make_room(std::uint64_t seed, int columns, int rows) {
  survey::Random random(seed);
  const int cell = static_cast<int>(kRoomCell / kUnit), height = static_cast<int>(kRoomHeight / kUnit);
  const int length = columns * cell, width = rows * cell, wall = 64;
  BoxWorld world;
  world.add(point(-wall, -wall, -wall), point(length + wall, width + wall, height + wall));
  world.carve(point(0, 0, 0), point(length, width, height));
  // One piece of furniture in each cell of a grid, with an aisle around it. Those in the outer cells stand
  // against their wall or well away from it; in the corners only against one of the two.
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const bool first_row = row == 0, last_row = row == rows - 1;
      const bool first_column = column == 0, last_column = column == columns - 1;
      const int gap_x0 = first_column ? between(random, 40, 50) : between(random, 16, 26);
      const int gap_x1 = last_column ? between(random, 40, 50) : between(random, 16, 26);
      const int gap_y0 = first_row ? between(random, 40, 50) : between(random, 16, 26);
      const int gap_y1 = last_row ? between(random, 40, 50) : between(random, 16, 26);
      std::array<int, 4> footprint{column * cell + gap_x0, row * cell + gap_y0, (column + 1) * cell - gap_x1,
                                   (row + 1) * cell - gap_y1};
      const bool at_wall = random.uniform() < 0.5;
      if (at_wall && first_row) footprint[1] = 0;
      if (at_wall && last_row) footprint[3] = width;
      if (at_wall && !first_row && !last_row && first_column) footprint[0] = 0;
      if (at_wall && !first_row && !last_row && last_column) footprint[2] = length;
      add_furniture(world, random, footprint, length, width);
    }
  }
  return world.surface([&](const Vector3d& middle, const Vector3d&) {
    return (middle.array() > -wall * kUnit).all() && middle.x() < (length + wall) * kUnit &&
           middle.y() < (width + wall) * kUnit && middle.z() < (height + wall) * kUnit;
  });
}

Mesh make_city(int boxes, std::uint64_t seed) {
  survey::Random random(seed);
  const int pitch = 136;
  const int columns = static_cast<int>(std::ceil(std::sqrt(boxes))), rows = (boxes + columns - 1) / columns;
  std::vector<Vector3d> vertices;
  std::vector<std::vector<int>> quads;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column)
      vertices.push_back(point(column * pitch, row * pitch, 0));

  for (int cell = 0; cell < rows * columns; ++cell) {
    const int row = cell / columns, column = cell % columns;
    const int corner = row * (columns + 1) + column;
    const int ground[4] = {corner, corner + 1, corner + columns + 2, corner + columns + 1};
    if (cell >= boxes) {
      quads.push_back({ground[0], ground[1], ground[2], ground[3]});
      continue;
    }
    const int size_x = between(random, 52, 76), size_y = between(random, 52, 76);
    const int height = between(random, 32, 96);
    const int x0 = column * pitch + (pitch - size_x) / 2 + between(random, -10, 10);
    const int y0 = row * pitch + (pitch - size_y) / 2 + between(random, -10, 10);
    const int base = static_cast<int>(vertices.size());
    for (const int z : {0, height}) {
      vertices.push_back(point(x0, y0, z));
      vertices.push_back(point(x0 + size_x, y0, z));
      vertices.push_back(point(x0 + size_x, y0 + size_y, z));
      vertices.push_back(point(x0, y0 + size_y, z));
    }
    for (int side = 0; side < 4; ++side) {
      const int next = (side + 1) % 4;
      quads.push_back({ground[side], ground[next], base + next, base + side});        // ground around the box
      quads.push_back({base + side, base + next, base + 4 + next, base + 4 + side});  // the box's side
    }
    quads.push_back({base + 4, base + 5, base + 6, base + 7});
  }
  return make_mesh(vertices, quads);
}

}  // namespace limpet::simulation
