// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "process.hpp"

namespace limpet::benchmarks {

/// Times of sets, one by one.
class Latencies {
 public:
  void add(double seconds) { micros_.push_back(static_cast<float>(1e6 * seconds)); }

  Json summary() {
    std::sort(micros_.begin(), micros_.end());
    const auto over = micros_.end() - std::upper_bound(micros_.begin(), micros_.end(), 1000.0f);
    return {{"sets", micros_.size()}, {"median", quantile(0.5)},   {"q90", quantile(0.9)},
            {"q99", quantile(0.99)},  {"q999", quantile(0.999)},   {"q9999", quantile(0.9999)},
            {"worst", quantile(1)},   {"over_a_millisecond", over}};
  }

 private:
  /// The least time that at least this share of the sets do not exceed.
  double quantile(double share) const {
    if (micros_.empty()) return 0;
    const double rank = std::ceil(share * static_cast<double>(micros_.size()));
    return static_cast<double>(micros_[static_cast<std::size_t>(std::max(rank, 1.0)) - 1]);
  }

  std::vector<float> micros_;
};

}  // namespace limpet::benchmarks
