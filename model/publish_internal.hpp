// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <optional>

#include "complex_internal.hpp"

/// The plane of best fit moves with every point; the published plane, on which perimeters lie, only when it
/// matters (DESIGN §3).
namespace limpet::model::internal {

/// Fits the plane anew, and publishes it where that moves a line of intersection by a sixteenth of λ; when
/// finishing, where it moves the polygon by a grid step.
void refit(Complex&, const Agenda&, const Segment&);
/// The same, once it has a thirty-second part more points.
void refit_if_due(Complex&, const Agenda&, const Segment&);

/// Would the points' variance about the published plane stay below λ² with these moments (thesis §2.2)?
bool variance_allowed(const Setting&, const PolygonPart&, const Moments& merged);
/// Is the fit so far from the initial plane that data must not be merged (thesis §2.4.1)?
bool differs_from_initial(const Setting&, const PolygonPart&, const Fit&);
/// b's cycles as seen in a chart, valid, or nothing. New edges take identities.
std::optional<geometry::Polygon> in_chart(Complex&, const geometry::Chart&, const PolygonPart& b);

}  // namespace limpet::model::internal
