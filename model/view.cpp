// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/model/view.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "first_hit_internal.hpp"
#include "nearest_internal.hpp"
#include "outwards_internal.hpp"

namespace limpet::model {
namespace {

using Eigen::Vector3d;
using internal::Complex;

void require(bool good, const char* what) {
  if (!good) throw std::invalid_argument(what);
}

void require_place(const Complex& complex, const Vector3d& p) {
  require((p.cwiseAbs().array() <= 0x1p300 * complex.setting().step).all(),
          "a place must have finite coordinates, within 2^300 grid steps of the origin");
}

void require_length(double x, const char* what) { require(x >= 0, what); }

constexpr const char* kReach = "a reach must be 0 or more";

/// Order by distance, then segment.
template <class Found>
bool comes_before(const Found& a, const Found& b) {
  return std::tie(a.distance, a.segment) < std::tie(b.distance, b.segment);
}

/// The question what is near a point.
class AroundPoint {
 public:
  using Found = View::Nearest;

  AroundPoint(const Complex& complex, const Vector3d& p, double reach)
      : box(p, p), rounding(internal::rounding_near(complex, box)), limit(reach), p_(p) {}
  std::optional<Found> ask(const internal::Segment& s, double within) const {
    return internal::nearest_of(s, p_, within, rounding);
  }
  double limit_from(const Found& found) const { return found.distance; }

  Box3 box;
  double rounding, limit;

 private:
  const Vector3d& p_;
};

/// The question what is near a link.
class AroundLink {
 public:
  using Found = View::LinkNearest;

  AroundLink(const Complex& complex, const Capsule& link, double reach)
      : box(link.a.cwiseMin(link.b), link.a.cwiseMax(link.b)),
        rounding(internal::rounding_near(complex, box)),
        limit(from_axis(reach, link.radius)),
        link_(link),
        reach_(reach) {}
  std::optional<Found> ask(const internal::Segment& s, double within) const {
    auto found = internal::nearest_of(s, link_, within, rounding);
    if (found) found->distance -= link_.radius;
    if (found && found->distance > reach_) found.reset();
    return found;
  }
  double limit_from(const Found& found) const { return from_axis(found.distance, link_.radius); }

  Box3 box;
  double rounding, limit;

 private:
  /// An upper bound, in spite of rounding, on the distance from the axis of points at this distance from the
  /// link's surface.
  static double from_axis(double distance, double radius) {
    return distance + radius + 0x1p-50 * (std::abs(distance) + radius);
  }

