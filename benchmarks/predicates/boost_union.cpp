// Copyright the limpet authors. GPL-3.0-or-later.
//
// The only file here that includes Boost.Geometry.
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <chrono>
#include <iostream>
#include <limits>

#include "../child.hpp"
#include "../process.hpp"
#include "case_list.hpp"
#include "union_answers.hpp"

namespace limpet::benchmarks {
namespace {

namespace bg = boost::geometry;

constexpr ChildLimits kUnionLimits{
    .seconds = 600, .cpu_seconds = 20, .megabytes = 4000, .with_errors = false};

/// Anticlockwise, the first point not repeated at the end: as limpet's cycles are.
template <class Number>
using Region = bg::model::polygon<bg::model::d2::point_xy<Number>, false, false>;

template <class Number>
Region<Number> region_of(const shapes::Cycles& cycles) {
  Region<Number> region;
  const auto fill = [](auto& ring, const auto& cycle) {
    for (const auto& v : cycle) ring.emplace_back(static_cast<Number>(v.at.x), static_cast<Number>(v.at.y));
  };
  fill(region.outer(), cycles[0]);
  for (std::size_t i = 1; i < cycles.size(); ++i) fill(region.inners().emplace_back(), cycles[i]);
  return region;
}

template <class Number>
shapes::Cycles cycles_of(const Region<Number>& region) {
  shapes::Cycles cycles(1);
  const auto take = [](auto& cycle, const auto& ring) {
    for (const auto& p : ring) cycle.push_back({{static_cast<double>(p.x()), static_cast<double>(p.y())}});
  };
  take(cycles[0], region.outer());
  for (const auto& ring : region.inners()) take(cycles.emplace_back(), ring);
  return cycles;
}

/// Summed about each ring's own first point, as limpet's are: far from the origin Boost's own area() would
/// lose digits that the union has.
template <class Number>
double united_area(const bg::model::multi_polygon<Region<Number>>& all) {
  double area = 0;
  for (const auto& region : all) area += cases::area_of(cycles_of(region));
  return area;
}

template <class Number>
Json measured(const cases::PerimeterCase& pair, int repeats, bool judge) {
  const auto a = region_of<Number>(pair.start), b = region_of<Number>(pair.steps[0].other);
  double best = std::numeric_limits<double>::infinity();
  bg::model::multi_polygon<Region<Number>> all;
  for (int k = 0; k < repeats; ++k) {
    all.clear();
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    try {
      bg::union_(a, b, all);
    } catch (const std::exception& error) {
      return {{"outcome", "refused"}, {"law", "exception"}, {"what", error.what()}};
    }
    best = std::min(best, std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
  }
  Json said{{"outcome", "changed"}, {"us", best}, {"law", ""}};
  if (!judge) return said;
  std::string why;
  if (!bg::is_valid(all, why)) said["law"] = "invalid", said["what"] = why;
  said["area"] = united_area(all);
  said["components"] = all.size();
  return said;
}

}  // namespace

void replay_by_boost(const std::string& path, bool integers, int repeats, bool judge) {
  for (const auto& pair : load_cases(path)) {
    const ChildEnd end = run_child(
        [&] {
          const Json told =
              integers ? measured<long long>(pair, repeats, judge) : measured<double>(pair, repeats, judge);
          std::cout << told.dump() << std::endl;
        },
        kUnionLimits);
    Json told = last_told(end.output);
    if (!end.done() || told.is_null()) told = {{"ended", end.how()}};
    std::cout << told.dump() << '\n';
  }
}

}  // namespace limpet::benchmarks
