// Copyright the limpet authors. GPL-3.0-or-later.
#include "line_chains_internal.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <unordered_set>

#include <limpet/geometry/predicates.hpp>

namespace limpet::model::internal {
namespace {

using geometry::Point2;
using geometry::Slot;

class ChainWalk {
 public:
  ChainWalk(const Complex& complex, const Segment& a, const Segment& b, const CommonLine& line,
            const LineWindow& window, const SharingReach& reach)
      : complex_(complex),
        part_(*a.polygon),
        other_(b.slot),
        line_(line),
        view_(complex.setting(), *a.polygon, line),
        window_(window),
        section_(reach.section),
        reach_(
            section_ *
            complex.setting().largest_scale(middle_of(line, window), (window.end - window.begin) / 2).lambda),
        from_shared_(reach.from_shared) {}

  std::vector<LineChain> all() {
    std::vector<LineChain> chains;
    for (const auto& [edge, slot] : seeds())
      if (!visited_.count(static_cast<std::uint32_t>(slot))) chains.push_back(chain_through(slot));
    return chains;
  }

 private:
  static Eigen::Vector3d middle_of(const CommonLine& line, const LineWindow& window) {
    return line.at((window.begin + window.end) / 2);
  }
  Station station(Slot s) const { return view_.station(s); }
  double reach_at(double place) const {
    const Setting& setting = complex_.setting();
    return setting.resolution_grows() ? section_ * setting.scale_at(line_.at(place)).lambda : reach_;
  }
  bool near(const Station& s) const { return std::abs(s.offset) < reach_at(s.place); }

  /// May the chain go on along this edge?
  bool passable(Slot s) const {
    const auto& node = part_.perimeter.node(s);
    return !node.shared || complex_.edges().across(node.edge).segment == other_;
  }

