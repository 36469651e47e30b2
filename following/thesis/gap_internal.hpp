// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <vector>

#include <limpet/model/view.hpp>

namespace limpet::following::internal {

/// Where the gap ends that begins at the current point (thesis §3.4.5, Figure 35): on the model segment that
/// holds `closest`, the surface model point closest to the control point, where the line to it from the
/// current point's projection meets the segment's perimeter first; else `closest` itself.
Eigen::Vector3d gap_point(const model::View&, const Eigen::Vector3d& current_point,
                          const model::View::Nearest& closest);

/// Target points along the gap, from the gap point towards the current point, `spacing` apart.
std::vector<Eigen::Vector3d> target_points(const Eigen::Vector3d& gap_point,
                                           const Eigen::Vector3d& current_point, double spacing);

}  // namespace limpet::following::internal
