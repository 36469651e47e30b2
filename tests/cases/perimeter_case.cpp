// Copyright the limpet authors. GPL-3.0-or-later.
#include "perimeter_case.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include <limpet/audit/planar.hpp>
#include <limpet/audit/sweep.hpp>
#include <limpet/geometry/extend.hpp>
#include <limpet/geometry/fissure.hpp>
#include <limpet/geometry/judge.hpp>
#include <limpet/geometry/predicates.hpp>
#include <limpet/geometry/search.hpp>
#include <limpet/geometry/unite.hpp>

namespace limpet::cases {

using namespace geometry;

namespace {

/// Operations are promised for grid points that are not absurdly far away.
constexpr double kFarthest = 0x1p42;

Point2 on_grid(Point2 p) {
  if (!(std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest)) throw CaseError("a point is too far away");
  return round_to_grid(p);
}

std::optional<Polygon> polygon_of(Cycles cycles, EdgeIds& ids) {
  for (auto& c : cycles)
    for (NewVertex& v : c) v.at = on_grid(v.at);
  return Polygon::from_cycles(cycles, ids);
}

Polygon valid_polygon(const Cycles& cycles, EdgeIds& ids) {
  auto polygon = polygon_of(cycles, ids);
  if (!polygon) throw CaseError("the polygon is not valid");
  return *std::move(polygon);
}

Point2 any_vertex(const Cycles& cycles, shapes::Random& places) {
  const auto& c = cycles[places.bits() % cycles.size()];
  return c[places.bits() % c.size()].at;
}

}  // namespace

double area_of(const Cycles& cycles) {
  double twice = 0;
  for (const auto& c : cycles)
    for (std::size_t i = 0; i < c.size(); ++i)
      twice += cross(c[i].at - c[0].at, c[(i + 1) % c.size()].at - c[0].at);
  return twice / 2;
}

double length_of(const Cycles& cycles) {
  double length = 0;
  for (const auto& c : cycles)
    for (std::size_t i = 0; i < c.size(); ++i)
      length += std::sqrt(squared_length(c[(i + 1) % c.size()].at - c[i].at));
  return length;
}

bool audit_accepts(const Cycles& cycles) {
  std::vector<std::vector<audit::Point>> rings;
  for (const auto& c : cycles) {
    if (c.size() < 3) return false;
    std::vector<audit::Point> ring;
    for (const NewVertex& v : c) ring.push_back({v.at.x, v.at.y});
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (ring[i] == ring[(i + 1) % ring.size()]) return false;
    rings.push_back(std::move(ring));
  }
  if (rings.empty() || audit::find_clash(rings)) return false;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (audit::area_sign(rings[i]) != (i == 0 ? 1 : -1)) return false;
    for (std::size_t j = 0; j < rings.size(); ++j)
      if (i > 0 && i != j && (audit::side_of(rings[i][0], rings[j]) == audit::Side::kInside) != (j == 0))
        return false;
  }
  return true;
}

PerimeterTrial::PerimeterTrial(const Cycles& start, double gap, double area_tolerance, double step_tolerance)
    : gap_(gap),
      area_tolerance_(area_tolerance),
      step_tolerance_(step_tolerance),
      polygon_(valid_polygon(start, ids_)) {
  if (!(gap >= 1 && gap <= 1e6)) throw CaseError("the gap is not within 1 to 10^6 steps");
  polygon_.take_created();
}

bool PerimeterTrial::prepare(const Step& step) {
  step_ = step;
  before_ = polygon_.boundary();
  polygon_.take_removed();
  other_.reset();
  fresh_.clear();
  attempts_ = 0;
  merger_ = Merger::contained;
  if (step.operation == Operation::extend) step_.q = on_grid(step.q);
  if (step.operation == Operation::merge || step.operation == Operation::unite) {
    other_ = polygon_of(step.other, ids_);
    return other_.has_value();
  }
  if (step.operation == Operation::fill) {
    fresh_ = polygon_.take_created();
    if (fresh_.empty() || step.all_fresh)
      for (std::uint32_t i = 0; i < polygon_.slot_count(); ++i)
        if (polygon_.alive(Slot{i})) fresh_.emplace_back(Slot{i}, polygon_.node(Slot{i}).edge);
  }
  return true;
}

Outcome PerimeterTrial::apply() {
  threw_ = false;
  try {
    switch (step_.operation) {
      case Operation::extend: {
        const Extension e = extend_to_point(polygon_, step_.q, gap_, ids_);
        outcome_ = e == Extension::extended  ? Outcome::changed
                   : e == Extension::refused ? Outcome::refused
                                             : Outcome::nothing;
        break;
      }
      case Operation::fill:
        outcome_ = fill_fissures(polygon_, fresh_, gap_, ids_) > 0 ? Outcome::changed : Outcome::nothing;
        break;
      case Operation::unite:
        outcome_ = unite(polygon_, *other_, gap_, ids_, &attempts_) ? Outcome::changed : Outcome::refused;
        break;
      case Operation::merge:
        merger_ = merge_polygons(polygon_, *other_, gap_, ids_);
        outcome_ = merger_ == Merger::united || merger_ == Merger::bridged ? Outcome::changed
                   : merger_ == Merger::refused                            ? Outcome::refused
                                                                           : Outcome::nothing;
    }
  } catch (const std::exception&) {
    threw_ = true;
    outcome_ = Outcome::refused;
  }
  return outcome_;
}

