// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <cmath>

#include "point_following_internal.hpp"

namespace limpet::following::internal {

using Eigen::Vector3d;

void PointFollowing::begin(const Situation& now, Pursuit& pursuit) {
  const Vector3d towards = now.at - now.view.segment(pursuit.segment)->plane.point;
  const Vector3d v = towards.unitOrthogonal(), w = towards.cross(v).normalized();
  vectors_ = {v, -v, w, -w};
  slice_ = 0;
  gap_tried_ = has_been_near_ = false;
  pursuit.progress.restart(towards.norm());
}

void PointFollowing::use_slice(Pursuit& pursuit) {
  ++slice_;
  gap_tried_ = false;
  pursuit.progress.restart(0);
}

void PointFollowing::gap_is_over(bool has_moved, Pursuit& pursuit) {
  if (has_moved)
    use_slice(pursuit);
  else
    gap_tried_ = true;
}

Decision PointFollowing::follow(const Situation& now, Pursuit& pursuit) {
  const auto segment = now.view.segment(pursuit.segment);
  if (!segment) return Mode::current_surface;
  if (segment->kind != model::View::Kind::point) {
    pursuit.clear_edge();
    return Mode::current_segment;
  }
  if (pursuit.progress.is_insufficient()) {
    if (!has_been_near_) return Mode::current_surface;  // it cannot be reached
    use_slice(pursuit);
  }
  if (slice_ == vectors_.size()) return Mode::current_surface;
  const Vector3d from_point = now.at - segment->plane.point;
  if (!has_been_near_ && from_point.norm() > now.parameters.stray_limit) return Direction{-from_point};
  has_been_near_ = true;
  const bool gap = now.closest && now.closest->segment != pursuit.segment;
  if (gap && !gap_tried_) return Mode::gap;
  return Direction{vectors_[slice_].cross(from_point)};
}

}  // namespace limpet::following::internal
