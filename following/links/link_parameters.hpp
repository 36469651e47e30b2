// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/following/parameters.hpp>
#include <limpet/kinematics/redundancy.hpp>

namespace limpet::following {

/// How motions of the control point become motions of all joints.
enum class Redundancy {
  thesis,    ///< thesis (3) to (5): the pseudo-inverse, and the gradient of an objective in its null space
  programme  ///< a quadratic programme with a bound on how fast each link nears each obstacle; and a check
};

/// Lengths in the scan's unit.
struct LinkParameters {
  Redundancy redundancy = Redundancy::programme;
  kinematics::RedundancyParameters objective;  ///< of both
  double resolution = 0.05;                    ///< λ
  double max_step = 0.1;                       ///< σ_max
  double least_distance = 0.06;  ///< d_s: what a link is to keep from the model and from recent readings; > 0
  /// What a link is to keep from readings of a surface that the model does not have yet: between two of them
  /// it may come nearer than they do; ≥ d_s.
  double reading_distance = 0.1;
  double own_distance = 0.01;       ///< what links are to keep from each other; > 0
  double control_clearance = 0.05;  ///< what the control point is to keep (Parameters::clearance())
  double spared = 0.1;  ///< radius of what of the control point's link is left out (thesis §3.3: δ)
};

/// The parameters that go with those of following: √(2 d₀) is the sensing range, d_s 1.2 λ.
LinkParameters usual_link_parameters(const Parameters&, Redundancy);

}  // namespace limpet::following
