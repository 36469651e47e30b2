// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

namespace limpet::following {

/// Lengths in the scan's unit; the symbols are the thesis's.
struct Parameters {
  double resolution = 0.05;                ///< λ of the model; > 0
  double angle_rad = 0.17453292519943295;  ///< μ of the model
  double follow_distance = 0.1;  ///< δ: desired distance of the control point from the model; λ < δ < range
  double max_step = 0.1;         ///< σ_max: longest motion of the control point; less than the sensing range
  double stray_limit = 0.2;      ///< ρ: farthest from the part of the model that is followed; > δ
  int progress_period = 10;      ///< τ: steps between two looks at the progress made; ≥ 2
  double sensing_range = 0.2;    ///< of the sensors around the control point

  /// The smallest distance from the model and from recent readings that a motion may lead to.
  double clearance() const { return follow_distance - resolution; }
};

/// The thesis's multiples of λ (§4.3): δ = σ_max = 2 λ, ρ = sensing range = 4 λ, τ = 10.
Parameters usual_parameters(double resolution);

/// Throws std::invalid_argument, in one line, unless λ < δ < range, 0 < σ_max < range, δ < ρ, τ ≥ 2.
void require_sound(const Parameters&);

}  // namespace limpet::following
