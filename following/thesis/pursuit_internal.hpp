// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "changes_internal.hpp"
#include "marks_internal.hpp"
#include "places_internal.hpp"
#include "progress_internal.hpp"
#include "slices_internal.hpp"

namespace limpet::following::internal {

/// What is being pursued: the choices that the motion modes hand to each other.
struct Pursuit {
  explicit Pursuit(const Parameters& p)
      : slices(p.resolution),
        progress(p.progress_period, p.max_step, p.angle_rad),
        slice_places(p.resolution / 2, kMostVisits),
        goal_places(p.resolution, kMostVisits) {}

  /// Follows the choices through what surface modelling changed (thesis §3.4.6).
  void take(const Changes&);

  model::SegmentId segment;    ///< the current segment
  geometry::EdgeId edge;       ///< the current edge; none: its choice is cleared
  geometry::EdgeId follow;     ///< current segment following's follow edge; none: its choice is cleared
  bool any_edge = true;        ///< any incomplete follow edge does as current edge (thesis §3.4.2)
  Slices slices;               ///< of the unexposed surface near the current edge
  bool has_been_near = false;  ///< within ρ of the current point since the current slice was chosen
  Completeness completeness;
  Progress progress;
  Places slice_places;  ///< current points
  Places goal_places;   ///< edges and point segments that were chosen to be reached

  /// A new current edge, with its slices. False, and it is marked unclosable, when it has no length or its
  /// place is worn out.
  bool choose_edge(const model::View::Edge&);
  void clear_edge() { edge = {}; }
  void mark_unclosable(geometry::EdgeId);
  void use_slice();

 private:
  static constexpr int kMostVisits = 12;
};

}  // namespace limpet::following::internal
