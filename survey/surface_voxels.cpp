// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/surface_voxels.hpp>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace limpet::survey {
namespace {

constexpr double kFewestOwn = 8, kFewestAround = 4;  ///< points for a normal
constexpr double kThin = 0.2;   ///< thickness over width below which a patch is a plane's
constexpr double kWide = 0.12;  ///< standard deviation over voxel edge, in the plane
constexpr double kShift =
    0.381966;  ///< of the grid, in edges: planes at round coordinates are not cut in two

}  // namespace

void SurfaceVoxels::Moments::add(const Moments& other, const Eigen::Vector3d& offset) {
  count += other.count;
  sum += other.sum + other.count * offset;
  squares += other.squares + other.sum * offset.transpose() + offset * other.sum.transpose() +
             other.count * offset * offset.transpose();
}

std::size_t SurfaceVoxels::Hash::operator()(const VoxelKey& key) const {
  std::uint64_t hash = 0;
  for (const std::int32_t k : key) hash = (hash ^ static_cast<std::uint32_t>(k)) * 0x9e3779b97f4a7c15u;
  return hash ^ (hash >> 29);
}

std::optional<VoxelKey> SurfaceVoxels::key_of(const Eigen::Vector3d& point) const {
  VoxelKey key;
  for (int i = 0; i < 3; ++i) {
    const double at = std::floor(point[i] / edge_ + kShift);
    if (!(std::abs(at) < (1 << 30))) return std::nullopt;
    key[i] = static_cast<std::int32_t>(at);
  }
  return key;
}

Eigen::Vector3d SurfaceVoxels::centre_of(const VoxelKey& key) const {
  return edge_ * (Eigen::Vector3d(key[0], key[1], key[2]).array() + (0.5 - kShift)).matrix();
}

void SurfaceVoxels::add(const Eigen::Vector3d& point) {
  const auto key = key_of(point);
  if (!key) return;
  const auto [place, is_new] = places_.try_emplace(*key, size());
  if (is_new) {
    keys_.push_back(*key);
    moments_.emplace_back();
  }
  Moments& moments = moments_[place->second];
  const Eigen::Vector3d offset = point - centre_of(*key);
  moments.count += 1;
  moments.sum += offset;
  moments.squares += offset * offset.transpose();
}

int SurfaceVoxels::find(const VoxelKey& key) const {
  const auto place = places_.find(key);
  return place == places_.end() ? -1 : place->second;
}

int SurfaceVoxels::find_point(const Eigen::Vector3d& point) const {
  const auto key = key_of(point);
  return key ? find(*key) : -1;
}

SurfaceVoxels::Moments SurfaceVoxels::around(int voxel) const {
  Moments all;
  for (std::int32_t x = -1; x <= 1; ++x) {
    for (std::int32_t y = -1; y <= 1; ++y) {
      for (std::int32_t z = -1; z <= 1; ++z) {
        const VoxelKey& own = keys_[voxel];
        const int other = find({own[0] + x, own[1] + y, own[2] + z});
        if (other >= 0) all.add(moments_[other], edge_ * Eigen::Vector3d(x, y, z));
      }
    }
  }
  return all;
}

SurfacePatch SurfaceVoxels::patch_of(const Moments& moments, const Eigen::Vector3d& centre,
                                     double fewest) const {
  SurfacePatch patch;
  const Eigen::Vector3d mean = moments.sum / moments.count;
  patch.centroid = centre + mean;
  if (moments.count < fewest) return patch;
  const Eigen::Matrix3d covariance = moments.squares / moments.count - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d deviations = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  if (!(deviations[1] > 1e-6 * edge_)) return patch;  // one place, or a line
  patch.normal = solver.eigenvectors().col(0);
  patch.flat = deviations[0] <= kThin * deviations[1] && deviations[1] >= kWide * edge_;
  return patch;
}

void SurfaceVoxels::fit() {
  std::vector<int> order(keys_.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return keys_[a] < keys_[b]; });
  std::vector<VoxelKey> keys(keys_.size());
  std::vector<Moments> moments(keys_.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    keys[i] = keys_[order[i]];
    moments[i] = moments_[order[i]];
    places_[keys[i]] = static_cast<int>(i);
  }
  keys_.swap(keys);
  moments_.swap(moments);
  patches_.resize(keys_.size());
  for (int i = 0; i < size(); ++i) {
    patches_[i] = patch_of(moments_[i], centre_of(keys_[i]), kFewestOwn);
    if (!patches_[i].flat) {
      const Eigen::Vector3d own_centroid = patches_[i].centroid;
      const SurfacePatch wider = patch_of(around(i), centre_of(keys_[i]), kFewestAround);
      // A wider plane that passes by the voxel's own points is not theirs.
      const bool near = std::abs((own_centroid - wider.centroid).dot(wider.normal)) < 0.3 * edge_;
      patches_[i] = {own_centroid, wider.normal, wider.flat && near};
    }
  }
  moments_.clear();
  moments_.shrink_to_fit();
}

}  // namespace limpet::survey
