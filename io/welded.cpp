// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limpet/io/welded.hpp>
#include <numeric>
#include <unordered_map>

namespace limpet::io {
namespace {

/// Sets of vertices that are one, each named by its lowest member.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int vertex) {
    while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
    return vertex;
  }

  void join(int a, int b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

struct EdgeEnds {
  int from, to;
};

/// All vertices of all cycles in a row, and the ends of every edge.
struct Row {
  std::vector<Eigen::Vector3d> at;
  std::vector<int> polygon;
  std::vector<std::uint64_t> partner;
  std::vector<EdgeEnds> ends;
  std::unordered_map<std::uint64_t, int> edge_at;  ///< edge identity to index
};

Row collect(const std::vector<LiftedPolygon>& polygons) {
  Row row;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    for (const LiftedCycle& cycle : polygons[p].cycles) {
      const int begin = static_cast<int>(row.at.size()), size = static_cast<int>(cycle.size());
      for (int i = 0; i < size; ++i) {
        row.at.push_back(cycle[i].at);
        row.polygon.push_back(static_cast<int>(p));
        row.partner.push_back(cycle[i].partner);
        row.ends.push_back({begin + i, begin + (i + 1) % size});
        row.edge_at.emplace(cycle[i].edge, begin + i);
      }
    }
  }
  return row;
}

Sets joined(const Row& row, double reach) {
  Sets sets(row.at.size());
  const auto join = [&](int a, int b) {
    if ((row.at[a] - row.at[b]).squaredNorm() <= reach * reach) sets.join(a, b);
  };
  for (std::size_t i = 0; i < row.ends.size(); ++i) {
    if (row.partner[i] == 0) continue;
    const auto partner = row.edge_at.find(row.partner[i]);
    if (partner == row.edge_at.end()) continue;
    join(row.ends[i].from, row.ends[partner->second].to);
    join(row.ends[i].to, row.ends[partner->second].from);
  }
  return sets;
}

/// Nearest to all planes; along directions that they hardly decide, at the mean of the copies.
Eigen::Vector3d corner_of(const std::vector<Eigen::Vector3d>& copies,
                          const std::vector<Eigen::Vector3d>& normals) {
  constexpr double kDecides = 1e-4;  // of the largest eigenvalue
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& copy : copies) mean += copy / static_cast<double>(copies.size());
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < copies.size(); ++i) {
    a += normals[i] * normals[i].transpose();
    b += normals[i].dot(copies[i] - mean) * normals[i];
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a);
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    if (solver.eigenvalues()[i] > kDecides * solver.eigenvalues()[2])
      offset += solver.eigenvectors().col(i).dot(b) / solver.eigenvalues()[i] * solver.eigenvectors().col(i);
  return mean + offset;
}

}  // namespace

WeldedVertices weld(const std::vector<LiftedPolygon>& polygons, double reach) {
  const Row row = collect(polygons);
  Sets sets = joined(row, reach);
  WeldedVertices result;
  std::vector<int> number(row.at.size(), -1);
  std::vector<std::vector<int>> members;
  for (int v = 0; v < static_cast<int>(row.at.size()); ++v) {
    int& of_set = number[sets.find(v)];
    if (of_set < 0) of_set = static_cast<int>(members.size()), members.emplace_back();
    members[of_set].push_back(v);
    result.welded.push_back(of_set);
  }
  for (const std::vector<int>& set : members) {
    std::vector<Eigen::Vector3d> copies, normals;
    std::vector<int> owners;
    for (const int v : set) {
      copies.push_back(row.at[v]);
      normals.push_back(polygons[row.polygon[v]].normal);
      owners.push_back(row.polygon[v]);
    }
    std::sort(owners.begin(), owners.end());
    const auto different = std::unique(owners.begin(), owners.end()) - owners.begin();
    result.at.push_back(different < 2 ? copies.front() : corner_of(copies, normals));
    if (different < 3) continue;
    ++result.corners;
    for (std::size_t i = 0; i < copies.size(); ++i)
      result.corner_distance =
          std::max(result.corner_distance, std::abs(normals[i].dot(result.at.back() - copies[i])));
  }
  return result;
}

}  // namespace limpet::io
