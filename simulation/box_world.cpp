// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <array>
#include <limpet/simulation/box_world.hpp>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;
using Cell = std::array<int, 3>;

int index_of(const std::vector<double>& ticks, double x) {
  return static_cast<int>(std::lower_bound(ticks.begin(), ticks.end(), x) - ticks.begin());
}

}  // namespace

Mesh BoxWorld::surface(const Filter& keep) const {
  std::array<std::vector<double>, 3> ticks;
  for (int k = 0; k < 3; ++k) {
    for (const Box& box : boxes_) {
      ticks[k].push_back(box.low[k]);
      ticks[k].push_back(box.high[k]);
    }
    std::sort(ticks[k].begin(), ticks[k].end());
    ticks[k].erase(std::unique(ticks[k].begin(), ticks[k].end()), ticks[k].end());
  }
  const auto number = [&ticks](const Cell& at) {  // of a grid corner, and of the cell above it
    return (at[2] * static_cast<int>(ticks[1].size()) + at[1]) * static_cast<int>(ticks[0].size()) + at[0];
  };
  const auto corner = [&ticks](const Cell& at) {
    return Vector3d(ticks[0][at[0]], ticks[1][at[1]], ticks[2][at[2]]);
  };

  std::vector<char> solid(ticks[0].size() * ticks[1].size() * ticks[2].size(), 0);
  for (const Box& box : boxes_) {
    Cell low, high;
    for (int k = 0; k < 3; ++k) {
      low[k] = index_of(ticks[k], box.low[k]);
      high[k] = index_of(ticks[k], box.high[k]);
    }
    for (int z = low[2]; z < high[2]; ++z)
      for (int y = low[1]; y < high[1]; ++y)
        for (int x = low[0]; x < high[0]; ++x) solid[number({x, y, z})] = box.solid;
  }

  std::vector<Vector3d> vertices;
  std::vector<std::vector<int>> quads;
  std::vector<int> vertex_at(solid.size(), -1);
  const auto vertex = [&](const Cell& at) {
    int& v = vertex_at[number(at)];
    if (v < 0) {
      v = static_cast<int>(vertices.size());
      vertices.push_back(corner(at));
    }
    return v;
  };
  // Face by face of the grid: the side below cell `at` in direction k, if solid and empty meet there.
  for (int k = 0; k < 3; ++k) {
    const int u = (k + 1) % 3, v = (k + 2) % 3;
    Cell at{};
    for (at[v] = 0; at[v] + 1 < static_cast<int>(ticks[v].size()); ++at[v]) {
      for (at[u] = 0; at[u] + 1 < static_cast<int>(ticks[u].size()); ++at[u]) {
        for (at[k] = 0; at[k] < static_cast<int>(ticks[k].size()); ++at[k]) {
          Cell below = at, along_u = at, along_v = at, across = at;
          --below[k];
          ++along_u[u], ++along_v[v], ++across[u], ++across[v];
          const bool is_solid = at[k] + 1 < static_cast<int>(ticks[k].size()) && solid[number(at)];
          const bool is_solid_below = at[k] > 0 && solid[number(below)];
          if (is_solid == is_solid_below) continue;
          Vector3d normal = Vector3d::Zero();
          normal[k] = is_solid_below ? 1 : -1;
          if (keep && !keep((corner(at) + corner(across)) / 2, normal)) continue;
          if (is_solid_below)
            quads.push_back({vertex(at), vertex(along_u), vertex(across), vertex(along_v)});
          else
            quads.push_back({vertex(at), vertex(along_v), vertex(across), vertex(along_u)});
        }
      }
    }
  }
  return make_mesh(vertices, quads);
}

}  // namespace limpet::simulation
