// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <future>
#include <limpet/model/model.hpp>
#include <optional>

namespace limpet::following::internal {

/// What finishing would close (Model::would_finish()), worked out on a copy beside the run. Who takes an
/// answer by the number of sets, not by time, has the same run however fast the machine is.
class FinishForecast {
 public:
  bool is_asked() const { return answer_.valid(); }
  /// Of the model as it is at this set. Precondition: !is_asked().
  void ask(const model::Model&, long set);
  /// The set at which it was asked. Precondition: is_asked().
  long asked() const { return asked_; }
  /// The answer, for which this waits if it must. Precondition: is_asked().
  model::Outcome take() { return answer_.get(); }

 private:
  long asked_ = 0;
  std::future<model::Outcome> answer_;
};

}  // namespace limpet::following::internal
