// Copyright the limpet authors. GPL-3.0-or-later.
//
// Step 4 of the update: forming shared edges (thesis §2.6). A section P of one perimeter and a section Q of
// the other are extended to a section L of the line where the two planes meet.
#include <algorithm>
#include <utility>

#include "redundancy_internal.hpp"
#include "section_search_internal.hpp"
#include "sharing_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;

/// The result of a look at two segments.
enum class Formed {
  not_near,  ///< one of them has no edge near the line: nothing was attempted
  none,
  in_order,
  disordered  ///< formed, but undone, because it broke an ordering
};

/// Puts L into both perimeters, as a shared edge, or into none.
class PairFormer : public SectionUser {
 public:
  PairFormer(Complex& complex, Agenda& agenda, const Segment& a, const Segment& b)
      : complex_(complex), agenda_(agenda), a_(a), b_(b) {}

  Refusal form(const SectionPair& pair) override {
    const EdgeId id_p = complex_.edge_ids().take(), id_q = complex_.edge_ids().take();
    Transaction transaction;
    transaction.edits.emplace_back(a_.slot, edit_for(pair.side_p, pair.p, pair.begin_p, pair.end_p, id_p));
    transaction.edits.emplace_back(b_.slot, edit_for(pair.side_q, pair.q, pair.begin_q, pair.end_q, id_q));
    transaction.pairs.emplace_back(id_p, id_q);
    if (!complex_.commit(transaction)) return Refusal::perimeter;
    complex_.tell_shared(a_, b_, id_p, id_q);
    complex_.keep_ends_in_place(transaction);
    if (!complex_.edges().shared(id_p)) {
      agenda_.note_disorder(a_.id, b_.id);
      formed_ = Formed::disordered;
      return Refusal::none;
    }
    formed_ = pair.joins || order_stays(complex_, id_p) || keeps_order(id_p) ? Formed::in_order
                                                                             : Formed::disordered;
    return Refusal::none;
  }

  Formed formed() const { return formed_; }

 private:
  /// Unshares a new edge that breaks an ordering; the two segments form no other before the next set. (The
  /// thesis dissolves all edges that the two share, §2.6; but without the new one the orderings held.)
  bool keeps_order(EdgeId edge) {
    if (!is_disordered(complex_, a_) && !is_disordered(complex_, b_)) return true;
    agenda_.note_disorder(a_.id, b_.id);
    complex_.unshare(edge);
    return false;
  }

  Complex& complex_;
  Agenda& agenda_;
  const Segment &a_, &b_;
  Formed formed_ = Formed::none;
};

/// Forms one pair of shared edges, the first that SectionSearch finds, if there is one.
Formed share_once(Complex& complex, Agenda& agenda, const Segment& a, const Segment& b,
                  const CommonLine& line, const LineWindow& window) {
  const auto chains = chains_of_both(complex, a, b, line, window, agenda.sharing);
  if (!chains) return Formed::not_near;
  if (chains->concavity == Concavity::undecided) return Formed::none;
  PairFormer former(complex, agenda, a, b);
  SectionSearch(complex, a, b, line, agenda.sharing, *chains).run(former);
  return former.formed();
}

bool may_share(const Agenda& agenda, const Segment& s) {
  return s.polygon && (agenda.finishing || !s.young());
}

/// The parts of a window where the line comes near the changed places, extended by kSectionReachOn at both
/// ends.
std::vector<LineWindow> changed_windows(const Setting& setting, const SharingReach& sharing,
                                        const CommonLine& line, const LineWindow& window,
                                        const DirtyRegion& places) {
  std::vector<LineWindow> result;
  for (const Box3& box : places.boxes()) {
    LineWindow piece = window;
    const double lambda = setting.largest_scale(box).lambda, on = kSectionReachOn * lambda;
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(sharing.section * lambda);
    if (!clip(piece, line, Box3(box.min() - reach, box.max() + reach))) continue;
    result.push_back({std::max(window.begin, piece.begin - on), std::min(window.end, piece.end + on)});
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

/// Two segments that are no neighbours can only become so along open edges of both.
bool cannot_share(const Complex& complex, const Segment& a, const Segment& b) {
  const auto is_all_shared = [](const PolygonPart& part) {
    return part.shared.size() == part.perimeter.edge_count();
  };
  return (is_all_shared(*a.polygon) || is_all_shared(*b.polygon)) && complex.edges_between(a, b).empty();
}

bool share_pair(Complex& complex, Agenda& agenda, const Segment& a, const Segment& b,
                const DirtyRegion& places) {
  if (agenda.in_disorder(a.id, b.id) || cannot_share(complex, a, b)) return false;
  const Setting& setting = complex.setting();
  const auto line = line_between(setting, *a.polygon, *b.polygon, agenda.sharing);
  if (!line) return false;
  int count = 0;
  bool attempted = false, disordered = false;
  for (const LineWindow& piece : changed_windows(setting, agenda.sharing, line->line, line->window, places))
    while (count < kMaxPairsFormed && !disordered) {
      const Formed formed = share_once(complex, agenda, a, b, line->line, piece);
      attempted |= formed != Formed::not_near;
      disordered = formed == Formed::disordered;
      if (formed != Formed::in_order) break;
      ++count;
    }
  if (count == 0 && attempted && complex.edges_between(a, b).empty())
    note_if_redundant(setting, agenda, a, b);
  return count > 0;
}

/// Is it time to look at a changed polygon again? Most looks at a perimeter that still grows are in vain, so
/// the next one waits until the polygon has one part in kGrowthPart more points.
bool is_due(const Agenda& agenda, const Segment& s) {
  return may_share(agenda, s) && (agenda.finishing || s.count() >= agenda.polygon(s.slot).next_share);
}

/// Notes on the agenda which pairs are to be looked at because of what has changed, and where.
void note_looks_due(const Complex& complex, Agenda& agenda) {
  const Turn turn = polygons_of(complex, agenda.take_to_share(),
                                [&](const Segment& s) { return !agenda.polygon(s.slot).unshared.empty(); });
  for (const auto& [id, slot] : turn) {
    const Segment& s = complex.at(slot);
    if (!is_due(agenda, s)) {
      agenda.wait_to_share(slot);
      continue;
    }
    PolygonDue& due = agenda.polygon(slot);
    due.next_share = s.count() + s.count() / kGrowthPart;
    const DirtyRegion changed = std::exchange(due.unshared, {});
    for (const auto& [other_id, other] : polygons_near(complex, changed, slot)) {
      if (!may_share(agenda, complex.at(other))) continue;
      DirtyRegion& where = agenda.look_due(std::minmax(slot, other));
      for (const Box3& place : changed.boxes())
        if (complex.at(other).indexed.intersects(place)) where.add(place);
    }
  }
}

}  // namespace

bool share_modified(Complex& complex, Agenda& agenda) {
  if (!complex.setting().parameters.neighbours) return false;
  note_looks_due(complex, agenda);
  std::int64_t looks = agenda.looks_for(complex.now());
  bool any = false;
  while (agenda.looks_due() && (agenda.finishing || looks-- > 0) && !agenda.stopped()) {
    const auto [pair, places] = agenda.take_look();
    const Segment *a = complex.in_slot(pair.first), *b = complex.in_slot(pair.second);
    if (a && b && may_share(agenda, *a) && may_share(agenda, *b))
      any |= share_pair(complex, agenda, *a, *b, places);
  }
  return any;
}

}  // namespace limpet::model::internal
