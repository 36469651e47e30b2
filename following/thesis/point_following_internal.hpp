// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "pursuit_internal.hpp"
#include "situation_internal.hpp"

namespace limpet::following::internal {

/// Point following (thesis §3.4.4): directs the control point over the surface around a point segment, along
/// four slices, until it is a planar polygon segment. When all are used the point segment is given up, and
/// another goal chosen: the thesis's end of the run there would be one after ten steps, where the readings
/// around the first points detect all targets at once.
class PointFollowing {
 public:
  /// A new point segment: four slice lines through it, perpendicular to the line to the control point.
  void begin(const Situation&, Pursuit&);
  Decision follow(const Situation&, Pursuit&);
  /// Gap following has used its targets. A slice along which nothing has moved yet is not used.
  void gap_is_over(bool has_moved, Pursuit&);

 private:
  void use_slice(Pursuit&);

  std::array<Eigen::Vector3d, 4> vectors_{};
  std::size_t slice_ = 0;
  bool gap_tried_ = false;      ///< in this slice
  bool has_been_near_ = false;  ///< within ρ of the point
};

}  // namespace limpet::following::internal
