// Copyright the limpet authors. GPL-3.0-or-later.
//
// Step 4 of the update: forming shared edges (thesis §2.6). A section P of one perimeter and a section Q of
// the other are extended to a section L of the line where the two planes meet.
#include <algorithm>
#include <cmath>
#include <set>

#include <limpet/geometry/predicates.hpp>

#include "line_chains_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;
using geometry::Point2;
using geometry::Slot;

constexpr int kMaxPairsFormed = 64;  ///< by one look at two segments
constexpr double kSameSteps = 3;     ///< grid steps: nearer than this a cut is at the vertex itself

/// One side of a pair to be: a chain turned so that places rise along it, and the perimeter it is on.
struct Side {
  Segment* segment = nullptr;
  const LineChain* chain = nullptr;
  bool reversed = false;  ///< the perimeter runs against the chain

  std::size_t size() const { return chain->stations.size(); }
  const Station& station(std::size_t i) const { return chain->stations[i]; }
  const geometry::Polygon& perimeter() const { return segment->polygon->perimeter; }
  bool shared(std::size_t edge) const { return perimeter().node(chain->edges[edge]).shared; }
  /// Does a shared edge of the two end here?
  bool anchor(std::size_t i) const { return (i > 0 && shared(i - 1)) || (i + 1 < size() && shared(i)); }
};

/// P, or Q: what lies between two places on a chain.
struct Section {
  Station begin, end;
  std::size_t first_edge = 0, last_edge = 0;          ///< `begin` is on the first of these, `end` on the last
  bool begin_anchored = false, end_anchored = false;  ///< a shared edge of the two begins, ends there
};

/// The chain with places that rise along L, and offsets that are positive inside.
LineChain turned(LineChain chain, bool reverse, double sign) {
  if (reverse) {
    std::reverse(chain.stations.begin(), chain.stations.end());
    std::reverse(chain.edges.begin(), chain.edges.end());
  }
  for (Station& s : chain.stations) s.place *= sign, s.offset *= reverse ? -sign : sign;
  return chain;
}

/// The point at this place between two stations, or the one of them that it is hardly beside.
Station between(const Station& a, const Station& b, double place) {
  const double fraction = (place - a.place) / (b.place - a.place);
  Station s{place, a.offset + fraction * (b.offset - a.offset),
            geometry::round_to_grid(a.at + fraction * (b.at - a.at)), geometry::kNoSlot};
  for (const Station* end : {&a, &b})
    if (geometry::squared_length(s.at - end->at) <= kSameSteps * kSameSteps)
      s.at = end->at, s.vertex = end->vertex, s.offset = end->offset;
  return s;
}

/// The part of the chain that leads from place `begin` to place `end` and projects into L; nothing if there
/// is none, or an end of it would fall inside a shared edge.
std::optional<Section> section_of(const Side& side, double begin, double end) {
  std::optional<std::size_t> low;
  for (std::size_t i = 0; i < side.size(); ++i) {
    if (side.station(i).place <= begin) low = i;
    if (side.station(i).place < end || !low || *low == i) continue;
    Section s;
    const Station &a = side.station(*low), &b = side.station(*low + 1);
    s.first_edge = *low, s.last_edge = i - 1;
    if (a.place < begin && side.shared(*low)) return std::nullopt;
    s.begin = a.place == begin ? a : between(a, b, begin);
    s.begin_anchored = a.place == begin && side.anchor(*low);
    const Station &c = side.station(i - 1), &d = side.station(i);
    if (d.place > end && side.shared(i - 1)) return std::nullopt;
    s.end = d.place == end ? d : between(c, d, end);
    s.end_anchored = d.place == end && side.anchor(i);
    return s;
  }
  return std::nullopt;
}

/// The shared edges on a section, ascending, and the length along the line of the open ones.
struct Content {
  std::vector<EdgeId> shared;
  double open = 0;
};

Content content_of(const Side& side, const Section& section) {
  Content content;
  for (std::size_t i = section.first_edge; i <= section.last_edge; ++i) {
    if (side.shared(i)) {
      content.shared.push_back(side.perimeter().node(side.chain->edges[i]).edge);
      continue;
    }
    const double from = std::max(side.station(i).place, section.begin.place),
                 to = std::min(side.station(i + 1).place, section.end.place);
    content.open += std::max(0.0, to - from);
  }
  std::sort(content.shared.begin(), content.shared.end());
  return content;
}

