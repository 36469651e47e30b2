// Copyright the limpet authors. GPL-3.0-or-later.
#include "closing_watch_internal.hpp"

#include <algorithm>
#include <cmath>

namespace limpet::following::internal {

long ClosingWatch::period(const Observation& seen) {
  constexpr long kLeast = 20;  // sets
  return std::max(kLeast, static_cast<long>(seen.model.counts().polygons));
}

void ClosingWatch::tell(const Observation& seen) {
  open_.note(seen.model.would_finish());
  ++asked_;
  known_ = sets_;
}

void ClosingWatch::take_forecast() {
  const long asked = forecast_.asked();
  const model::Outcome outcome = forecast_.take();
  if (asked < known_) return;  // more has been learned since
  open_.note(outcome);
  known_ = asked;
}

void ClosingWatch::look(const Observation& seen) {
  ++sets_;
  constexpr double kDue =
      0.85;  // of a period: the sooner, the fewer sets are made in vain; it takes some time
  const long period = this->period(seen);
  if (forecast_.is_asked() && sets_ - forecast_.asked() >= std::lround(kDue * static_cast<double>(period)))
    take_forecast();
  if (forecast_.is_asked() || sets_ - known_ < period) return;
  if (!is_beside_) return tell(seen);
  forecast_.ask(seen.model, sets_);
  ++asked_;
}

void ClosingWatch::look_before_leaving(const Observation& seen) {
  if (forecast_.is_asked()) take_forecast();
  const long oldest = is_beside_ ? period(seen) : period(seen) / 2;
  if (sets_ - known_ >= oldest) tell(seen);
}

bool ClosingWatch::look_now(const Observation& seen) {
  if (sets_ == known_) return false;
  tell(seen);
  return true;
}

}  // namespace limpet::following::internal
