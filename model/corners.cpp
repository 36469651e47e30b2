// Copyright the limpet authors. GPL-3.0-or-later.
//
// Step 5 of the update: forming corner vertices (thesis §2.7) around a ring of segments S₀…Sₙ, n ≥ 2, each
// the neighbour of the next: on all of them or on none.
#include <algorithm>
#include <cmath>

#include <limpet/geometry/predicates.hpp>

#include "common_line_internal.hpp"
#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;
using geometry::Point2;
using geometry::Slot;

constexpr std::size_t kMaxRing = 64;  ///< segments around one corner
constexpr int kMaxOpenEdges = 64;     ///< between two shared edges that may meet in a corner

/// What one segment of the ring gives up for its corner vertex: the stretch P between two shared edges that
/// follow each other.
struct RingPart {
  Segment* segment = nullptr;
  Slot before = geometry::kNoSlot, after = geometry::kNoSlot;  ///< e₁ and e₂
  std::vector<Slot> between;                                   ///< the vertices of P, v₁ to v₂
  CommonLine line_before, line_after;
  Point2 corner;
};

const geometry::Polygon::Node& node_of(const RingPart& part, Slot s) {
  return part.segment->polygon->perimeter.node(s);
}

CommonLine line_across(Engine& e, const Segment& s, EdgeId edge, const Eigen::Vector3d& near) {
  // The edge's planes were not parallel when it was formed, nor when it was repositioned.
  return common_line(s.polygon->plane(), e.at(across(e, edge).segment).polygon->plane(), near).value();
}

double squared_distance(const CommonLine& line, const Eigen::Vector3d& p) {
  const double t = line.place_of(p);
  return std::max(0.0, (p - line.origin).squaredNorm() - t * t);
}

/// The stretch from shared edge e₁ to the one that follows it, if it may give way to a corner.
std::optional<RingPart> part_after(Engine& e, Segment& s, Slot first) {
  const geometry::Polygon& perimeter = s.polygon->perimeter;
  RingPart part;
  part.segment = &s, part.before = first;
  Slot v = perimeter.next(first);
  part.between.push_back(v);
  for (int open = 0; !perimeter.node(v).shared; ++open) {
    if (open == kMaxOpenEdges) return std::nullopt;
    part.between.push_back(v = perimeter.next(v));
  }
  part.after = v;
  if (part.after == part.before) return std::nullopt;
  const EdgeId e1 = perimeter.node(part.before).edge, e2 = perimeter.node(part.after).edge;
  if (across(e, e1).segment == across(e, e2).segment) return std::nullopt;
  const Eigen::Vector3d near = s.polygon->position(part.between.front());
  part.line_before = line_across(e, s, e1, near);
  part.line_after = line_across(e, s, e2, near);
  return part;
}

/// The ring of §2.7, starting with e₁ of s: f₁ is e₂'s copy on the next segment, and so on back to e₁.
/// Nothing if it does not close over distinct segments.
std::vector<RingPart> ring_from(Engine& e, Segment& s, Slot first) {
  std::vector<RingPart> ring;
  const EdgeId start = s.polygon->perimeter.node(first).edge;
  Segment* at = &s;
  Slot edge = first;
  for (;;) {
    auto part = part_after(e, *at, edge);
    if (!part || ring.size() == kMaxRing) return {};
    const SharedEdge& next = across(e, node_of(*part, part->after).edge);
    const EdgeId next_edge = e.shared.at(node_of(*part, part->after).edge.value).partner;
    ring.push_back(std::move(*part));
    if (next_edge == start) break;
    at = &e.at(next.segment);
    edge = next.slot;
    if (std::any_of(ring.begin(), ring.end(), [&](const RingPart& p) { return p.segment == at; })) return {};
  }
  return ring.size() >= 3 ? ring : std::vector<RingPart>{};
}

/// When finishing, a bay at the corner that chance alone leaves may be deeper than λ (rule `voids`).
bool bay_by_chance(const Engine& e, const RingPart& part) {
  const Segment& s = *part.segment;
  const geometry::Polygon& perimeter = s.polygon->perimeter;
  double twice_area = 0;  // of what lies between P and the corner, on the right of P
  for (std::size_t i = 0; i + 1 < part.between.size(); ++i)
    twice_area -=
        cross(perimeter.at(part.between[i]) - part.corner, perimeter.at(part.between[i + 1]) - part.corner);
  const auto m = s.moments.count();
  return m > 0 && empty_by_chance(twice_area / 2, part.between.size(), m,
                                  static_cast<double>(m) / perimeter.area(), e.gap);
}

