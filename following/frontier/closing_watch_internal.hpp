// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/following/observation.hpp>

#include "finish_forecast_internal.hpp"
#include "open_edge_map_internal.hpp"

namespace limpet::following::internal {

/// Tells a map of open edges from time to time which of them finishing would close: there nothing is to be
/// felt. To know that takes longer than anything else in a step, and the longer, the more polygons there are.
class ClosingWatch {
 public:
  /// `open` must outlive it. `beside`: no step is kept waiting; what is asked is worked out beside the run,
  /// and told most of a period later.
  ClosingWatch(OpenEdgeMap& open, bool beside) : open_(open), is_beside_(beside) {}

  /// To be called once for each set.
  void look(const Observation&);
  /// The robot is about to leave: what is told is to be no older than it need be.
  void look_before_leaving(const Observation&);
  /// Tells what is so after this set; returns whether that was not known yet.
  bool look_now(const Observation&);
  /// How often it was asked.
  std::int64_t asked() const { return asked_; }

 private:
  static long period(const Observation&);
  void take_forecast();
  void tell(const Observation&);

  OpenEdgeMap& open_;
  bool is_beside_;
  FinishForecast forecast_;
  long sets_ = 0, known_ = 0;  ///< sets so far, and after which of them what is told was so
  std::int64_t asked_ = 0;
};

}  // namespace limpet::following::internal
