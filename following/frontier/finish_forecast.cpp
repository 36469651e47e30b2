// Copyright the limpet authors. GPL-3.0-or-later.
#include "finish_forecast_internal.hpp"

#include <string>
#include <system_error>
#include <utility>

namespace limpet::following::internal {

void FinishForecast::ask(const model::Model& model, long set) {
  asked_ = set;
  const auto answer = [](const std::string& state) { return model::Model::from_state(state).would_finish(); };
  std::string state = model.state();
  try {
    answer_ = std::async(std::launch::async, answer, state);
  } catch (const std::system_error&) {  // no thread is to be had: it is worked out when it is taken
    answer_ = std::async(std::launch::deferred, answer, std::move(state));
  }
}

}  // namespace limpet::following::internal
