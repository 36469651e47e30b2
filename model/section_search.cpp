// Copyright the limpet authors. GPL-3.0-or-later.
#include "section_search_internal.hpp"

#include <algorithm>

#include <limpet/geometry/predicates.hpp>

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;

std::pair<double, double> range(const LineChain& chain) {
  const auto [low, high] =
      std::minmax_element(chain.stations.begin(), chain.stations.end(),
                          [](const Station& a, const Station& b) { return a.place < b.place; });
  return {low->place, high->place};
}

/// Gives the ends of b's copies of shared edges the places of a's copies, so that they agree exactly.
void match_places(const Complex& complex, const Segment& a, const Segment& b, const CommonLine& line,
                  std::vector<LineChain>& chains_b) {
  const LineView view(complex.setting(), *a.polygon, line);
  const auto place_on_a = [&](geometry::Slot s) { return view.station(s).place; };
  for (LineChain& chain : chains_b)
    for (std::size_t i = 0; i < chain.edges.size(); ++i) {
      const auto& node = b.polygon->perimeter.node(chain.edges[i]);
      if (!node.shared) continue;
      const geometry::Slot mine = complex.edges().across(node.edge).slot;
      chain.stations[i].place = place_on_a(a.polygon->perimeter.next(mine));
      chain.stations[i + 1].place = place_on_a(mine);
    }
}

}  // namespace

std::optional<PairOfChains> chains_of_both(const Complex& complex, const Segment& a, const Segment& b,
                                           const CommonLine& line, const LineWindow& window,
                                           const SharingReach& sharing) {
  PairOfChains chains;
  chains.of_a = line_chains(complex, a, b, line, window, sharing);
  if (chains.of_a.empty()) return std::nullopt;
  chains.of_b = line_chains(complex, b, a, line, window, sharing);
  if (chains.of_b.empty()) return std::nullopt;
  chains.concavity = concavity_of(complex, a, b, line, chains.of_a, chains.of_b);
  match_places(complex, a, b, line, chains.of_b);
  return chains;
}

SectionSearch::SectionSearch(const Complex& complex, const Segment& a, const Segment& b,
                             const CommonLine& line, const SharingReach& reach, const PairOfChains& chains)
    : complex_(complex),
      a_(a),
      b_(b),
      line_(line),
      sign_(chains.concavity == Concavity::convex ? 1 : -1),
      reach_(reach),
      neighbours_(!complex.edges_between(a, b).empty()) {
  for (const LineChain& chain : chains.of_a) chains_p_.push_back(turned(chain, false, sign_));
  for (const LineChain& chain : chains.of_b) chains_q_.push_back(turned(chain, true, sign_));
  beyond_p_ = beyond_line(chains_p_);
  beyond_q_ = beyond_line(chains_q_);
}

/// Sets what follows from λ, as it is between two places on L.
void SectionSearch::set_scale(double low, double high) {
  const Setting& setting = complex_.setting();
  lambda_ = setting.scale_at(line_.at(sign_ * (low + high) / 2)).lambda;
  at_angle_ = reach_.at_angle(lambda_, setting.parameters.tolerance, line_.sine);
  overshoot_ = reach_.section > 1 ? lambda_ : 0;
  // The first shared edge has to be long: at the apex of a pyramid, opposite faces also come within λ of
  // their line, for about that length.
  least_length_ = neighbours_ ? kLeastSharedSteps * setting.step : reach_.least * lambda_;
}

bool SectionSearch::run(SectionUser& user) {
  user_ = &user;
  for (p_at_ = 0; p_at_ < chains_p_.size(); ++p_at_)
    for (q_at_ = 0; q_at_ < chains_q_.size(); ++q_at_)
      if (form(chains_p_[p_at_], chains_q_[q_at_])) return true;
  return false;
}

std::vector<SectionSearch::Beyond> SectionSearch::beyond_line(const std::vector<LineChain>& chains) {
  std::vector<Beyond> result;
  for (std::size_t c = 0; c < chains.size(); ++c)
    for (std::size_t i = 0; i + 1 < chains[c].stations.size(); ++i) {
      const Station &u = chains[c].stations[i], &v = chains[c].stations[i + 1];
      if (u.offset > 0 && v.offset > 0) continue;
      result.push_back({std::min(u.place, v.place), std::max(u.place, v.place), c});
    }
  return result;
}

/// Does another chain lie beyond the line there? Then the segment continues beyond it, and the chain on L is
/// only the far side of a hole.
bool SectionSearch::goes_on_beyond(double begin, double end) const {
  const double least = kLeastSharedSteps * complex_.setting().step;
  const auto meets = [&](const std::vector<Beyond>& beyond, std::size_t own) {
    return std::any_of(beyond.begin(), beyond.end(), [&](const Beyond& w) {
      return w.chain != own && std::min(w.end, end) - std::max(w.begin, begin) > least;
    });
  };
  return meets(beyond_p_, p_at_) || meets(beyond_q_, q_at_);
}