  const Capsule& link_;
  double reach_;
};

template <class Around>
std::optional<typename Around::Found> nearest_of_all(const Complex& complex, const Around& around,
                                                     const Which& which) {
  std::optional<typename Around::Found> best;
  double limit = around.limit;
  internal::look_outwards(complex, which, around.box, limit, around.rounding,
                          [&](const internal::Segment& s) {
                            const auto found = around.ask(s, limit);
                            if (found && (!best || comes_before(*found, *best))) {
                              best = found;
                              limit = std::min(limit, around.limit_from(*best));
                            }
                            return limit;
                          });
  return best;
}

template <class Around>
void all_within(const Complex& complex, const Around& around, const Which& which,
                std::vector<typename Around::Found>& result) {
  result.clear();
  internal::look_within(complex, which, around.box, around.limit, around.rounding,
                        [&](const internal::Segment& s) {
                          if (const auto found = around.ask(s, around.limit)) result.push_back(*found);
                        });
  std::sort(result.begin(), result.end(), comes_before<typename Around::Found>);
}

AroundPoint around(const Complex& complex, const Vector3d& p, double reach) {
  require_place(complex, p);
  require_length(reach, kReach);
  return AroundPoint(complex, p, reach);
}

AroundLink around(const Complex& complex, const Capsule& link, double reach) {
  require_place(complex, link.a), require_place(complex, link.b);
  require_length(reach, kReach);
  require(link.radius >= 0 && link.radius <= 0x1p300 * complex.setting().step,
          "a radius must be 0 or more, and finite");
  return AroundLink(complex, link, reach);
}

/// Calls f(slot) for the edges of a perimeter, cycle by cycle, the outer one first.
template <class F>
void for_each_edge_by_cycle(const geometry::Polygon& perimeter, F&& f) {
  for (const bool holes : {false, true})
    for (const auto& cycle : perimeter.cycles()) {
      if (cycle.hole != holes) continue;
      geometry::Slot s = cycle.first;
      for (std::uint32_t i = 0; i < cycle.size; ++i, s = perimeter.next(s)) f(s);
    }
}

View::Edge edge_at(const internal::Segment& segment, geometry::Slot s, geometry::EdgeId partner) {
  const internal::PolygonPart& part = *segment.polygon;
  const auto& perimeter = part.perimeter;
  const auto& node = perimeter.node(s);
  return {node.edge,
          perimeter.node(node.next).edge,
          perimeter.node(node.prev).edge,
          partner,
          segment.id,
          node.cycle,
          perimeter.cycle(node.cycle).hole,
          part.position(s),
          part.position(node.next)};
}

void add_open_edges(const internal::Segment& segment, std::vector<View::Edge>& result) {
  const auto& perimeter = segment.polygon->perimeter;
  for_each_edge_by_cycle(perimeter, [&](geometry::Slot s) {
    if (!perimeter.node(s).shared) result.push_back(edge_at(segment, s, {}));
  });
}

/// Calls f(segment) for all segments asked about.
template <class F>
void for_each_segment(const Complex& complex, const Which& which, F&& f) {
  constexpr double kAll = std::numeric_limits<double>::infinity();
  internal::for_each_near(complex, which, {Vector3d::Constant(-kAll), Vector3d::Constant(kAll)}, f);
}

}  // namespace

std::optional<View::Nearest> View::nearest(const Vector3d& p, double reach, const Which& which) const {
  return nearest_of_all(*complex_, around(*complex_, p, reach), which);
}

void View::nearest(const Vector3d& p, double reach, std::vector<Nearest>& found, const Which& which) const {
  all_within(*complex_, around(*complex_, p, reach), which, found);
}

std::optional<View::LinkNearest> View::nearest(const Capsule& link, double reach, const Which& which) const {
  return nearest_of_all(*complex_, around(*complex_, link, reach), which);
}

void View::nearest(const Capsule& link, double reach, std::vector<LinkNearest>& found,
                   const Which& which) const {
  all_within(*complex_, around(*complex_, link, reach), which, found);
}

std::optional<View::Hit> View::first_hit(const Vector3d& from, const Vector3d& axis, double range,
                                         const Which& which) const {
  require_place(*complex_, from);
  require_length(range, "a range must be 0 or more");
  const double size = internal::length(axis);
  require(size > 0 && size <= std::numeric_limits<double>::max(), "an axis must be finite and not 0");
  const double rounding = internal::rounding_near(*complex_, {from, from});
  return internal::first_hit(*complex_, from, axis / size, range, which, rounding);
}

std::optional<View::Edge> View::edge(geometry::EdgeId id) const {
  const internal::EdgePlace* place = complex_->edges().find(id);
  if (!place) return std::nullopt;
  return edge_at(complex_->at(place->segment), place->slot, place->partner);
}

void View::edges(SegmentId id, std::vector<Edge>& result) const {
  result.clear();
  const internal::Segment* s = complex_->find(id);
  if (!s || !s->polygon) return;
  const auto& perimeter = s->polygon->perimeter;
  for_each_edge_by_cycle(perimeter, [&](geometry::Slot slot) {
    result.push_back(edge_at(*s, slot, complex_->edges().at(perimeter.node(slot).edge).partner));
  });
}

void View::open_edges(SegmentId id, std::vector<Edge>& result) const {
  result.clear();
  const internal::Segment* s = complex_->find(id);
  if (s && s->polygon) add_open_edges(*s, result);
}

void View::open_edges(std::vector<Edge>& result, const Which& which) const {
  result.clear();
  for_each_segment(*complex_, which, [&](const internal::Segment& s) {
    if (s.polygon) add_open_edges(s, result);
  });
  std::sort(result.begin(), result.end(), [](const Edge& a, const Edge& b) { return a.id < b.id; });
}

std::optional<View::Segment> View::segment(SegmentId id) const {
  const internal::Segment* s = complex_->find(id);
  if (!s) return std::nullopt;
  Segment result;
  result.id = id;
  result.kind = internal::kind_of(*s);
  result.points = s->count();
  result.box = internal::tight_box(*s);
  result.plane = s->polygon ? s->polygon->plane() : s->fit.plane();
  if (s->polygon) {
    result.confirmed = s->polygon->confirmed;
    result.edges = s->polygon->perimeter.edge_count();
    result.holes = s->polygon->perimeter.hole_count();
  }
  return result;
}

std::optional<double> View::residual(SegmentId id) const {
  const internal::Segment* s = complex_->find(id);
  if (!s || s->count() == 0) return std::nullopt;
  const Fit fit = fit_to(s->data.moments(), complex_->setting().step, s->data.axis_sum());
  const geometry::Plane plane = s->polygon ? s->polygon->plane() : fit.plane();
  const double a1 = fit.axis1.dot(plane.normal), a2 = fit.axis2.dot(plane.normal);
  const double a3 = fit.normal.dot(plane.normal), off = plane.normal.dot(fit.centroid - plane.point);
  return std::sqrt(std::max(0.0, fit.u1 * a1 * a1 + fit.u2 * a2 * a2 + fit.u3 * a3 * a3) + off * off);
}

void View::segments(std::vector<SegmentId>& result, const Which& which) const {
  result.clear();
  for_each_segment(*complex_, which, [&](const internal::Segment& s) { result.push_back(s.id); });
  std::sort(result.begin(), result.end());
}

void View::near(const Eigen::AlignedBox3d& box, std::vector<SegmentId>& result, const Which& which) const {
  result.clear();
  if (!(box.min().array() <= box.max().array()).all()) return;
  internal::for_each_near(*complex_, which, box, [&](const internal::Segment& s) {
    if (internal::tight_box(s).intersects(box)) result.push_back(s.id);
  });
  std::sort(result.begin(), result.end());
}

void View::neighbours(SegmentId id, std::vector<SegmentId>& result) const {
  result.clear();
  const internal::Segment* s = complex_->find(id);
  if (!s || !s->polygon) return;
  for (const geometry::EdgeId edge : s->polygon->shared)
    result.push_back(complex_->at(complex_->edges().across(edge).segment).id);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
}

SegmentId View::surface_of(SegmentId id) const {
  const internal::Segment* s = complex_->find(id);
  if (!s) return {};
  SegmentId lowest = id;
  for (const std::uint32_t slot : complex_->surfaces().with(s->slot))
    lowest = std::min(lowest, complex_->at(slot).id);
  return lowest;
}

void View::surface(SegmentId member, std::vector<SegmentId>& result) const {
  result.clear();
  const internal::Segment* s = complex_->find(member);
  if (!s) return;
  const auto members = complex_->surfaces().with(s->slot);
  if (members.empty()) result.push_back(member);
  for (const std::uint32_t slot : members) result.push_back(complex_->at(slot).id);
  std::sort(result.begin(), result.end());
}

bool View::same_surface(SegmentId a, SegmentId b) const {
  const internal::Segment *p = complex_->find(a), *q = complex_->find(b);
  return p && q && complex_->surfaces().together(p->slot, q->slot);
}

}  // namespace limpet::model
