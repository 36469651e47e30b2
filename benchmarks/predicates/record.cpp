// Copyright the limpet authors. GPL-3.0-or-later.
#include "record.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "../../tests/cases/perimeter_script.hpp"

namespace limpet::benchmarks {
namespace {

using namespace cases;

constexpr double kUnit = 1024;  ///< grid steps
constexpr std::size_t kMostEdges = 1500;

Regime regime_of(const Setting& setting) {
  return setting.regime == "grid" ? Regime::grid : setting.regime == "free" ? Regime::free : Regime::far;
}

/// Calls take(polygon before, gap, step) until it returns true: all is had.
template <class Take>
void grow_polygons(PerimeterScript& script, Take&& take) {
  for (bool done = false; !done;) {
    const PerimeterCase begun = script.begin();
    try {
      PerimeterTrial trial(begun.start, begun.gap);
      for (std::int64_t k = script.random().whole(1, 40); k > 0 && !done; --k) {
        const Step step = script.next(trial.polygon());
        if (!trial.prepare(step)) continue;
        done = take(trial.before(), begun.gap, step);
        trial.apply();
        if (trial.polygon().edge_count() > kMostEdges) break;
      }
    } catch (const CaseError&) {  // a point too far away for limpet
    }
  }
}

/// Moves both polygons of a pair; false when one is none any more.
template <class Place>
bool move_pair(PerimeterCase& pair, Place&& place) {
  for (Cycles* cycles : {&pair.start, &pair.steps[0].other}) {
    for (auto& cycle : *cycles)
      for (NewVertex& v : cycle) v.at = round_to_grid(place(v.at));
    EdgeIds ids;
    if (!Polygon::from_cycles(*cycles, ids)) return false;
  }
  return true;
}

double extent_of(const PerimeterCase& pair) {
  geometry::Box2 box;
  for (const Cycles* cycles : {&pair.start, &pair.steps[0].other})
    for (const NewVertex& v : cycles->front()) box.add(v.at);
  return std::max(box.high.x - box.low.x, box.high.y - box.low.y);
}

bool place_pair(PerimeterCase& pair, const Setting& setting, double unit) {
  const double cosine = std::cos(0.7), sine = std::sin(0.7);
  const double away =
      setting.regime == "far" ? std::min(std::floor(1e6 * extent_of(pair)), 0x1p40 / unit) : 0;
  return move_pair(pair, [&](Point2 p) {
    p = unit * (p + Point2{away, -std::floor(away / 3)});
    return setting.regime == "free" ? Point2{cosine * p.x - sine * p.y, sine * p.x + cosine * p.y} : p;
  });
}

bool boxes_meet(const PerimeterCase& pair) {
  std::array<geometry::Box2, 2> boxes;
  for (const NewVertex& v : pair.start[0]) boxes[0].add(v.at);
  for (const NewVertex& v : pair.steps[0].other[0]) boxes[1].add(v.at);
  return boxes[0].meets(boxes[1]);
}

}  // namespace

std::vector<PerimeterCase> record_operations(const Setting& setting, std::size_t each, std::uint64_t seed) {
  PerimeterScript script(shapes::Random(seed), regime_of(setting), setting.general);
  std::vector<PerimeterCase> list;
  std::array<std::size_t, kOperations.size()> had{};
  grow_polygons(script, [&](const Cycles& before, double gap, const Step& step) {
    std::size_t& count = had[static_cast<std::size_t>(step.operation)];
    if (count < each) {
      ++count;
      list.push_back({.gap = gap, .start = before, .steps = {step}, .law = "none"});
    }
    return list.size() == each * had.size();
  });
  return list;
}

std::vector<PerimeterCase> record_pairs(const Setting& setting, std::size_t count, std::uint64_t seed) {
  PerimeterScript script(shapes::Random(seed), Regime::grid, setting.general);
  // In general position they are large already.
  const double unit = setting.general ? 1 : kUnit;
  std::vector<PerimeterCase> list;
  grow_polygons(script, [&](const Cycles& before, double, const Step& step) {
    if (step.operation != Operation::unite && step.operation != Operation::merge) return false;
    PerimeterCase pair{.gap = kUnit / 2, .start = before, .steps = {step}, .law = "none"};
    pair.steps[0].operation = Operation::unite;
    if (boxes_meet(pair) && place_pair(pair, setting, unit)) list.push_back(std::move(pair));
    return list.size() == count;
  });
  return list;
}

}  // namespace limpet::benchmarks