std::optional<PerimeterLaw> PerimeterTrial::judge(shapes::Random& places, bool thorough) {
  if (threw_) return PerimeterLaw::exception;
  const Cycles after = polygon_.boundary();
  if (outcome_ != Outcome::changed && !shapes::same(before_, after)) return PerimeterLaw::untouched;
  if (judge_cycles(after) != Verdict::valid) return PerimeterLaw::simple;
  if (thorough && !audit_accepts(after)) return PerimeterLaw::audit;
  if (!identities_hold(after)) return PerimeterLaw::identity;
  const double length = length_of(before_), other_length = other_ ? length_of(step_.other) : 0;
  const double slack = step_tolerance_ * length + kMoves * other_length;
  if (area_of(after) < area_of(before_) * (1 - area_tolerance_) - slack) return PerimeterLaw::area;
  // All that is within the gap of a curve: a strip to either side, and a disc.
  const double may_come = (2 * (length + other_length) + M_PI * reach()) * reach();
  if (area_of(after) >
      (area_of(before_) + (other_ ? area_of(step_.other) : 0)) * (1 + area_tolerance_) + may_come)
    return PerimeterLaw::growth;
  if (!sides_hold(after, places)) return PerimeterLaw::sides;
  if (thorough && outcome_ == Outcome::changed) {
    if (!contains_all(before_, places) || !contains_all(step_.other, places)) return PerimeterLaw::contains;
    if (!adds_only_near(after, places)) return PerimeterLaw::growth;
  }
  return std::nullopt;
}

bool PerimeterTrial::identities_hold(const Cycles& after) {
  std::vector<EdgeId> old_ids, new_ids;
  for (const auto& c : before_)
    for (const NewVertex& v : c) old_ids.push_back(v.edge);
  for (const auto& c : after)
    for (const NewVertex& v : c) new_ids.push_back(v.edge);
  std::vector<EdgeId> removed = polygon_.take_removed();
  for (auto* ids : {&old_ids, &new_ids, &removed}) {
    std::sort(ids->begin(), ids->end());
    if (std::adjacent_find(ids->begin(), ids->end()) != ids->end()) return false;
  }
  for (const EdgeId id : old_ids)
    if (std::binary_search(new_ids.begin(), new_ids.end(), id) ==
        std::binary_search(removed.begin(), removed.end(), id))
      return false;
  return std::none_of(removed.begin(), removed.end(),
                      [&](EdgeId id) { return std::binary_search(new_ids.begin(), new_ids.end(), id); });
}

bool PerimeterTrial::sides_hold(const Cycles& after, shapes::Random& places) const {
  std::vector<Segment2> edges;
  for (const auto& c : after)
    for (std::size_t i = 0; i < c.size(); ++i) edges.emplace_back(c[i].at, c[(i + 1) % c.size()].at);
  for (int k = 0; k < 4; ++k) {
    const auto& [a, b] = edges[places.bits() % edges.size()];
    const double reach = places.chance(0.5) ? 3 : gap_;
    const Point2 p = round_to_grid(a + places.unit() * (b - a) +
                                   reach * Point2{2 * places.unit() - 1, 2 * places.unit() - 1});
    Polygon::Side side = inside_even_odd(edges, p) ? Polygon::Side::inside : Polygon::Side::outside;
    for (const auto& [c, d] : edges)
      if (segments_meet(c, d, p, p)) side = Polygon::Side::boundary;
    if (polygon_.locate(p) != side) return false;
  }
  return true;
}

bool PerimeterTrial::contains_all(const Cycles& of, shapes::Random& places) const {
  if (of.empty()) return true;
  EdgeIds ids;
  const auto part = polygon_of(of, ids);
  const double deep = kMoves + step_tolerance_;
  for (int k = 0; part && k < 8; ++k) {
    const Point2 a = any_vertex(of, places), b = any_vertex(of, places), c = any_vertex(of, places);
    const Point2 p = round_to_grid((1.0 / 3) * (a + b + c));
    if (part->locate(p) == Polygon::Side::inside && !any_edge_within(*part, p, p, deep) &&
        polygon_.locate(p) != Polygon::Side::inside)
      return false;
  }
  return true;
}

bool PerimeterTrial::adds_only_near(const Cycles& after, shapes::Random& places) const {
  EdgeIds ids;
  const auto before = polygon_of(before_, ids);
  const auto reaches = [&](const std::optional<Polygon>& part, Point2 p) {
    return part && (part->locate(p) != Polygon::Side::outside || any_edge_within(*part, p, p, reach()));
  };
  for (int k = 0; k < 8; ++k) {
    const Point2 a = any_vertex(after, places), b = any_vertex(after, places), c = any_vertex(after, places);
    const Point2 p = round_to_grid(k % 2 ? 0.5 * (a + b) : (1.0 / 3) * (a + b + c));
    if (polygon_.locate(p) != Polygon::Side::outside && !reaches(before, p) && !reaches(other_, p))
      return false;
  }
  return true;
}

std::optional<BrokenLaw> broken_law(const PerimeterCase& c) {
  PerimeterTrial trial(c.start, c.gap, c.area_tolerance, c.step_tolerance);
  shapes::Random places(std::uint64_t{1});
  for (std::size_t i = 0; i < c.steps.size(); ++i) {
    if (!trial.prepare(c.steps[i])) continue;
    trial.apply();
    if (const auto law = trial.judge(places, true))
      return BrokenLaw{kPerimeterLaws[static_cast<std::size_t>(*law)],
                       "step " + std::to_string(i + 1) + ", " +
                           kOperations[static_cast<std::size_t>(c.steps[i].operation)]};
  }
  return std::nullopt;
}

}  // namespace limpet::cases
