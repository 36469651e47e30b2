// Copyright the limpet authors. GPL-3.0-or-later.
#include "corners_internal.hpp"

#include <algorithm>
#include <cmath>

#include <limpet/geometry/predicates.hpp>

#include "chance_internal.hpp"
#include "voids_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;
using geometry::Point2;
using geometry::Slot;

const geometry::Polygon::Node& node_of(const RingPart& part, Slot s) {
  return part.segment->polygon->perimeter.node(s);
}

CommonLine line_across(const Complex& complex, const Segment& s, EdgeId edge, const Eigen::Vector3d& near) {
  // There is a line: the planes were not parallel when the edge was formed or repositioned.
  return common_line(s.polygon->plane(), plane_across(complex, edge), near).value();
}

double squared_distance(const CommonLine& line, const Eigen::Vector3d& p) {
  const double t = line.place_of(p);
  return std::max(0.0, (p - line.origin).squaredNorm() - t * t);
}

/// The part of the ring from shared edge e₁ to the next shared edge; nothing if the two cannot meet in a
/// corner.
std::optional<RingPart> part_after(const Complex& complex, const Segment& s, Slot first) {
  const geometry::Polygon& perimeter = s.polygon->perimeter;
  RingPart part;
  part.segment = &s, part.before = first;
  Slot v = perimeter.next(first);
  part.between.push_back(v);
  for (int open = 0; !perimeter.node(v).shared; ++open) {
    if (open == kMaxCornerOpen) return std::nullopt;
    part.between.push_back(v = perimeter.next(v));
  }
  part.after = v;
  if (part.after == part.before) return std::nullopt;
  const EdgeId e1 = perimeter.node(part.before).edge, e2 = perimeter.node(part.after).edge;
  if (complex.edges().across(e1).segment == complex.edges().across(e2).segment) return std::nullopt;
  const Eigen::Vector3d near = s.polygon->position(part.between.front());
  part.line_before = line_across(complex, s, e1, near);
  part.line_after = line_across(complex, s, e2, near);
  return part;
}

/// May the part give way to its corner although it is farther than λ from both lines? When finishing, it may
/// if it is a bay that may be a chance gap (rule `voids`), a spur, or goes no farther beyond the corner than
/// `at_angle` (SharingReach), scan's unit.
bool gives_way(const Complex& complex, const RingPart& part, double at_angle) {
  const PolygonPart& polygon = *part.segment->polygon;
  std::vector<Point2> outline{part.corner};
  for (const Slot s : part.between) outline.push_back(polygon.perimeter.at(s));
  double twice_area = 0, depth = 0;  // of the region between P and the corner; > 0 on the right of P
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const Point2 p = outline[i] - part.corner, q = outline[i + 1] - part.corner;
    twice_area -= cross(p, q);
    depth = std::max(depth, std::sqrt(squared_length(q)));
  }
  const Setting& setting = complex.setting();
  if (twice_area <= 0)
    return depth * setting.step < at_angle ||
           is_spur(setting.rules(), setting.scale_at(polygon.position(part.between.front())).gap,
                   twice_area / 2, depth);
  Addition bay = addition_on(polygon, outline);  // up to the two shared edges, which will end at the corner
  bay.limits.push_back(limit_along(polygon, polygon.perimeter.at(part.before), part.corner));
  bay.limits.push_back(limit_along(polygon, part.corner, polygon.perimeter.end(part.after)));
  return chance_explains(complex, *part.segment, bay);
}

/// The smallest sine of the angle between two neighbours around the ring.
double least_sine(const Ring& ring) {
  double sine = 1;
  for (const RingPart& part : ring.parts) sine = std::min(sine, part.line_before.sine);
  return sine;
}

/// Sets the part's corner, and checks the conditions on its distances and directions (thesis §2.7).
Refusal fit_corner(const Complex& complex, const Ring& ring, RingPart& part, const SharingReach& reach) {
  const PolygonPart& polygon = *part.segment->polygon;
  const auto corner = place_of_corner(complex, ring, part);
  if (!corner) return Refusal::corner_far;
  const Setting& setting = complex.setting();
  const Scale scale = setting.scale_at(polygon.position(part.between.front()));
  const double lambda2 = scale.lambda2,
               distance = reach.at_angle(scale.lambda, setting.parameters.tolerance, least_sine(ring)),
               distance2 = distance * distance;
  part.corner = geometry::round_to_grid(polygon.chart.project(*corner));
  bool reached = false, far = false;
  for (const Slot s : part.between) {
    const Eigen::Vector3d p = polygon.position(s);
    far |=
        squared_distance(part.line_before, p) >= lambda2 && squared_distance(part.line_after, p) >= lambda2;
    reached |= (p - *corner).squaredNorm() < distance2;
  }
  for (std::size_t i = 0; i + 1 < part.between.size() && !reached; ++i) {  // also inside edges
    const Eigen::Vector3d p = polygon.position(part.between[i]),
                          d = polygon.position(part.between[i + 1]) - p;
    const double t = std::clamp(d.dot(*corner - p) / std::max(d.dot(d), 1e-300), 0.0, 1.0);
    reached = (p + t * d - *corner).squaredNorm() < distance2;
  }
  if (!reached) return Refusal::corner_far;
  const bool doubtful = far || (reach.section > 1 && !polygon.all_felt());
  if (doubtful && !(reach.section > 1 && gives_way(complex, part, distance))) return Refusal::corner_bay;
  // e₁ and e₂ keep their directions, and a least length.
  const Point2 u = polygon.perimeter.at(part.before), w = polygon.perimeter.end(part.after);
  const Point2 d1 = polygon.perimeter.end(part.before) - u, d2 = w - polygon.perimeter.at(part.after);
  const auto keeps = [](Point2 direction, Point2 now) {
    return dot(direction, now) > kLeastSharedSteps * std::sqrt(squared_length(direction));
  };
  return keeps(d1, part.corner - u) && keeps(d2, w - part.corner) ? Refusal::none : Refusal::corner_turns;
}

