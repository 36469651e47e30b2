// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/view.hpp>

#include "edge_lookup_internal.hpp"
#include "lifted_internal.hpp"

/// Which segments to look at, those near a place first.
namespace limpet::model::internal {

inline View::Kind kind_of(const Segment& s) {
  return !s.polygon ? View::Kind::point : s.initial() ? View::Kind::initial : View::Kind::polygon;
}

inline bool is_asked(const Which& which, const Segment& s) {
  if (s.id == which.but || (which.only && s.id != which.only)) return false;
  const View::Kind kind = kind_of(s);
  return kind == View::Kind::point     ? which.points
         : kind == View::Kind::initial ? which.initial
                                       : which.polygons;
}

/// Calls f(segment) for those asked about whose indexed boxes meet `box`.
template <class F>
void for_each_near(const Engine& e, const Which& which, const Box3& box, F&& f) {
  if (which.only) {
    const Segment* s = find_segment(e, which.only);
    if (s && is_asked(which, *s)) f(*s);
    return;
  }
  const auto look = [&](std::uint32_t slot) {
    if (is_asked(which, e.at(slot))) f(e.at(slot));
    return false;
  };
  if (which.polygons || which.initial) e.polygons.any_of(box, look);
  if (which.points) e.points.any_of(box, look);
}

inline Box3 grown(const Box3& box, double by) {
  return {box.min() - Eigen::Vector3d::Constant(by), box.max() + Eigen::Vector3d::Constant(by)};
}

/// Looks at the segments asked about from those near a box outwards: look(segment) returns how far away
/// segments are still of interest, at most `limit`. Each of these is looked at once; none whose box is
/// farther.
template <class Look>
void look_outwards(const Engine& e, const Which& which, const Box3& around, double limit, double rounding,
                   Look&& look) {
  Box3 all = e.points.bounds();
  all.extend(e.polygons.bounds());
  if (all.isEmpty()) return;
  const double beyond = length(gap_between(around, all));
  double seen = -1;
  for (double span = e.parameters.resolution;; span *= 2) {
    const Box3 box = grown(around, std::min(beyond + span, limit) + rounding);
    // The last round takes all that is left.
    const bool last = which.only || beyond + span >= limit || box.contains(all);
    const double reach = last ? limit : beyond + span;
    for_each_near(e, which, box, [&](const Segment& s) {
      const double gap = length(gap_between(around, tight_box(s)));
      if (gap > seen && gap <= reach && gap <= limit) limit = std::min(limit, look(s));
    });
    if (last || reach >= limit) return;
    seen = reach;
  }
}

/// Looks at all segments asked about whose boxes are within `limit` of a box.
template <class Look>
void look_within(const Engine& e, const Which& which, const Box3& around, double limit, double rounding,
                 Look&& look) {
  for_each_near(e, which, grown(around, limit + rounding), [&](const Segment& s) {
    if (length(gap_between(around, tight_box(s))) <= limit) look(s);
  });
}

}  // namespace limpet::model::internal
