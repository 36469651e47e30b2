// Copyright the limpet authors. GPL-3.0-or-later.
#include "run_figures.hpp"

#include <numeric>

#include <limpet/survey/noise_law.hpp>

namespace limpet::benchmarks {

Spread spread_of(const std::vector<double>& times) {
  const double sum = std::accumulate(times.begin(), times.end(), 0.0);
  return {std::ssize(times), times.empty() ? 0 : sum / static_cast<double>(times.size()),
          survey::quantile(times, 0.5), survey::quantile(times, 0.99), survey::quantile(times, 1)};
}

double RunFigures::seconds_per_set() const {
  double microseconds = 0;
  for (const Spread& spread : {step, asking, update})
    microseconds += static_cast<double>(spread.count) * spread.mean;
  return sets > 0 ? 1e-6 * microseconds / static_cast<double>(sets) : 0;
}

}  // namespace limpet::benchmarks