/// Where P is farther than λ from L there must be nothing but bays that chance alone leaves (rule `voids`).
bool near_or_by_chance(const Engine& e, const Side& side, const Section& section) {
  const double lambda = e.parameters.resolution;
  const auto m = side.segment->moments.count();
  const double density = static_cast<double>(m) / side.perimeter().area();
  double area = 0;  // of the bay that P is in
  std::size_t points = 0;
  bool far = false;
  const auto bay_ends = [&] {
    const bool chance =
        !far || (m > 0 && empty_by_chance(area / (e.step * e.step), points, m, density, e.gap));
    area = 0, points = 0, far = false;
    return chance;
  };
  Station last = section.begin;
  const auto go_on_to = [&](const Station& next) {
    if (next.offset <= -lambda) return false;  // the segment goes on beyond the line
    area += (next.place - last.place) * (last.offset + next.offset) / 2;
    ++points;
    far |= next.offset >= lambda;
    last = next;
    return next.offset >= lambda / 4 || bay_ends();
  };
  for (std::size_t i = section.first_edge + 1; i <= section.last_edge; ++i)
    if (!go_on_to(side.station(i))) return false;
  return section.begin.offset > -lambda && go_on_to(section.end) && bay_ends();
}

/// The change of one perimeter: `section` gives way to the edge `id` between the chart points l1 and l2.
geometry::Edit edit_for(const Side& side, const Section& section, Point2 l1, Point2 l2, EdgeId id) {
  const bool r = side.reversed;
  const Station &first = r ? section.end : section.begin, &last = r ? section.begin : section.end;
  const bool first_anchored = r ? section.end_anchored : section.begin_anchored,
             last_anchored = r ? section.begin_anchored : section.end_anchored;
  const Slot first_edge = side.chain->edges[r ? section.last_edge : section.first_edge],
             last_edge = side.chain->edges[r ? section.first_edge : section.last_edge];
  if (r) std::swap(l1, l2);
  const bool first_cut = first.vertex == geometry::kNoSlot, last_cut = last.vertex == geometry::kNoSlot;

  geometry::Chain chain{
      first_cut ? first_edge : first.vertex, {}, last_cut ? side.perimeter().next(last_edge) : last.vertex};
  if (first_cut && first.at != l1) chain.via.push_back({first.at});
  if (!first_cut && (first_anchored || first.at == l1)) {
    chain.edge = id, chain.shared = true;
  } else {
    chain.via.push_back({l1, id, true});
  }
  if (last_cut || (!last_anchored && last.at != l2)) chain.via.push_back({l2});
  if (last_cut && last.at != l2) chain.via.push_back({last.at});
  geometry::Edit edit;
  edit.chains.push_back(std::move(chain));
  return edit;
}

/// What came of a look at two segments.
enum class Formed {
  not_near,  ///< one has no edge near the line: nothing was attempted
  none,
  in_order,  ///< where the orderings stay what they were
  to_be_ordered
};

/// Forms pairs from chains of two segments along their line.
class PairFormer {
 public:
  /// `sign`: of the direction of L along the line.
  PairFormer(Engine& e, Segment& a, Segment& b, const CommonLine& line, double sign,
             const std::vector<LineChain>& chains_a, const std::vector<LineChain>& chains_b)
      : e_(e), a_(a), b_(b), line_(line), sign_(sign) {
    for (const LineChain& chain : chains_a) chains_p_.push_back(turned(chain, false, sign));
    for (const LineChain& chain : chains_b) chains_q_.push_back(turned(chain, true, sign));
    beyond_p_ = beyond_line(chains_p_);
    beyond_q_ = beyond_line(chains_q_);
    // At the apex of a pyramid opposite faces come within λ of their common line, too, for about as long.
    const bool neighbours = !edges_between(e, a, b).empty();
    least_length_ = neighbours ? kLeastSharedSteps * e.step : e.least_shared * e.parameters.resolution;
  }

