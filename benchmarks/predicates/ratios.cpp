// Copyright the limpet authors. GPL-3.0-or-later.
#include "ratios.hpp"

#include <algorithm>
#include <cmath>

namespace limpet::benchmarks {

Spread spread_of(std::vector<double> numbers) {
  if (numbers.empty()) return {};
  std::sort(numbers.begin(), numbers.end());
  const auto at = [&](double part) {
    const double place = part * static_cast<double>(numbers.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(place));
    const std::size_t above = std::min(below + 1, numbers.size() - 1);
    return numbers[below] + (place - std::floor(place)) * (numbers[above] - numbers[below]);
  };
  return {at(0.5), at(0.1), at(0.9)};
}

Json quotient(const Json& a, const Json& b) {
  return a.is_number() && b.is_number() && b > 0.0 ? Json(a.get<double>() / b.get<double>()) : Json();
}

}  // namespace limpet::benchmarks
