// Copyright the limpet authors. GPL-3.0-or-later.
//
// Solids to be followed: of boxes, with faces at odd angles, and with curved surfaces cut into facets.
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limpet/simulation/box_world.hpp>
#include <limpet/simulation/shapes_internal.hpp>
#include <numbers>
#include <vector>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

}  // namespace

Mesh make_slab() {
  BoxWorld world;
  world.add({0, 0, 0}, {1.5, 1, 0.5});
  return world.surface();
}

Mesh make_staircase() {
  BoxWorld world;
  world.add({0, 0, 0}, {1.5, 1, 0.5});
  world.add({0, 0, 0.5}, {1, 1, 1});
  world.add({0, 0, 1}, {0.5, 1, 1.5});
  return world.surface();
}

Mesh make_notch() {
  BoxWorld world;
  world.add({0, 0, 0}, {1.5, 1, 1});
  world.carve({0.5, 0, 0.5}, {1, 1, 1});
  return world.surface();
}

Mesh make_cross() {
  BoxWorld world;
  world.add({0, 0.5, 0}, {1.5, 1, 0.5});
  world.add({0.5, 0, 0}, {1, 1.5, 0.5});
  return world.surface();
}

Mesh make_icosahedron() {
  const double g = std::numbers::phi;
  std::vector<Vector3d> v;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-g, g}) {
      v.emplace_back(0, a, b), v.emplace_back(a, b, 0), v.emplace_back(b, 0, a);
    }
  const auto joined = [&](int a, int b) { return std::abs((v[a] - v[b]).norm() - 2) < 1e-6; };
  std::vector<std::vector<int>> faces;
  for (int i = 0; i < 12; ++i)
    for (int j = i + 1; j < 12; ++j)
      for (int k = i + 1; k < 12; ++k)
        if (joined(i, j) && joined(j, k) && joined(k, i) && (v[j] - v[i]).cross(v[k] - v[i]).dot(v[i]) > 0)
          faces.push_back({i, j, k});
  for (Vector3d& p : v) p *= 0.5;  // edges of length 1
  return make_mesh(v, faces);
}

Mesh make_sphere(int meridians) {
  const int parallels = meridians / 2;
  std::vector<Vector3d> v{{0, 0, -0.5}};
  for (int row = 1; row < parallels; ++row)
    for (int column = 0; column < meridians; ++column) {
      const double up = kPi * row / parallels, round = 2 * kPi * column / meridians;
      v.emplace_back(0.5 * std::sin(up) * std::cos(round), 0.5 * std::sin(up) * std::sin(round),
                     -0.5 * std::cos(up));
    }
  v.emplace_back(0, 0, 0.5);
  const int last = static_cast<int>(v.size()) - 1;
  const auto at = [&](int row, int column) { return 1 + (row - 1) * meridians + column % meridians; };
  std::vector<std::vector<int>> faces;
  for (int c = 0; c < meridians; ++c) {
    faces.push_back({0, at(1, c + 1), at(1, c)});
    for (int row = 1; row + 1 < parallels; ++row)
      faces.push_back({at(row, c), at(row, c + 1), at(row + 1, c + 1), at(row + 1, c)});
    faces.push_back({last, at(parallels - 1, c), at(parallels - 1, c + 1)});
  }
  return make_mesh(v, faces);
}

Mesh make_drum(int sides) {
  const double size = 1, height = 0.375, top = 0.875, radius = 0.3125;
  std::vector<Vector3d> v;
  for (const double z : {0.0, height})
    for (const auto& [x, y] : {std::array{size, size}, {0.0, size}, {0.0, 0.0}, {size, 0.0}})
      v.emplace_back(x, y, z);
  for (const double z : {height, top})
    for (int i = 0; i < sides; ++i) {
      const double round = 2 * kPi * i / sides;
      v.emplace_back(size / 2 + radius * std::cos(round), size / 2 + radius * std::sin(round), z);
    }
  const auto low = [&](int i) { return 8 + i % sides; };
  const auto high = [&](int i) { return 8 + sides + i % sides; };
  std::vector<std::vector<int>> faces{{3, 2, 1, 0}};
  for (int k = 0; k < 4; ++k) {
    const int corner = 4 + k, next = 4 + (k + 1) % 4, from = k * sides / 4, to = (k + 1) * sides / 4;
    faces.push_back({k, (k + 1) % 4, next, corner});
    // The block's top, round the drum: between each corner and the quarter that it sees.
    for (int i = from; i < to; ++i) faces.push_back({corner, low(i + 1), low(i)});
    faces.push_back({corner, next, low(to)});
  }
  std::vector<int> lid;
  for (int i = 0; i < sides; ++i) {
    faces.push_back({low(i), low(i + 1), high(i + 1), high(i)});
    lid.push_back(high(i));
  }
  faces.push_back(lid);
  return make_mesh(v, faces);
}

}  // namespace limpet::simulation