  /// Forms the longest pair that can be formed from any two of the chains.
  Formed form_one() {
    for (p_at_ = 0; p_at_ < chains_p_.size(); ++p_at_)
      for (q_at_ = 0; q_at_ < chains_q_.size(); ++q_at_)
        if (form(chains_p_[p_at_], chains_q_[q_at_])) return formed_;
    return Formed::none;
  }

 private:
  /// A stretch of a chain that lies beyond the line.
  struct Beyond {
    double begin, end;
    std::size_t chain;
  };

  bool form(const LineChain& p, const LineChain& q) {
    p_ = {&a_, &p, false}, q_ = {&b_, &q, true};
    const auto [low_p, high_p] = range(p);
    const auto [low_q, high_q] = range(q);
    const double low = std::max(low_p, low_q), high = std::min(high_p, high_q);
    if (high - low < least_length_) return false;
    places_ = {low, high};
    for (const LineChain* chain : {&p, &q})
      for (const Station& s : chain->stations)
        if (s.place > low && s.place < high) places_.push_back(s.place);
    std::sort(places_.begin(), places_.end());
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    return form_between(0, places_.size() - 1);
  }

  static std::pair<double, double> range(const LineChain& chain) {
    const auto [low, high] =
        std::minmax_element(chain.stations.begin(), chain.stations.end(),
                            [](const Station& a, const Station& b) { return a.place < b.place; });
    return {low->place, high->place};
  }

  static std::vector<Beyond> beyond_line(const std::vector<LineChain>& chains) {
    std::vector<Beyond> result;
    for (std::size_t c = 0; c < chains.size(); ++c)
      for (std::size_t i = 0; i + 1 < chains[c].stations.size(); ++i) {
        const Station &u = chains[c].stations[i], &v = chains[c].stations[i + 1];
        if (u.offset > 0 && v.offset > 0) continue;
        result.push_back({std::min(u.place, v.place), std::max(u.place, v.place), c});
      }
    return result;
  }

  /// Does another chain lie beyond the line there? Then the segment goes on, and what looks like a border on
  /// L is the far side of a hole.
  bool goes_on_beyond(double begin, double end) const {
    const double least = kLeastSharedSteps * e_.step;
    const auto meets = [&](const std::vector<Beyond>& beyond, std::size_t own) {
      return std::any_of(beyond.begin(), beyond.end(), [&](const Beyond& w) {
        return w.chain != own && std::min(w.end, end) - std::max(w.begin, begin) > least;
      });
    };
    return meets(beyond_p_, p_at_) || meets(beyond_q_, q_at_);
  }

  /// Tries sections from near the one place to near the other, longest first; where none will do, those in
  /// each half.
  bool form_between(std::size_t low, std::size_t high) {
    constexpr std::size_t kEnds = 4;
    for (std::size_t less = 0; less < 2 * kEnds - 1; ++less)
      for (std::size_t i = less < kEnds ? 0 : less - kEnds + 1; i <= std::min(less, kEnds - 1); ++i)
        if (low + i + (less - i) < high && form_section(places_[low + i], places_[high - (less - i)]))
          return true;
    if (high - low < 2) return false;
    const std::size_t middle = low + (high - low) / 2;
    return form_between(low, middle) || form_between(middle, high);
  }

  bool form_section(double begin, double end) {
    const double least = kLeastSharedSteps * e_.step;
    if (end - begin < least_length_ || goes_on_beyond(begin, end)) return false;
    const auto p = section_of(p_, begin, end), q = section_of(q_, begin, end);
    if (!p || !q) return false;
    const Content on_p = content_of(p_, *p), on_q = content_of(q_, *q);
    // Part of an open edge on both, or shared edges that become one.
    const bool gains = (on_p.open >= least && on_q.open >= least) || on_p.shared.size() >= 2;
    if (!gains || !correspond(on_p.shared, on_q.shared)) return false;
    if (!near_or_by_chance(e_, p_, *p) || !near_or_by_chance(e_, q_, *q)) return false;
    if (!commit(*p, *q)) return false;
    formed_ =
        !on_p.shared.empty() || order_stays(e_, formed_edge_) ? Formed::in_order : Formed::to_be_ordered;
    return true;
  }

