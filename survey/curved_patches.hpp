// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace limpet::survey {

/// How points of one neighbourhood scatter about the surfaces that fit them best along a direction: standard
/// deviations, scan's unit.
struct PatchScatter {
  double plane = 0, quadric = 0;
};

/// Of points that lie in a layer whose normal is `normal` (a unit vector). Nothing where they are too few
/// (12) or in one place.
std::optional<PatchScatter> patch_scatter(const std::vector<Eigen::Vector3d>& points,
                                          const Eigen::Vector3d& normal);

/// What a neighbourhood as wide as a facet says.
struct WidePatch {
  double radius = 0;
  double noise = 0;  ///< that is expected in it, along its normal
  PatchScatter scatter;
};

/// How fast the surface of a scan turns away from its planes: the scatter about a plane, noise left out, of a
/// patch of radius 2 λ, over λ²; one over the scan's unit. That of a sphere of radius r is 1/(r√3). 0 unless
/// at least half of `centres` neighbourhoods are such that a quadric fits their points to the noise and a
/// plane misses them by a quarter more: a crease is no quadric, nor is the edge of a box.
double surface_curvature(const std::vector<WidePatch>& wide, std::size_t centres);

}  // namespace limpet::survey
