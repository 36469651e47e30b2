// Copyright the limpet authors. GPL-3.0-or-later.
//
// Step 4 of the update: forming shared edges (thesis §2.6). A section P of one perimeter and a section Q of
// the other are extended to a section L of the line where the two planes meet.
#include <algorithm>
#include <utility>

#include "section_search_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;

constexpr int kMaxPairsFormed = 64;  ///< by one look at two segments

/// What came of a look at two segments.
enum class Formed {
  not_near,  ///< one has no edge near the line: nothing was attempted
  none,
  in_order,
  disordered  ///< and undone
};

/// Puts L into both perimeters, or into none.
class PairFormer : public SectionUser {
 public:
  PairFormer(Engine& e, Segment& a, Segment& b) : e_(e), a_(a), b_(b) {}

  Refusal form(const SectionPair& pair) override {
    const EdgeId id_p = e_.edge_ids.take(), id_q = e_.edge_ids.take();
    const auto edit_p = edit_for(pair.side_p, pair.p, pair.begin_p, pair.end_p, id_p),
               edit_q = edit_for(pair.side_q, pair.q, pair.begin_q, pair.end_q, id_q);
    geometry::Polygon &of_a = a_.polygon->perimeter, &of_b = b_.polygon->perimeter;
    if (of_a.judge(edit_p) != geometry::Verdict::valid || of_b.judge(edit_q) != geometry::Verdict::valid)
      return Refusal::perimeter;
    of_a.commit(edit_p, e_.edge_ids);
    of_b.commit(edit_q, e_.edge_ids);
    pair_edges(e_, a_, id_p, b_, id_q);
    perimeter_changed(e_, a_);
    perimeter_changed(e_, b_);
    e_.changes.push_back({Change::Kind::shared, a_.id, b_.id, {}, {id_p, id_q}});
    formed_ =
        pair.joins || order_stays(e_, id_p) || keeps_order(id_p) ? Formed::in_order : Formed::disordered;
    return Refusal::none;
  }

  Formed formed() const { return formed_; }

 private:
  /// An edge that breaks an order goes again, and the two form no other before the next set. (The thesis
  /// dissolves all that the two share, §2.6; but the order held before.)
  bool keeps_order(EdgeId edge) {
    if (!is_disordered(e_, a_) && !is_disordered(e_, b_)) return true;
    e_.disordered.insert(std::minmax(a_.id, b_.id));
    unshare(e_, edge);
    return false;
  }

  Engine& e_;
  Segment &a_, &b_;
  Formed formed_ = Formed::none;
};

/// Forms one pair of shared edges, if one can be: the longest.
Formed share_once(Engine& e, Segment& a, Segment& b, const CommonLine& line, const LineWindow& window) {
  const auto chains = chains_of_both(e, a, b, line, window, e.sharing);
  if (!chains) return Formed::not_near;
  if (chains->concavity == Concavity::undecided) return Formed::none;
  PairFormer former(e, a, b);
  SectionSearch(e, a, b, line, e.sharing, *chains).run(former);
  return former.formed();
}

bool may_share(const Engine& e, const Segment& s) { return s.polygon && (e.finishing || !s.young()); }

/// The pieces of a window where the line comes near places where s has changed, and some way on.
std::vector<LineWindow> changed_windows(const Engine& e, const CommonLine& line, const LineWindow& window,
                                        const Places& places) {
  constexpr double kOn = 2;  // λ: so far sections may reach beyond what has changed, at a time
  const double lambda = e.parameters.resolution;
  std::vector<LineWindow> result;
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(e.sharing.section * lambda);
  for (const Box3& box : places.boxes()) {
    LineWindow piece = window;
    if (!clip(piece, line, Box3(box.min() - reach, box.max() + reach))) continue;
    result.push_back(
        {std::max(window.begin, piece.begin - kOn * lambda), std::min(window.end, piece.end + kOn * lambda)});
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
  if (e.disordered.count(std::minmax(a.id, b.id))) return false;
  const auto line = line_between(e, *a.polygon, *b.polygon);
  if (!line) return false;
  int count = 0;
  bool attempted = false, disordered = false;
  for (const LineWindow& piece : changed_windows(e, line->line, line->window, places))
    while (count < kMaxPairsFormed && !disordered) {
      const Formed formed = share_once(e, a, b, line->line, piece);
      attempted |= formed != Formed::not_near;
      disordered = formed == Formed::disordered;
      if (formed != Formed::in_order) break;
      ++count;
    }
  if (count == 0 && attempted && edges_between(e, a, b).empty()) note_if_redundant(e, a, b);
  return count > 0;
}

/// Is it time to look at a polygon that has changed? Where perimeters still grow, most looks are in vain, so
/// it is looked at again when it has a thirty-second part more points.
bool is_due(const Engine& e, const Segment& s) {
  return may_share(e, s) && (e.finishing || s.moments.count() >= s.polygon->next_share);
}

/// Which pairs are to be looked at, and where, because of what has changed.
void note_looks_due(Engine& e) {
  constexpr int kWaitingSeen = 8;  // of those that wait, in a set; they have most often been modified, too
  for (int i = 0; i < kWaitingSeen && !e.share_later.empty(); ++i) {
    e.to_share.push_back(e.share_later.front());
    e.share_later.pop_front();
    if (Segment* s = e.segments[e.to_share.back()].get(); s && s->polygon) s->polygon->shared_later = false;
  }
  const Turn turn =
      polygons_of(e, e.to_share, [](const PolygonPart& part) { return !part.unshared.empty(); });
  e.to_share.clear();
  for (const auto& [id, slot] : turn) {
    Segment& s = e.at(slot);
    if (!is_due(e, s)) {
      if (!std::exchange(s.polygon->shared_later, true)) e.share_later.push_back(slot);
      continue;
    }
    s.polygon->next_share = s.moments.count() + s.moments.count() / 32;
    const Places changed = std::exchange(s.polygon->unshared, {});
    for (const auto& [other_id, other] : polygons_near(e, changed, slot)) {
      if (!may_share(e, e.at(other))) continue;
      Places& where = e.looks_due[std::minmax(slot, other)];
      for (const Box3& place : changed.boxes())
        if (e.at(other).indexed.intersects(place)) where.add(place);
    }
  }
}

/// Takes the next look from those that are due, in turn.
std::pair<SlotPair, Places> next_look(Engine& e) {
  auto next = e.looks_due.upper_bound(e.last_look);
  if (next == e.looks_due.end()) next = e.looks_due.begin();
  e.last_look = next->first;
  return {next->first, std::move(e.looks_due.extract(next).mapped())};
}

}  // namespace

bool share_modified(Engine& e) {
  if (!e.parameters.neighbours) return false;
  note_looks_due(e);
  // A large polygon asks for many looks at once: they are spread over the sets, one for every four points.
  std::int64_t looks = 4 + (e.counts.points - std::exchange(e.looked_at, e.counts.points)) / 4;
  bool any = false;
  while (!e.looks_due.empty() && (e.finishing || looks-- > 0)) {
    const auto [pair, places] = next_look(e);
    Segment *a = e.segments[pair.first].get(), *b = e.segments[pair.second].get();
    if (a && b && may_share(e, *a) && may_share(e, *b)) any |= share_pair(e, *a, *b, places);
  }
  return any;
}

}  // namespace limpet::model::internal
