// Copyright the limpet authors. GPL-3.0-or-later.
//
// Why open edges are open: the conditions of thesis §2.6 and §2.7 are checked once more, without changing
// anything.
#include "open_edges_internal.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <unordered_map>

#include "corners_internal.hpp"
#include "meeting_internal.hpp"
#include "section_search_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;
using geometry::Slot;

/// How far an attempt came that ended with this refusal; Refusal::none came farthest.
std::size_t progress(Refusal refusal) {
  return refusal == Refusal::none ? kRefusals : static_cast<std::size_t>(refusal);
}

/// May this be the refusal of an edge that has no other polygon within λ?
bool reaches_far(Refusal refusal) {
  return refusal == Refusal::none || refusal == Refusal::bay || refusal == Refusal::ring_broken ||
         refusal == Refusal::corner_far || refusal == Refusal::corner_bay;
}

/// A stretch of a line, and the condition that refused its sections.
struct RefusedStretch {
  double begin, end;
  Refusal refusal;
};

/// Records what refuses each pair of sections, and forms none.
class Onlooker : public SectionUser {
 public:
  Refusal form(const SectionPair& pair) override {
    const auto edit_p = edit_for(pair.side_p, pair.p, pair.begin_p, pair.end_p, {}),
               edit_q = edit_for(pair.side_q, pair.q, pair.begin_q, pair.end_q, {});
    if (pair.side_p.perimeter().judge(edit_p) == geometry::Verdict::valid &&
        pair.side_q.perimeter().judge(edit_q) == geometry::Verdict::valid)
      add({pair.p.begin.place, pair.p.end.place, Refusal::none});
    return Refusal::perimeter;
  }
  void refused(const Side&, const Side&, double begin, double end, Refusal refusal) override {
    add({begin, end, refusal});
  }
  const std::vector<RefusedStretch>& stretches() const { return stretches_; }

 private:
  /// The longest are tried first, and most of what lies in them fails no later: that says nothing new.
  void add(const RefusedStretch& r) {
    const bool known = std::any_of(stretches_.begin(), stretches_.end(), [&](const RefusedStretch& s) {
      return s.begin <= r.begin && s.end >= r.end && progress(s.refusal) >= progress(r.refusal);
    });
    if (!known) stretches_.push_back(r);
  }

  std::vector<RefusedStretch> stretches_;
};

class Explanation {
 public:
  Explanation(const Complex& complex, const SharingReach& reach) : complex_(complex), reach_(reach) {
    complex.segments().for_each([&](const Segment& s) {
      if (s.polygon) polygons_.push_back(&s);
    });
    std::sort(polygons_.begin(), polygons_.end(),
              [](const Segment* a, const Segment* b) { return a->id < b->id; });
  }

  std::vector<OpenEdge> all() {
    for (const Segment* s : polygons_) look_around(*s);
    for (const Segment* s : polygons_) {
      for (const Segment* other : near(Box3(s->polygon->box)))
        if (s->id < other->id) look_along_line(*s, *other);
      look_at_corners(*s);
    }
    std::vector<OpenEdge> result;
    for (const auto& [edge, open] : found_) result.push_back(open);
    std::sort(result.begin(), result.end(), [](const OpenEdge& a, const OpenEdge& b) {
      return std::pair(a.segment, a.edge) < std::pair(b.segment, b.edge);
    });
    return result;
  }

 private:
  void note(const Segment& s, EdgeId edge, Refusal refusal, SegmentId other) {
    const auto [entry, is_new] = found_.try_emplace(edge.value, OpenEdge{s.id, edge, refusal, other});
    OpenEdge& open = entry->second;
    if (open.refusal == Refusal::alone && !reaches_far(refusal)) return;
    if (!is_new && progress(refusal) > progress(open.refusal)) open = {s.id, edge, refusal, other};
  }

  std::vector<const Segment*> near(const Box3& box) const {
    std::vector<std::uint32_t> slots;
    complex_.polygons().query(box, slots);
    std::vector<const Segment*> result;
    for (const std::uint32_t slot : slots) result.push_back(&complex_.at(slot));
    std::sort(result.begin(), result.end(), [](const Segment* a, const Segment* b) { return a->id < b->id; });
    return result;
  }

  /// Notes for each open edge of s what is near it.
  void look_around(const Segment& s) {
    const PolygonPart& part = *s.polygon;
    for (std::uint32_t i = 0; i < part.perimeter.slot_count(); ++i) {
      const Slot slot{i};
      if (!part.perimeter.alive(slot) || part.perimeter.node(slot).shared) continue;
      const EdgeId edge = part.perimeter.node(slot).edge;
      const Eigen::Vector3d middle = middle_of(part, slot);
      std::pair<Refusal, SegmentId> found{Refusal::alone, {}};
      for (const Segment* other : near(box_around(middle, 0)))
        if (other != &s && lies_near(complex_.setting(), *other->polygon, middle))
          if (const Refusal r = beside(part, *other->polygon, middle); progress(r) > progress(found.first))
            found = {r, other->id};
      note(s, edge, found.first, found.second);
    }
  }

