// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <chrono>
#include <optional>

#include <limpet/model/stage_times.hpp>

namespace limpet::model::internal {

/// Adds up the time of each stage, once measure() has been called; before that, each call costs one branch.
class StageClock {
 public:
  void measure() { times_.emplace(); }
  StageTimes times() const { return times_.value_or(StageTimes{}); }

  void start() {
    if (times_) last_ = Clock::now();
  }
  /// Adds the time since start(), or since the last lap, to this stage.
  void lap(double StageTimes::*stage) {
    if (!times_) return;
    const auto now = Clock::now();
    (*times_).*stage += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::optional<StageTimes> times_;
  Clock::time_point last_;
};

}  // namespace limpet::model::internal
