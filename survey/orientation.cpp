// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/orientation.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <limpet/survey/signed_forest.hpp>

namespace limpet::survey {
namespace {

constexpr double kSmooth = 0.9;    ///< cosine above which two normals are of one smooth surface (26°)
constexpr double kRound = 0.1;     ///< weight of a vote by a patch that is not flat
constexpr double kCrease = 0.5;    ///< weight of a vote across an edge
constexpr double kOnPlane = 0.15;  ///< in voxel edges: a point that is no farther off a plane may lie on it
constexpr double kOneSide =
    0.2;  ///< mean cosine above which the top (or the sides) of a component tell its outside

/// How sure it is that the normals agree as they are (positive) or that one has to be turned (negative), in
/// -1..1.
double vote(const SurfacePatch& a, const SurfacePatch& b, double edge) {
  const Eigen::Vector3d way = b.centroid - a.centroid;
  const double cosine = a.normal.dot(b.normal);
  const double above_a = way.dot(a.normal), above_b = -way.dot(b.normal);
  const double weight = a.flat && b.flat ? 1 : kRound;
  if (std::abs(cosine) > kSmooth) {
    // On one surface, each is off the other's plane by no more than the bend between them explains; two
    // sheets side by side, or a step, say nothing.
    const double bend = way.norm() * std::sqrt((1 - std::min(std::abs(cosine), 1.0)) / 2);
    const double off = std::max(std::abs(above_a), std::abs(above_b)) - bend;
    return std::copysign(weight * std::clamp(1 - off / (0.3 * edge), 0.0, 1.0), cosine);
  }
  if (weight < 1) return kRound * cosine;
  const double clear = std::min(std::abs(above_a), std::abs(above_b)) / (0.5 * edge);
  if (clear < 0.4) return 0;
  return std::copysign(kCrease * std::min(clear, 1.0), above_a * above_b);
}

/// All pairs of voxels at most two apart, each once.
template <class Take>
void for_each_link(const SurfaceVoxels& voxels, Take&& take) {
  for (int i = 0; i < voxels.size(); ++i) {
    if (!voxels.patch(i).has_normal()) continue;
    const VoxelKey& key = voxels.key(i);
    for (std::int32_t x = 0; x <= 2; ++x) {
      for (std::int32_t y = x > 0 ? -2 : 0; y <= 2; ++y) {
        for (std::int32_t z = x > 0 || y > 0 ? -2 : 1; z <= 2; ++z) {
          const int j = voxels.find({key[0] + x, key[1] + y, key[2] + z});
          if (j >= 0 && voxels.patch(j).has_normal()) take(i, j);
        }
      }
    }
  }
}

/// The voxels around a place, and in it, as far as `reach`.
template <class Take>
void for_each_around(const SurfaceVoxels& voxels, const VoxelKey& key, int reach, Take&& take) {
  for (std::int32_t x = -reach; x <= reach; ++x) {
    for (std::int32_t y = -reach; y <= reach; ++y) {
      for (std::int32_t z = -reach; z <= reach; ++z) {
        const int voxel = voxels.find({key[0] + x, key[1] + y, key[2] + z});
        if (voxel >= 0) take(voxel);
      }
    }
  }
}

bool touch(const VoxelKey& a, const VoxelKey& b) {
  return std::abs(a[0] - b[0]) <= 1 && std::abs(a[1] - b[1]) <= 1 && std::abs(a[2] - b[2]) <= 1;
}

/// The mean of n·direction over the voxels of a component that lie farthest that way.
double facing(const std::vector<int>& members, const SurfaceVoxels& voxels,
              const std::vector<Eigen::Vector3d>& normals, const Eigen::Vector3d& direction) {
  std::vector<std::pair<double, int>> heights;
  for (const int voxel : members) heights.emplace_back(-voxels.patch(voxel).centroid.dot(direction), voxel);
  const std::size_t count = std::min(heights.size(), std::max<std::size_t>(3, heights.size() / 100));
  std::nth_element(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(count - 1), heights.end());
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += normals[heights[i].second].dot(direction);
  return sum / static_cast<double>(count);
}

}  // namespace

double Orientation::suitable_edge(double area_per_point, double noise, double resolution) {
  const double edge = std::max({std::sqrt(11 * area_per_point), 7 * noise, resolution / 2});
  return area_per_point > 0 ? edge : resolution;
}

void Orientation::solve() {
  voxels_.fit();
  SignedForest forest(voxels_.size());
  for_each_link(voxels_, [&](int i, int j) {
    const SurfacePatch &a = voxels_.patch(i), &b = voxels_.patch(j);
    // Between patches that are not flat there are many weak votes; those of touching voxels suffice.
    if ((a.flat && b.flat) || touch(voxels_.key(i), voxels_.key(j)))
      forest.vote(i, j, vote(a, b, voxels_.edge()));
  });
  forest.solve();
  normals_.assign(static_cast<std::size_t>(voxels_.size()), Eigen::Vector3d::Zero());
  for (int i = 0; i < voxels_.size(); ++i) normals_[i] = forest.sign(i) * voxels_.patch(i).normal;

  std::vector<std::vector<int>> members(static_cast<std::size_t>(voxels_.size()));
  for (int i = 0; i < voxels_.size(); ++i) {
    if (voxels_.patch(i).has_normal()) members[forest.component(i)].push_back(i);
  }
  for (const std::vector<int>& component : members) {
    if (component.empty()) continue;
    components_ += component.size() >= 10;
    turn(component);
  }
  find_creases();
}

void Orientation::turn(const std::vector<int>& component) {
  std::vector<int> flat;
  for (const int voxel : component) {
    if (voxels_.patch(voxel).flat) flat.push_back(voxel);
  }
  const std::vector<int>& tellers = 2 * flat.size() < component.size() ? component : flat;
  double outward = facing(tellers, voxels_, normals_, Eigen::Vector3d::UnitZ());
  if (std::abs(outward) < kOneSide) {
    outward = 0;
    for (const double side : {1.0, -1.0}) {
      outward += facing(tellers, voxels_, normals_, side * Eigen::Vector3d::UnitX());
      outward += facing(tellers, voxels_, normals_, side * Eigen::Vector3d::UnitY());
    }
  }
  if (outward >= 0) return;
  for (const int voxel : component) normals_[voxel] = -normals_[voxel];
}

void Orientation::find_creases() {
  creases_.assign(static_cast<std::size_t>(voxels_.size()), {});
  for (int i = 0; i < voxels_.size(); ++i) {
    bool is_crease = !voxels_.patch(i).flat;
    for_each_around(voxels_, voxels_.key(i), 1, [&](int j) {
      is_crease |= !voxels_.patch(j).flat || normals_[j].dot(normals_[i]) < kSmooth;
    });
    if (!is_crease) continue;
    Crease& crease = creases_[i];
    crease.begin = static_cast<std::int64_t>(planes_.size());
    for_each_around(voxels_, voxels_.key(i), 1, [&](int j) {
      if (voxels_.patch(j).flat) planes_.push_back(j);
    });
    crease.near_end = static_cast<std::int64_t>(planes_.size());
    for_each_around(voxels_, voxels_.key(i), 2, [&](int j) {
      if (voxels_.patch(j).flat && !touch(voxels_.key(i), voxels_.key(j))) planes_.push_back(j);
    });
    crease.end = static_cast<std::int64_t>(planes_.size());
  }
}

int Orientation::nearest_plane(const Eigen::Vector3d& point, std::int64_t begin, std::int64_t end,
                               const Eigen::Vector3d& unlike) const {
  std::pair<double, int> best = {std::numeric_limits<double>::infinity(), -1};
  for (std::int64_t i = begin; i < end; ++i) {
    const int voxel = planes_[static_cast<std::size_t>(i)];
    if (normals_[voxel].dot(unlike) > kSmooth) continue;
    const double distance = (point - voxels_.patch(voxel).centroid).norm() / voxels_.edge();
    best = std::min(best, {off_plane(point, voxel) + 0.1 * distance, voxel});
  }
  return best.second;
}

/// The distance of a point from a voxel's plane, in voxel edges.
double Orientation::off_plane(const Eigen::Vector3d& point, int voxel) const {
  return std::abs((point - voxels_.patch(voxel).centroid).dot(normals_[voxel])) / voxels_.edge();
}

Eigen::Vector3d Orientation::normal_at(const Eigen::Vector3d& point) const {
  const int own = voxels_.find_point(point);
  if (own < 0) return Eigen::Vector3d::UnitZ();
  const Crease& crease = creases_[own];
  if (!crease.is_one()) return normals_[own];
  // Of the planes around, the one the point lies on; where it lies on two, between them.
  std::int64_t end = crease.near_end;
  int first = nearest_plane(point, crease.begin, end, Eigen::Vector3d::Zero());
  if (first < 0 || off_plane(point, first) > kOnPlane) {
    end = crease.end;
    first = nearest_plane(point, crease.begin, end, Eigen::Vector3d::Zero());
  }
  if (first < 0) return normals_[own].isZero() ? Eigen::Vector3d(Eigen::Vector3d::UnitZ()) : normals_[own];
  const Eigen::Vector3d& normal = normals_[first];
  const int second = nearest_plane(point, crease.begin, end, normal);
  if (second < 0 || off_plane(point, second) > kOnPlane) return normal;
  const Eigen::Vector3d between = normal + normals_[second];
  return between.norm() > 0.1 ? Eigen::Vector3d(between.normalized()) : normal;
}

}  // namespace limpet::survey
