// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limpet/survey/surface_voxels.hpp>
#include <vector>

namespace limpet::survey {

/// Finds the side from which each point of a cloud was sensed where the scan does not say it (consistent
/// orientation of normals). It takes two passes over the points; its memory grows with the area of the
/// surface, not with the number of points.
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
  /// A voxel near an edge of the surface holds points of several planes. These are the flat voxels around it,
  /// whose planes its points may lie on, as ranges of planes_: from begin to near_end those that touch it,
  /// from there to end those one voxel farther off.
  struct Crease {
    std::int64_t begin = -1, near_end = -1, end = -1;
    bool is_one() const { return begin >= 0; }
  };

  /// Turns a component outward as a whole.
  void turn(const std::vector<int>& component);
  void find_creases();
  Eigen::Vector3d normal_at(const Eigen::Vector3d& point) const;
  /// Of a range of planes_, the voxel whose plane is nearest to the point, among those whose normal is unlike
  /// `unlike`; -1 where there is none.
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