  /// Are these the same pairs?
  bool correspond(const std::vector<EdgeId>& on_p, const std::vector<EdgeId>& on_q) const {
    if (on_p.size() != on_q.size()) return false;
    return std::all_of(on_p.begin(), on_p.end(), [&](EdgeId edge) {
      return std::binary_search(on_q.begin(), on_q.end(), e_.shared.at(edge.value).partner);
    });
  }

  Point2 seen_in(const Segment& s, double place) const {
    return geometry::round_to_grid(s.polygon->chart.project(line_.at(sign_ * place)));
  }

  bool commit(const Section& p, const Section& q) {
    // An end that is anchored on one side only would leave the copies apart.
    if (p.begin_anchored != q.begin_anchored || p.end_anchored != q.end_anchored) return false;
    const EdgeId id_p = e_.edge_ids.take(), id_q = e_.edge_ids.take();
    const auto edit_p = edit_for(p_, p, seen_in(a_, p.begin.place), seen_in(a_, p.end.place), id_p);
    const auto edit_q = edit_for(q_, q, seen_in(b_, p.begin.place), seen_in(b_, p.end.place), id_q);
    if (a_.polygon->perimeter.judge(edit_p) != geometry::Verdict::valid ||
        b_.polygon->perimeter.judge(edit_q) != geometry::Verdict::valid)
      return false;
    a_.polygon->perimeter.commit(edit_p, e_.edge_ids);
    b_.polygon->perimeter.commit(edit_q, e_.edge_ids);
    pair_edges(e_, a_, id_p, b_, id_q);
    perimeter_changed(e_, a_);
    perimeter_changed(e_, b_);
    e_.changes.push_back({Change::Kind::shared, a_.id, b_.id, {}, {id_p, id_q}});
    formed_edge_ = id_p;
    return true;
  }

  Engine& e_;
  Segment &a_, &b_;
  const CommonLine& line_;
  double sign_;
  double least_length_;  ///< of L, scan's unit
  std::vector<LineChain> chains_p_, chains_q_;
  std::vector<Beyond> beyond_p_, beyond_q_;
  std::size_t p_at_ = 0, q_at_ = 0;  ///< the chains in hand
  Side p_, q_;
  std::vector<double> places_;
  Formed formed_ = Formed::none;
  EdgeId formed_edge_;
};

/// By identity: the ends of a corresponding pair are at one place, that of a's copy.
void match_places(Engine& e, const Segment& a, const Segment& b, const CommonLine& line,
                  std::vector<LineChain>& chains_b) {
  const LineView view(e, *a.polygon, line);
  const auto place_on_a = [&](Slot s) { return view.station(s).place; };
  for (LineChain& chain : chains_b)
    for (std::size_t i = 0; i < chain.edges.size(); ++i) {
      const auto& node = b.polygon->perimeter.node(chain.edges[i]);
      if (!node.shared) continue;
      const Slot mine = across(e, node.edge).slot;
      chain.stations[i].place = place_on_a(a.polygon->perimeter.next(mine));
      chain.stations[i + 1].place = place_on_a(mine);
    }
}

/// Forms one pair of shared edges, if one can be.
Formed share_once(Engine& e, Segment& a, Segment& b, const CommonLine& line, const LineWindow& window) {
  const double reach = e.section_reach * e.parameters.resolution;
  const auto chains_a = line_chains(e, a, b, line, window, reach);
  if (chains_a.empty()) return Formed::not_near;
  auto chains_b = line_chains(e, b, a, line, window, reach);
  if (chains_b.empty()) return Formed::not_near;
  const Concavity concavity = concavity_of(e, a, b, line, chains_a, chains_b);
  if (concavity == Concavity::undecided) return Formed::none;
  match_places(e, a, b, line, chains_b);
  return PairFormer(e, a, b, line, concavity == Concavity::convex ? 1 : -1, chains_a, chains_b).form_one();
}

bool may_share(const Engine& e, const Segment& s) { return s.polygon && (e.finishing || !s.young()); }