  Refusal beside(const PolygonPart& part, const PolygonPart& other, const Eigen::Vector3d& p) const {
    if (part.plane().normal.dot(other.plane().normal) >= reach_.most_cosine(complex_.setting()))
      return Refusal::angle;
    const auto between = line_between(complex_.setting(), part, other, reach_);
    if (!between) return Refusal::line_far;
    const Eigen::Vector3d foot = between->line.at(between->line.place_of(p));
    return (p - foot).norm() < reach_at(p) ? Refusal::nothing_opposite : Refusal::line_far;
  }

  void look_along_line(const Segment& a, const Segment& b) {
    const auto between = line_between(complex_.setting(), *a.polygon, *b.polygon, reach_);
    if (!between) return;
    const auto chains = chains_of_both(complex_, a, b, between->line, between->window, reach_);
    if (!chains) return;
    Onlooker onlooker;
    double sign = 1;
    std::vector<RefusedStretch> stretches{{between->window.begin, between->window.end, Refusal::undecided}};
    if (chains->concavity != Concavity::undecided) {
      SectionSearch(complex_, a, b, between->line, reach_, *chains).run(onlooker);
      sign = chains->concavity == Concavity::convex ? 1 : -1;
      stretches = onlooker.stretches();
    }
    tell(a, chains->of_a, b, stretches, sign);
    tell(b, chains->of_b, a, stretches, sign);
  }

  /// Notes for each open edge on these chains of s the refusal of the stretch over its middle that came
  /// farthest. A place on a chain times `sign` is a place of the stretches.
  void tell(const Segment& s, const std::vector<LineChain>& chains, const Segment& other,
            const std::vector<RefusedStretch>& stretches, double sign) {
    struct Event {
      double place;
      int kind;  ///< −1: a stretch ends, 0: an edge, +1: a stretch begins
      std::size_t progress;
      EdgeId edge;
    };
    std::vector<Event> events;
    for (const RefusedStretch& r : stretches) {
      events.push_back({r.begin, 1, progress(r.refusal), {}});
      events.push_back({r.end, -1, progress(r.refusal), {}});
    }
    for (const LineChain& chain : chains)
      for (std::size_t i = 0; i < chain.edges.size(); ++i)
        if (const auto& node = s.polygon->perimeter.node(chain.edges[i]); !node.shared)
          events.push_back(
              {sign * (chain.stations[i].place + chain.stations[i + 1].place) / 2, 0, 0, node.edge});
    std::sort(events.begin(), events.end(), [](const Event& p, const Event& q) {
      return std::tie(p.place, p.kind, p.edge) < std::tie(q.place, q.kind, q.edge);
    });
    std::array<int, kRefusals + 1> active{};
    for (const Event& event : events) {
      if (event.kind != 0) {
        active[event.progress] += event.kind;
        continue;
      }
      const auto farthest = std::find_if(active.rbegin(), active.rend(), [](int count) { return count > 0; });
      if (farthest == active.rend()) continue;
      const auto at = static_cast<std::size_t>(active.rend() - farthest) - 1;
      note(s, event.edge, static_cast<Refusal>(at % kRefusals), other.id);
    }
  }

  /// Notes why no corner was formed for open edges between two shared ones, near where the corner would be.
  void look_at_corners(const Segment& s) {
    const auto& perimeter = s.polygon->perimeter;
    for (const EdgeId edge : s.polygon->shared) {
      const Slot slot = complex_.edges().at(edge).slot;
      if (perimeter.node(perimeter.next(slot)).shared) continue;
      Ring ring = ring_from(complex_, s, slot);
      if (ring.parts.empty()) continue;
      const RingPart& part = ring.parts.front();
      const Segment& beyond = complex_.at(complex_.edges().across(perimeter.node(part.after).edge).segment);
      const auto corner = place_of_corner(complex_, ring, part);
      if (!corner) continue;
      const Refusal refusal = edits_for(complex_, ring, reach_).refusal;
      for (std::size_t i = 0; i + 1 < part.between.size(); ++i)
        if ((middle_of(*s.polygon, part.between[i]) - *corner).norm() < reach_at(*corner))
          note(s, perimeter.node(part.between[i]).edge, refusal, beyond.id);
    }
  }

  static Eigen::Vector3d middle_of(const PolygonPart& part, Slot edge) {
    return (part.position(edge) + part.position(part.perimeter.next(edge))) / 2;
  }
  double reach_at(const Eigen::Vector3d& p) const {
    return reach_.section * complex_.setting().scale_at(p).lambda;
  }

  const Complex& complex_;
  SharingReach reach_;
  std::vector<const Segment*> polygons_;
  std::unordered_map<std::uint64_t, OpenEdge> found_;
};

}  // namespace

std::vector<OpenEdge> open_edges(const Complex& complex, const SharingReach& reach) {
  if (!complex.setting().parameters.neighbours) return {};
  return Explanation(complex, reach).all();
}

}  // namespace limpet::model::internal
