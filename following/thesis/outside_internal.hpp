// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>

#include <limpet/model/view.hpp>

namespace limpet::following::internal {

/// What lies outside the current edge (thesis §3.4.3, Figure 32): every point of other segments, and those
/// points of the edge's own segment that are strictly between the lines through the edge's vertices
/// perpendicular to the slice vector, on the side that the edge faces.
class Outside {
 public:
  Outside(const model::View&, const model::View::Edge&, const Eigen::Vector3d& slice_vector);

  bool contains(const model::View::Nearest&) const;
  /// Does part of the model lie outside the edge nearer to this point of it than `reach`?
  bool is_near(const Eigen::Vector3d& current_point, double reach) const;

 private:
  double outwards(const Eigen::Vector3d& p) const { return out_.dot(p - edge_.from); }
  bool own_is_near(const Eigen::Vector3d& current_point, double reach) const;

  model::View view_;
  model::View::Edge edge_;
  Eigen::Vector3d vector_, out_;
  double first_, last_;  ///< the edge's vertices along the slice vector
};

}  // namespace limpet::following::internal