/// The pieces of a window where the line comes near places where s has changed, and some way on.
std::vector<LineWindow> changed_windows(const Engine& e, const CommonLine& line, const LineWindow& window,
                                        const Places& places) {
  constexpr double kOn = 3;  // λ: so far sections may reach beyond what has changed, at a time
  const double lambda = e.parameters.resolution;
  std::vector<LineWindow> result;
  for (const Box3& box : places.boxes()) {
    const Eigen::Vector3d d = box.center() - line.origin;
    const double radius = box.diagonal().norm() / 2, reach = radius + 2 * lambda, at = line.along.dot(d);
    if (d.dot(d) - at * at >= reach * reach) continue;
    const LineWindow piece{std::max(window.begin, at - radius - kOn * lambda),
                           std::min(window.end, at + radius + kOn * lambda)};
    if (piece.begin < piece.end) result.push_back(piece);
  }
  std::sort(result.begin(), result.end(),
            [](const LineWindow& p, const LineWindow& q) { return p.begin < q.begin; });
  std::vector<LineWindow> joined;
  for (const LineWindow& piece : result)
    if (joined.empty() || joined.back().end < piece.begin)
      joined.push_back(piece);
    else
      joined.back().end = std::max(joined.back().end, piece.end);
  return joined;
}

bool share_pair(Engine& e, Segment& a, Segment& b, const Places& places) {
  const geometry::Plane pa = a.polygon->plane(), pb = b.polygon->plane();
  if (pa.normal.dot(pb.normal) >= e.cos_angle || e.disordered.count(std::minmax(a.id, b.id))) return false;
  const Box3 both(a.polygon->box.min().cwiseMax(b.polygon->box.min()),
                  a.polygon->box.max().cwiseMin(b.polygon->box.max()));
  const auto line = common_line(pa, pb, (both.min() + both.max()) / 2);
  if (!line) return false;
  const auto window = window_of(e, *line, *a.polygon, *b.polygon);
  if (!window) return false;
  int count = 0;
  bool disordered = false, attempted = false;
  for (const LineWindow& piece : changed_windows(e, *line, *window, places))
    while (count < kMaxPairsFormed) {
      const Formed formed = share_once(e, a, b, *line, piece);
      attempted |= formed != Formed::not_near;
      if (formed == Formed::none || formed == Formed::not_near) break;
      disordered |= formed == Formed::to_be_ordered;
      ++count;
    }
  if (count == 0 && attempted && edges_between(e, a, b).empty()) note_if_redundant(e, a, b);
  if (disordered) {
    dissolve_disordered(e, a);
    dissolve_disordered(e, b);
  }
  return count > 0;
}

}  // namespace

bool share_modified(Engine& e) {
  if (!e.parameters.neighbours) return false;
  std::vector<std::pair<SegmentId, std::uint32_t>> turn;
  for (const std::uint32_t slot : e.modified)
    if (e.segments[slot] && e.segments[slot]->polygon && !e.segments[slot]->polygon->unshared.empty())
      turn.emplace_back(e.segments[slot]->id, slot);
  std::sort(turn.begin(), turn.end());
  std::vector<Places> changed;
  for (const auto& [id, slot] : turn) changed.push_back(std::exchange(e.at(slot).polygon->unshared, {}));
  const auto changed_of = [&](SegmentId id) -> const Places* {
    const auto at = std::lower_bound(turn.begin(), turn.end(), std::pair(id, std::uint32_t{0}));
    return at != turn.end() && at->first == id ? &changed[static_cast<std::size_t>(at - turn.begin())]
                                               : nullptr;
  };
  std::set<std::pair<SegmentId, SegmentId>> done;
  bool any = false;
  for (std::size_t i = 0; i < turn.size(); ++i) {
    Segment& s = e.at(turn[i].second);
    if (!may_share(e, s)) continue;
    query(e.polygons, changed[i], e.found);
    std::vector<std::pair<SegmentId, std::uint32_t>> others;
    for (const std::uint32_t other : e.found)
      if (other != s.slot && may_share(e, e.at(other))) others.emplace_back(e.at(other).id, other);
    std::sort(others.begin(), others.end());
    for (const auto& [id, slot] : others) {
      Places places = changed[i];
      if (const Places* theirs = changed_of(id)) {  // looked at once, where either has changed
        const std::pair pair = std::minmax(s.id, id);
        if (done.count(pair)) continue;
        done.insert(pair);
        places.add(*theirs);
      }
      any |= share_pair(e, s, e.at(slot), places);
    }
  }
  return any;
}

}  // namespace limpet::model::internal
