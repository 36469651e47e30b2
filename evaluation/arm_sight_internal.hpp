// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/evaluation/arm_space_internal.hpp>
#include <limpet/evaluation/reachable.hpp>
#include <limpet/kinematics/posture.hpp>
#include <optional>

namespace limpet::evaluation {

/// When a sensor sees a sample of the surface.
struct SightOptions {
  double least_cosine = 0.087;  ///< of the angle of incidence, as in Sensing
  double precision = 0;         ///< how far from the sample the sensing axis may go by; > 0
};

/// Does the sensor see the sample: its axis meets it from outside, within range, with nothing between?
bool sees(const kinematics::Posture::Sensor&, const SurfaceSample&, const TrueSurface&, const SightOptions&);

/// How far a sensor that stands like this is from seeing a sample: how far from it its ray passes, and more
/// the flatter it comes. `nearest`: of the sensor from the sample.
double misses_by(const kinematics::Posture::Sensor&, const SurfaceSample&, double nearest);

/// A configuration near this one, within the joints' limits, in which the axis of a sensor goes through a
/// sample at a distance from `nearest` to the range, from outside: found by the damped pseudo-inverse of how
/// the axis moves (two degrees of freedom; the others turn it against the surface if it is flat to it). It
/// may not be clear, nor the sample in sight. None: the search does not lead to one.
std::optional<kinematics::Configuration> aimed(const ArmSpace&, kinematics::Configuration at,
                                               std::size_t sensor, const SurfaceSample&, double nearest,
                                               const SightOptions&);

}  // namespace limpet::evaluation