  /// The edges near the line within the window, by identity.
  std::vector<std::pair<geometry::EdgeId, Slot>> seeds() const {
    std::vector<std::pair<geometry::EdgeId, Slot>> found;
    const Point2 across_window =
        part_.chart.project(line_.at(window_.end)) - part_.chart.project(line_.at(window_.begin));
    // Of boxes along the line, each enlarged by the reach, this number has the smallest total area.
    const double best =
        std::sqrt(std::abs(across_window.x * across_window.y)) * complex_.setting().step / (2 * reach_);
    const auto pieces = static_cast<int>(std::clamp(std::round(best), 1.0, 4096.0));
    for (int i = 0; i < pieces; ++i) {
      const double from = window_.begin + (window_.end - window_.begin) * i / pieces,
                   to = window_.begin + (window_.end - window_.begin) * (i + 1) / pieces;
      geometry::Box2 box;
      box.add(part_.chart.project(line_.at(from)));
      box.add(part_.chart.project(line_.at(to)));
      part_.perimeter.any_edge_near(box.grown(reach_ / complex_.setting().step), [&](Slot s) {
        // Shared edges join a chain from the open edges beside them. To join shared edges with each other,
        // chains start from these, too, but only when finishing.
        if (part_.perimeter.node(s).shared && !(from_shared_ && passable(s))) return false;
        const Station u = station(s), v = station(part_.perimeter.next(s));
        const bool beside = near(u) || near(v) || (u.offset < 0) != (v.offset < 0);
        if (beside && std::min(u.place, v.place) < window_.end && std::max(u.place, v.place) > window_.begin)
          found.emplace_back(part_.perimeter.node(s).edge, s);
        return false;
      });
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// The point where the edge from `from` to `far` leaves the strip around the line, on the side of `far`.
  Station cut(const Station& from, const Station& far) const {
    // Where λ grows with the range so does the strip's width, as good as evenly along an edge.
    const double here = std::copysign(0.999 * reach_at(from.place), far.offset),
                 there = std::copysign(0.999 * reach_at(far.place), far.offset);
    const double fraction = (here - from.offset) / (far.offset - from.offset - (there - here));
    const Point2 at = geometry::round_to_grid(from.at + fraction * (far.at - from.at));
    return {from.place + fraction * (far.place - from.place), here + fraction * (there - here), at,
            geometry::kNoSlot};
  }

  bool within_window(const Station& s) const {
    return s.place > window_.begin - reach_ && s.place < window_.end + reach_;
  }

  LineChain chain_through(Slot seed) {
    const auto& perimeter = part_.perimeter;
    std::deque<Station> stations;
    std::deque<Slot> edges{seed};
    visited_.insert(static_cast<std::uint32_t>(seed));
    const Station u = station(seed), v = station(perimeter.next(seed));
    stations.push_back(near(u) ? u : cut(v, u));
    stations.push_back(near(v) ? v : cut(u, v));
    while (stations.back().vertex != geometry::kNoSlot && within_window(stations.back())) {
      const Slot edge = stations.back().vertex;
      if (!passable(edge) || !visited_.insert(static_cast<std::uint32_t>(edge)).second) break;
      const Station next = station(perimeter.next(edge));
      edges.push_back(edge);
      stations.push_back(near(next) ? next : cut(stations.back(), next));
    }
    while (stations.front().vertex != geometry::kNoSlot && within_window(stations.front())) {
      const Slot edge = perimeter.prev(stations.front().vertex);
      if (!passable(edge) || !visited_.insert(static_cast<std::uint32_t>(edge)).second) break;
      const Station before = station(edge);
      edges.push_front(edge);
      stations.push_front(near(before) ? before : cut(stations.front(), before));
    }
    return {{stations.begin(), stations.end()}, {edges.begin(), edges.end()}};
  }

  const Complex& complex_;
  const PolygonPart& part_;
  std::uint32_t other_;
  const CommonLine& line_;
  LineView view_;
  LineWindow window_;
  double section_;  ///< SharingReach::section
  double reach_;    ///< the same where λ is largest in the window, scan's unit
  bool from_shared_;
  std::unordered_set<std::uint32_t> visited_;
};

/// The interval of the line that an edge of a chain covers, and whether the edge runs along the line
/// (forward).
struct Stretch {
  double begin, end;
  bool forward;
};

std::vector<Stretch> stretches_of(const std::vector<LineChain>& chains) {
  std::vector<Stretch> result;
  for (const LineChain& chain : chains)
    for (std::size_t i = 0; i + 1 < chain.stations.size(); ++i) {
      const double p = chain.stations[i].place, q = chain.stations[i + 1].place;
      if (p != q) result.push_back({std::min(p, q), std::max(p, q), p < q});
    }
  return result;
}

}  // namespace

bool clip(LineWindow& window, const CommonLine& line, const Box3& box) {
  for (int i = 0; i < 3; ++i) {
    const double o = line.origin[i], d = line.along[i];
    if (std::abs(d) < 1e-12) {
      if (o < box.min()[i] || o > box.max()[i]) return false;
      continue;
    }
    const double p = (box.min()[i] - o) / d, q = (box.max()[i] - o) / d;
    window.begin = std::max(window.begin, std::min(p, q));
    window.end = std::min(window.end, std::max(p, q));
  }
  return window.begin < window.end;
}

std::optional<LineBetween> line_between(const Setting& setting, const PolygonPart& a, const PolygonPart& b,
                                        const SharingReach& sharing) {
  const geometry::Plane pa = a.plane(), pb = b.plane();
  if (pa.normal.dot(pb.normal) >= sharing.most_cosine(setting)) return std::nullopt;
  const Box3 both(a.box.min().cwiseMax(b.box.min()), a.box.max().cwiseMin(b.box.max()));
  const auto line = common_line(pa, pb, (both.min() + both.max()) / 2);
  if (!line) return std::nullopt;
  constexpr double kFar = std::numeric_limits<double>::max() / 4;
  LineWindow window{-kFar, kFar};
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(
      sharing.at_angle(setting.largest_scale(both).lambda, setting.parameters.tolerance, line->sine));
  for (const PolygonPart* part : {&a, &b})
    if (!clip(window, *line, Box3(part->box.min() - reach, part->box.max() + reach))) return std::nullopt;
  return LineBetween{*line, window};
}

std::vector<LineChain> line_chains(const Complex& complex, const Segment& a, const Segment& b,
                                   const CommonLine& line, const LineWindow& window,
                                   const SharingReach& reach) {
  return ChainWalk(complex, a, b, line, window, reach).all();
}

Concavity concavity_of(const Complex& complex, const Segment& a, const Segment& b, const CommonLine& line,
                       const std::vector<LineChain>& chains_a, const std::vector<LineChain>& chains_b) {
  if (const auto shared = complex.edges_between(a, b); !shared.empty()) {
    const geometry::EdgeId edge =
        a.slot < b.slot ? shared.front() : complex.edges().at(shared.front()).partner;
    const Slot s = complex.edges().at(edge).slot;
    const bool forward = line.place_of(a.polygon->position(s)) <
                         line.place_of(a.polygon->position(a.polygon->perimeter.next(s)));
    return forward ? Concavity::convex : Concavity::concave;
  }
  // The two registers of §2.6.1: total overlap of edges that run in opposite directions.
  double convex = 0, concave = 0;
  const auto of_b = stretches_of(chains_b);
  for (const Stretch& p : stretches_of(chains_a))
    for (const Stretch& q : of_b) {
      const double overlap = std::min(p.end, q.end) - std::max(p.begin, q.begin);
      if (overlap > 0 && p.forward != q.forward) (p.forward ? convex : concave) += overlap;
    }
  if (convex == concave) return Concavity::undecided;
  return convex > concave ? Concavity::convex : Concavity::concave;
}

}  // namespace limpet::model::internal
