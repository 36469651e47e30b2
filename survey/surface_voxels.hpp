// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace limpet::survey {

/// Place of a voxel in its grid.
using VoxelKey = std::array<std::int32_t, 3>;

/// What the points in a voxel, or in it and around it, look like.
struct SurfacePatch {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of either sign; zero: too few points to tell
  bool flat = false;                                 ///< a piece of plane, wide enough to know its normal
  bool has_normal() const { return !normal.isZero(); }
};

/// The surface of a cloud as the voxels that hold points, with the moments of these: memory goes with the
/// surface's area over edge², not with the number of points. The order of adding changes rounding alone.
class SurfaceVoxels {
 public:
  /// `edge` of a voxel, scan's unit. A dozen points in a voxel make good normals. Precondition: edge > 0.
  explicit SurfaceVoxels(double edge) : edge_(edge) {}

  /// Points too far out for the grid (2³⁰ voxels) are left out.
  void add(const Eigen::Vector3d& point);

  /// Fits the patches, to each voxel's own points where these are enough and lie in a plane, else with those
  /// of the 26 voxels around. Nothing may be added afterwards.
  void fit();

  double edge() const { return edge_; }
  /// Voxels are numbered by place, so that nothing depends on hashing.
  int size() const { return static_cast<int>(keys_.size()); }
  const VoxelKey& key(int voxel) const { return keys_[voxel]; }
  const SurfacePatch& patch(int voxel) const { return patches_[voxel]; }
  /// -1: no points there.
  int find(const VoxelKey& key) const;
  int find_point(const Eigen::Vector3d& point) const;

 private:
  /// Sums over points, as offsets from the voxel's centre.
  struct Moments {
    double count = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    void add(const Moments& other, const Eigen::Vector3d& offset);
  };
  struct Hash {
    std::size_t operator()(const VoxelKey& key) const;
  };

  std::optional<VoxelKey> key_of(const Eigen::Vector3d& point) const;
  Eigen::Vector3d centre_of(const VoxelKey& key) const;
  SurfacePatch patch_of(const Moments& moments, const Eigen::Vector3d& centre, double fewest) const;
  Moments around(int voxel) const;

  double edge_;
  std::unordered_map<VoxelKey, int, Hash> places_;
  std::vector<VoxelKey> keys_;
  std::vector<Moments> moments_;
  std::vector<SurfacePatch> patches_;
};

}  // namespace limpet::survey
