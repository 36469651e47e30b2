// Copyright the limpet authors. GPL-3.0-or-later.
#include "current_edge_internal.hpp"
#include "outside_internal.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

Direction towards_slice(const Vector3d& to_centre) { return {to_centre, to_centre.norm()}; }

}  // namespace

Decision CurrentEdge::follow(const Situation& now, Pursuit& pursuit) {
  const auto edge = now.view.edge(pursuit.edge);
  if (!edge || pursuit.completeness.is_complete(*edge)) return Mode::current_segment;
  if (pursuit.progress.is_insufficient()) pursuit.use_slice();
  for (;;) {
    if (!pursuit.slices.has_current()) {
      if (!pursuit.slices.choose(*edge, now.at)) break;
      pursuit.has_been_near = false;
      const Vector3d point = pursuit.slices.current_point(*edge);
      pursuit.progress.restart((point - now.at).norm() + now.parameters.stray_limit);
      if (!pursuit.slice_places.visit(point)) {
        pursuit.use_slice();
        continue;
      }
    }
    if (const auto decision = along_slice(now, pursuit, *edge)) return *decision;
    pursuit.use_slice();
  }
  pursuit.mark_unclosable(edge->id);
  return Mode::current_segment;
}

/// The direction along the current slice; nothing when the slice is used.
std::optional<Decision> CurrentEdge::along_slice(const Situation& now, Pursuit& pursuit,
                                                 const Edge& edge) const {
  const Slices& slices = pursuit.slices;
  const Vector3d point = slices.current_point(edge);
  const Outside outside(now.view, edge, slices.vector());
  if (outside.is_near(point, now.half_resolution())) return std::nullopt;  // little unexposed surface
  if ((now.at - point).norm() > now.parameters.stray_limit)
    return pursuit.has_been_near ? std::nullopt : std::optional<Decision>(Direction{point - now.at});
  pursuit.has_been_near = true;
  if (!slices.contains(now.at)) return towards_slice(slices.to_centre(now.at));
  if (now.closest && outside.contains(*now.closest)) return Mode::gap;
  return Direction{slices.vector().cross(slices.from_line(now.at))};
}

}  // namespace limpet::following::internal
