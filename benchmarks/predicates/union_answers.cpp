// Copyright the limpet authors. GPL-3.0-or-later.
#include "union_answers.hpp"

#include <algorithm>
#include <cmath>

namespace limpet::benchmarks {
namespace {

double length_of_both(const cases::PerimeterCase& pair) {
  return cases::length_of(pair.start) + cases::length_of(pair.steps[0].other);
}

}  // namespace

double limpet_tolerance(const cases::PerimeterCase& pair, std::size_t attempts) {
  const double moved = attempts > 1 ? 1.75 * std::clamp(std::floor(pair.gap / 64), 2.0, 32.0) + 1 : 0;
  return (3 + moved) * length_of_both(pair);
}

double boost_tolerance(const cases::PerimeterCase& pair, double area) {
  return 1e-9 * area + length_of_both(pair);
}

}  // namespace limpet::benchmarks
