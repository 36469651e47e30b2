// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limpet/survey/surface_voxels.hpp>
#include <vector>

namespace limpet::survey {

/// Finds from which side the points of a cloud were sensed when nothing says so: two passes over the points,
/// memory by the surface alone.
///
/// Neighbouring voxels vote on whether their normals agree: where one surface goes on, by the normals'
/// product (Hoppe et al., "Surface reconstruction from unorganized points", SIGGRAPH 1992); where two planes
/// meet, by where the centroids lie, which holds at any angle: at a convex edge each centroid is behind the
/// other's plane, at a concave one before it. Voxels of one smooth piece are joined along a maximum spanning
/// forest of these votes; then pieces are joined by the sum of the votes across their seams, the clearest
/// first, sums added up as they join. Each component left is then turned as a whole: up at its top, else
/// outward at its sides; where it has neither (a single wall) its side is arbitrary. So what was scanned from
/// inside comes out inside out.
class Orientation {
 public:
  /// `edge` of a voxel, scan's unit: wide enough for a dozen points. Parts thinner than two edges may come
  /// out with both faces turned the same way. Precondition: edge > 0.
  explicit Orientation(double edge) : voxels_(edge) {}

  /// An edge that suits: eleven points to a voxel, wide over the noise, and no finer than half of λ, so that
  /// memory goes with the surface; all in scan's units, 0: not known.
  static double suitable_edge(double area_per_point, double noise, double resolution);

  /// First pass: all the points.
  void add(const Eigen::Vector3d& point) { voxels_.add(point); }

  /// Between the passes.
  void solve();

  /// Second pass: the sensing axis of a point, a unit vector into the surface. Where nothing is known,
  /// straight down.
  Eigen::Vector3d axis(const Eigen::Vector3d& point) const { return -normal_at(point); }

  /// Pieces of surface that nothing ties together, of ten voxels or more.
  int components() const { return components_; }

 private:
  /// Where not all around a voxel is of its own surface: the flat voxels that touch it, begin to near_end in
  /// planes_, and those one farther off, near_end to end.
  struct Crease {
    std::int64_t begin = -1, near_end = -1, end = -1;
    bool is_one() const { return begin >= 0; }
  };

  /// Turns a component outward as a whole.
  void turn(const std::vector<int>& component);
  void find_creases();
  Eigen::Vector3d normal_at(const Eigen::Vector3d& point) const;
  /// The voxel among some of planes_ on whose plane the point lies best, of those unlike a direction; -1:
  /// none.
  int nearest_plane(const Eigen::Vector3d& point, std::int64_t begin, std::int64_t end,
                    const Eigen::Vector3d& unlike) const;
  double off_plane(const Eigen::Vector3d& point, int voxel) const;

  SurfaceVoxels voxels_;
  std::vector<Eigen::Vector3d> normals_;  ///< by voxel, outward; zero: not known
  std::vector<Crease> creases_;           ///< by voxel
  std::vector<int> planes_;
  int components_ = 0;
};

}  // namespace limpet::survey