bool SectionSearch::form(const LineChain& p, const LineChain& q) {
  const auto [low_p, high_p] = range(p);
  const auto [low_q, high_q] = range(q);
  const double low = std::max(low_p, low_q), high = std::min(high_p, high_q);
  set_scale(low, high);
  // turned() has made places increase along the direction of L, and offsets positive on the inside.
  const Eigen::Vector3d along = sign_ * line_.along;
  p_ = {
      &a_, &p, false, at_angle_, line_.origin, along, sign_ * a_.polygon->plane().normal.cross(line_.along)};
  q_ = {
      &b_, &q, true, at_angle_, line_.origin, along, -sign_ * b_.polygon->plane().normal.cross(line_.along)};
  if (high - low < least_length_) {
    if (low < high) user_->refused(p_, q_, low, high, Refusal::short_section);
    return false;
  }
  places_ = {low, high};
  // Sections that end a little earlier, too: tiny edges around an apex may be in the way.
  const double trimmed = lambda_ / 8;
  if (overshoot_ > 0 && high - low > 4 * trimmed)
    places_.insert(places_.end(), {low + trimmed, high - trimmed});
  for (const LineChain* chain : {&p, &q})
    for (const Station& s : chain->stations)
      if (s.place > low && s.place < high) places_.push_back(s.place);
  std::sort(places_.begin(), places_.end());
  places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
  return form_between(0, places_.size() - 1);
}

/// Tries sections from one of the first few places to one of the last few, longest first; if none is formed,
/// tries each half.
bool SectionSearch::form_between(std::size_t low, std::size_t high) {
  constexpr std::size_t kEnds = 4;
  for (std::size_t less = 0; less < 2 * kEnds - 1; ++less)
    for (std::size_t i = less < kEnds ? 0 : less - kEnds + 1; i <= std::min(less, kEnds - 1); ++i)
      if (low + i + (less - i) < high && form_section(places_[low + i], places_[high - (less - i)]))
        return true;
  if (high - low < 2) return false;
  const std::size_t middle = low + (high - low) / 2;
  return form_between(low, middle) || form_between(middle, high);
}

bool SectionSearch::form_section(double begin, double end) {
  const Refusal refusal = try_section(begin, end);
  if (refusal == Refusal::none) return true;
  user_->refused(p_, q_, begin, end, refusal);
  return false;
}

Refusal SectionSearch::try_section(double begin, double end) {
  const double least = kLeastSharedSteps * complex_.setting().step;
  if (end - begin < least_length_) return Refusal::short_section;
  if (goes_on_beyond(begin, end)) return Refusal::goes_on;
  const auto p = section_of(p_, begin, end, overshoot_), q = section_of(q_, begin, end, overshoot_);
  if (!p || !q) return Refusal::inside_shared;
  const Content on_p = content_of(p_, *p), on_q = content_of(q_, *q);
  // It has to replace part of an open edge on both sides, or several shared edges by one.
  const bool gains = (on_p.open >= least && on_q.open >= least) || on_p.shared.size() >= 2;
  if (!gains) return Refusal::nothing_opposite;
  if (!correspond(on_p.shared, on_q.shared)) return Refusal::other_pairs;
  if (!gives_way(complex_, p_, *p) || !gives_way(complex_, q_, *q)) return Refusal::bay;
  // With an end at a shared edge on one side only, the ends of the copies would not coincide.
  if (p->begin_anchored != q->begin_anchored || p->end_anchored != q->end_anchored)
    return Refusal::one_sided_end;
  return user_->form({p_, q_, *p, *q, seen_in(a_, p->begin.place), seen_in(a_, p->end.place),
                      seen_in(b_, p->begin.place), seen_in(b_, p->end.place), !on_p.shared.empty()});
}

/// Are the shared edges on P and on Q each other's partners?
bool SectionSearch::correspond(const std::vector<EdgeId>& on_p, const std::vector<EdgeId>& on_q) const {
  if (on_p.size() != on_q.size()) return false;
  return std::all_of(on_p.begin(), on_p.end(), [&](EdgeId edge) {
    return std::binary_search(on_q.begin(), on_q.end(), complex_.edges().at(edge).partner);
  });
}

geometry::Point2 SectionSearch::seen_in(const Segment& s, double place) const {
  return geometry::round_to_grid(s.polygon->chart.project(line_.at(sign_ * place)));
}

}  // namespace limpet::model::internal
