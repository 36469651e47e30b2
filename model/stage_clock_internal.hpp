// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <chrono>
#include <optional>

#include <limpet/model/stage_times.hpp>

namespace limpet::model::internal {

/// Books time on stages once it has been asked to; before that it costs a branch.
class StageClock {
 public:
  void measure() { times_.emplace(); }
  StageTimes times() const { return times_.value_or(StageTimes{}); }

  void start() {
    if (times_) last_ = Clock::now();
  }
  /// The time since start() or the last lap was this stage's.
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