/// The conditions on one segment's lines, distances and directions; sets the corner.
bool corner_fits(Engine& e, RingPart& part) {
  const PolygonPart& polygon = *part.segment->polygon;
  const double lambda2 = e.parameters.resolution * e.parameters.resolution;
  const auto beyond = e.at(across(e, node_of(part, part.after).edge).segment).polygon->plane();
  const auto corner = common_point(part.line_before, beyond);
  if (!corner) return false;
  part.corner = geometry::round_to_grid(polygon.chart.project(*corner));
  bool reached = false, far = false;
  for (const Slot s : part.between) {
    const Eigen::Vector3d p = polygon.position(s);
    far |=
        squared_distance(part.line_before, p) >= lambda2 && squared_distance(part.line_after, p) >= lambda2;
    reached |= (p - *corner).squaredNorm() < lambda2;
  }
  for (std::size_t i = 0; i + 1 < part.between.size() && !reached; ++i) {  // points on edges count as well
    const Eigen::Vector3d p = polygon.position(part.between[i]),
                          d = polygon.position(part.between[i + 1]) - p;
    const double t = std::clamp(d.dot(*corner - p) / std::max(d.dot(d), 1e-300), 0.0, 1.0);
    reached = (p + t * d - *corner).squaredNorm() < lambda2;
  }
  if (!reached || (far && !(e.section_reach > 1 && bay_by_chance(e, part)))) return false;
  // The directions along e₁ and e₂ stay.
  const Point2 u = polygon.perimeter.at(part.before), w = polygon.perimeter.end(part.after);
  const Point2 d1 = polygon.perimeter.end(part.before) - u, d2 = w - polygon.perimeter.at(part.after);
  const auto keeps = [](Point2 direction, Point2 now) {
    return dot(direction, now) > kLeastSharedSteps * std::sqrt(squared_length(direction));
  };
  return keeps(d1, part.corner - u) && keeps(d2, w - part.corner);
}

bool formed_already(const RingPart& part) {
  return part.between.size() == 1 && part.segment->polygon->perimeter.at(part.between.front()) == part.corner;
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

/// Do the copies of each edge of the ring still overlap, with corners that need not coincide?
bool copies_overlap(Engine& e, const std::vector<RingPart>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const RingPart &mine = ring[i], &next = ring[(i + 1) % ring.size()];
    const PolygonPart &a = *mine.segment->polygon, &b = *next.segment->polygon;
    const Eigen::Vector3d corner_a = a.chart.at(mine.corner, a.published(mine.corner)),
                          far_a = a.position(a.perimeter.next(mine.after)),
                          corner_b = b.chart.at(next.corner, b.published(next.corner)),
                          far_b = b.position(next.before);
    const Eigen::Vector3d along = far_a - corner_a;
    const double least = kLeastSharedSteps * e.step * std::sqrt(along.dot(along));
    const double begin = std::max(0.0, along.dot(corner_b - corner_a)),
                 end = std::min(along.dot(along), along.dot(far_b - corner_a));
    if (end - begin < least) return false;
  }
  return true;
}

bool form_corner(Engine& e, std::vector<RingPart>& ring) {
  if (ring.empty()) return false;
  bool formed = true;
  for (RingPart& part : ring) {
    if (!corner_fits(e, part)) return false;
    formed &= formed_already(part);
  }
  if (formed || !copies_overlap(e, ring)) return false;
  std::vector<geometry::Edit> edits;
  for (const RingPart& part : ring) {
    edits.push_back(edit_for(part));
    if (part.segment->polygon->perimeter.judge(edits.back()) != geometry::Verdict::valid) return false;
  }
  Change formed_change{Change::Kind::corner_formed, ring[0].segment->id, ring[1].segment->id, {}, {}};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Segment& s = *ring[i].segment;
    s.polygon->perimeter.commit(edits[i], e.edge_ids);
    formed_change.edges.push_back(s.polygon->perimeter.node(ring[i].before).edge);
  }
  for (const RingPart& part : ring) perimeter_changed(e, *part.segment);
  e.changes.push_back(std::move(formed_change));
  return true;
}

bool form_corners(Engine& e, Segment& s) {
  bool any = false;
  const std::vector<EdgeId> edges = std::exchange(s.polygon->corners_due, {});
  for (const EdgeId edge : edges) {
    const auto entry = e.shared.find(edge.value);
    if (entry == e.shared.end() || entry->second.segment != s.slot) continue;
    auto ring = ring_from(e, s, entry->second.slot);
    any |= form_corner(e, ring);
  }
  return any;
}

}  // namespace

bool form_corners_of_modified(Engine& e) {
  std::vector<std::pair<SegmentId, std::uint32_t>> turn;
  for (const std::uint32_t slot : e.modified)
    if (e.segments[slot] && e.segments[slot]->polygon && !e.segments[slot]->polygon->corners_due.empty())
      turn.emplace_back(e.segments[slot]->id, slot);
  std::sort(turn.begin(), turn.end());
  bool any = false;
  for (const auto& [id, slot] : turn)
    if (Segment* s = e.find(id, slot)) any |= form_corners(e, *s);
  return any;
}

}  // namespace limpet::model::internal
