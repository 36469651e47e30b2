// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <limpet/model/view.hpp>

#include "complex_internal.hpp"
#include "lifted_internal.hpp"

/// Visiting the segments that a question is about, those near a place first.
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

/// The segment Which::only, if it exists and is asked about; else null.
inline const Segment* the_only(const Complex& complex, const Which& which) {
  const Segment* s = complex.find(which.only);
  return s && is_asked(which, *s) ? s : nullptr;
}

/// Calls f(segment) for the segments of an index that are asked about and whose indexed boxes meet `box`.
template <class F>
void for_each_near(const Complex& complex, const SpatialIndex& index, const Which& which, const Box3& box,
                   F&& f) {
  const bool every = !which.but && !which.only && which.points && which.polygons && which.initial;
  index.any_of(box, [&](std::uint32_t slot) {
    if (every || is_asked(which, complex.at(slot))) f(complex.at(slot));
    return false;
  });
}

/// The same for the segments of both indices. Which::only is visited wherever it is.
template <class F>
void for_each_near(const Complex& complex, const Which& which, const Box3& box, F&& f) {
  if (which.only) {
    if (const Segment* s = the_only(complex, which)) f(*s);
    return;
  }
  if (which.polygons || which.initial) for_each_near(complex, complex.polygons(), which, box, f);
  if (which.points) for_each_near(complex, complex.points(), which, box, f);
}

/// A lower bound on the distance of the segment from any point of the box `from`.
inline double least_distance(const Complex& complex, const Box3& from, const Segment& s, double rounding) {
  return length(gap_between(from, grown(tight_box(s), room_around(complex, rounding))));
}

/// Some segments, and how near they may be; to be looked at by that.
class Candidates {
 public:
  bool full() const { return size_ == all_.size(); }
  void add(double least, const Segment& s) { all_[size_++] = {least, &s}; }
  /// Calls f(least, segment), the nearest first, and forgets them.
  template <class F>
  void take_in_order(F&& f) {
    const auto end = all_.begin() + static_cast<std::ptrdiff_t>(size_);
    std::sort(all_.begin(), end, [](const auto& a, const auto& b) { return a.first < b.first; });
    std::for_each(all_.begin(), end, [&](const auto& c) { f(c.first, *c.second); });
    size_ = 0;
  }

 private:
  std::array<std::pair<double, const Segment*>, 16> all_;
  std::size_t size_ = 0;
};

/// Visits the segments of one index from a box outwards; see look_outwards() below. The first round reaches
/// `span` beyond the nearest box of the index, each later one twice as far. Returns how far away segments are
/// still of interest.
template <class Look>
double look_outwards(const Complex& complex, const SpatialIndex& index, const Which& which,
                     const Box3& around, double span, double limit, double rounding, Look&& look) {
  const Box3 all = index.bounds();
  if (all.isEmpty()) return limit;
  const double beyond = length(gap_between(around, all));
  Candidates near;
  const auto look_at_them = [&] {
    near.take_in_order([&](double least, const Segment& s) {
      if (least <= limit) limit = std::min(limit, look(s));
    });
  };
  for (double seen = -1; seen < limit; span *= 2) {
    const Box3 box = grown(around, std::min(beyond + span, limit) + 2 * rounding);
    const double reach = box.contains(all) ? limit : beyond + span;
    for_each_near(complex, index, which, box, [&](const Segment& s) {
      const double gap = least_distance(complex, around, s, rounding);
      if (gap <= seen || gap > reach || gap > limit) return;
      if (near.full()) look_at_them();
      near.add(gap, s);
    });
    look_at_them();
    seen = reach;
  }
  return limit;
}

/// Visits the segments asked about from a box outwards. look(segment) returns how far away segments are still
/// of interest, at most `limit`. Each segment up to that distance is visited once; none whose box is farther.
/// Polygons come first: they are found with less effort, and once one is found, few point segments are left
/// to visit.
template <class Look>
void look_outwards(const Complex& complex, const Which& which, const Box3& around, double limit,
                   double rounding, Look&& look) {
  if (which.only) {
    const Segment* s = the_only(complex, which);
    if (s && least_distance(complex, around, *s, rounding) <= limit) look(*s);
    return;
  }
  const double first = 4 * complex.setting().least.lambda;
  if (which.polygons || which.initial)
    limit = look_outwards(complex, complex.polygons(), which, around, first, limit, rounding, look);
  if (which.points) look_outwards(complex, complex.points(), which, around, first, limit, rounding, look);
}

/// Visits all segments asked about whose boxes are within `limit` of a box.
template <class Look>
void look_within(const Complex& complex, const Which& which, const Box3& around, double limit,
                 double rounding, Look&& look) {
  for_each_near(complex, which, grown(around, limit + 2 * rounding), [&](const Segment& s) {
    if (least_distance(complex, around, s, rounding) <= limit) look(s);
  });
}

}  // namespace limpet::model::internal
