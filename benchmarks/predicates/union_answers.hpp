// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>
#include <vector>

#include "../../tests/cases/perimeter_case.hpp"

/// Unions of two polygons by others than limpet.
namespace limpet::benchmarks {

/// What the union truly is (CGAL's Boolean set operations, exact throughout).
struct TrueUnion {
  double area = 0;
  int components = 0;
  /// Of holes that are none to limpet: area at most gap × length / 2. It may drop them (unite.hpp).
  double droppable = 0;
};
TrueUnion true_union(const cases::PerimeterCase& pair);

/// Boost.Geometry's union of each pair of a file, with coordinates of type double or long long, each in a
/// process of its own; a line of JSON for each, as limpet_replay's.
void replay_by_boost(const std::string& path, bool integers, int repeats, bool judge);

/// How far limpet's area may be from the truth, in step²: of a union taken at the first attempt every new
/// vertex was rounded (a step) and may have been dropped when closer than two steps to the next; later
/// attempts move b's vertices by `gap`/64 steps, 2 to 32, outwards and half as many aside.
double limpet_tolerance(const cases::PerimeterCase& pair, std::size_t attempts);

/// How far Boost's may be: 10⁻⁹ of the area and one step along the perimeters, as integers are rounded.
double boost_tolerance(const cases::PerimeterCase& pair, double area);

}  // namespace limpet::benchmarks
