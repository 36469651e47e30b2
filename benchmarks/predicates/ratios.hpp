// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <vector>

#include "../process.hpp"

namespace limpet::benchmarks {

/// The middle one of some numbers, and where a tenth of them is below and above; nothing of nothing.
struct Spread {
  Json median, low, high;
};
Spread spread_of(std::vector<double>);

/// Of two numbers; nothing where either is none, or b is 0.
Json quotient(const Json& a, const Json& b);

}  // namespace limpet::benchmarks
