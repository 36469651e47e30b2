// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/io/lifted.hpp>
#include <limpet/model/open_edges.hpp>
#include <optional>
#include <span>

namespace limpet::app {

/// The angular resolution that would tell apart the planes which μ does not.
struct SuggestedAngle {
  double least_bend_deg = 0;  ///< nine in ten of the angles that are too small for μ are larger
  double angle_deg = 0;       ///< below it, in two digits
};

/// Nothing unless μ is what keeps at least half of the open edges open (Refusal::angle), and less than that
/// has a common line to share edges on: planes at an angle below 1.2° have none.
std::optional<SuggestedAngle> suggested_angle(std::span<const io::LiftedPolygon> polygons,
                                              std::span<const model::OpenEdge> open_edges);

}  // namespace limpet::app
