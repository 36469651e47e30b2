// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <optional>

#include "complex_internal.hpp"

/// The plane of best fit may move with every point; the published plane, on which the perimeter lies, is
/// moved only when it matters.
namespace limpet::model::internal {

/// Fits the plane anew, and publishes it if that may move a line of intersection by more than λ /
/// kPublishPart; when finishing, if it moves the polygon by more than a grid step.
void refit(Complex&, const Agenda&, const Segment&);
/// The same, if the polygon is young, or has one part in kGrowthPart more points than at the last fit.
inline void refit_if_due(Complex& complex, const Agenda& agenda, const Segment& s) {
  if (s.young() || s.count() >= s.next_fit) refit(complex, agenda, s);
}

/// With these moments, is the points' variance about the published plane below λ² (thesis §2.2)?
bool variance_allowed(const Setting&, const PolygonPart&, const Moments& merged);
/// Is the fit too far from the initial plane for the data to be merged (thesis §2.4.1)?
bool differs_from_initial(const Setting&, const PolygonPart&, const Fit&);
/// The perimeter of b projected into a chart; nothing when it cannot be made valid there. New edges take
/// identities.
std::optional<geometry::Polygon> in_chart(Complex&, const geometry::Chart&, const PolygonPart& b);

}  // namespace limpet::model::internal