/// The corner a few steps back between its two edges: where a perimeter would touch itself in a vertex, as
/// that of a hole and the outer one do at some vertices of solids, the vertex is doubled.
Point2 stepped_back(const RingPart& part) {
  const geometry::Polygon& perimeter = part.segment->polygon->perimeter;
  const auto unit = [](Point2 d) { return 1 / std::sqrt(squared_length(d)) * d; };
  const Point2 back = unit(perimeter.at(part.before) - perimeter.end(part.before)) +
                      unit(perimeter.end(part.after) - perimeter.at(part.after));
  const double length = std::sqrt(squared_length(back));
  return length > 0 ? geometry::round_to_grid(part.corner + kDoubledSteps / length * back) : part.corner;
}

/// Is the corner, stepped back, still on the lines of its edges, to the rounding?
bool is_on_lines(const Complex& complex, const RingPart& part) {
  const Eigen::Vector3d at = part.segment->polygon->at(part.corner);
  const double off = kDoubledOff * complex.setting().step;
  return std::abs(plane_across(complex, node_of(part, part.before).edge).height_of(at)) < off &&
         std::abs(plane_across(complex, node_of(part, part.after).edge).height_of(at)) < off;
}

bool formed_already(const RingPart& part) {
  if (part.between.size() != 1) return false;
  const Point2 at = part.segment->polygon->perimeter.at(part.between.front());
  return at == part.corner || at == stepped_back(part);
}

geometry::Edit edit_for(const RingPart& part) {
  const auto& perimeter = part.segment->polygon->perimeter;
  geometry::Edit edit;
  edit.chains.push_back({part.before,
                         {{part.corner, perimeter.node(part.after).edge, true}},
                         perimeter.next(part.after),
                         perimeter.node(part.before).edge,
                         true});
  return edit;
}

/// Do the two copies of each edge of the ring still overlap, as their corners need not coincide?
bool copies_overlap(const Complex& complex, const std::vector<RingPart>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const RingPart &mine = ring[i], &next = ring[(i + 1) % ring.size()];
    const PolygonPart &a = *mine.segment->polygon, &b = *next.segment->polygon;
    const Eigen::Vector3d corner_a = a.at(mine.corner), far_a = a.position(a.perimeter.next(mine.after)),
                          corner_b = b.at(next.corner), far_b = b.position(next.before);
    const Eigen::Vector3d along = far_a - corner_a;
    const double least = kLeastSharedSteps * complex.setting().step * std::sqrt(along.dot(along));
    const double begin = std::max(0.0, along.dot(corner_b - corner_a)),
                 end = std::min(along.dot(along), along.dot(far_b - corner_a));
    if (end - begin < least) return false;
  }
  return true;
}

}  // namespace

Ring ring_from(const Complex& complex, const Segment& s, Slot first) {
  Ring ring;
  const EdgeId start = s.polygon->perimeter.node(first).edge;
  const Segment* at = &s;
  Slot edge = first;
  for (;;) {
    auto part = part_after(complex, *at, edge);
    if (!part || ring.parts.size() == kMaxRing) return ring;
    const EdgeId last = node_of(*part, part->after).edge;
    const EdgePlace& next = complex.edges().across(last);
    const bool closes = complex.edges().at(last).partner == start;
    ring.parts.push_back(std::move(*part));
    if (closes) break;
    at = &complex.at(next.segment);
    edge = next.slot;
    if (std::any_of(ring.parts.begin(), ring.parts.end(), [&](const RingPart& p) { return p.segment == at; }))
      return ring;
  }
  ring.closed = ring.parts.size() >= 3;
  return ring;
}

CornerEdits edits_for(const Complex& complex, Ring& ring, const SharingReach& reach) {
  if (!ring.closed) return {Refusal::ring_broken, false, {}};
  CornerEdits corner;
  corner.formed_already = true;
  for (RingPart& part : ring.parts) {
    if (const Refusal refusal = fit_corner(complex, ring, part, reach); refusal != Refusal::none)
      return {refusal, false, {}};
    corner.formed_already &= formed_already(part);
  }
  if (corner.formed_already) return corner;
  if (!copies_overlap(complex, ring.parts)) return {Refusal::corner_turns, false, {}};
  for (RingPart& part : ring.parts) {
    const geometry::Polygon& perimeter = part.segment->polygon->perimeter;
    corner.edits.push_back(edit_for(part));
    if (perimeter.judge(corner.edits.back()) == geometry::Verdict::valid) continue;
    part.corner = stepped_back(part);
    corner.edits.back() = edit_for(part);
    if (!is_on_lines(complex, part) || perimeter.judge(corner.edits.back()) != geometry::Verdict::valid)
      return {Refusal::perimeter, false, {}};
  }
  return corner;
}

}  // namespace limpet::model::internal
