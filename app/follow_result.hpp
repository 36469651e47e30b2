// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/app/commands.hpp>
#include <limpet/app/follow_summary.hpp>
#include <limpet/model/model.hpp>

namespace limpet::app {

/// Refuses, before any work is done, outputs that cannot be written. Throws UsageError or io::OutputError.
void require_outputs(const FollowArguments&);

/// Asks the oracle about the model of a run, and tells of the first laws that are broken.
class RunJudge {
 public:
  /// `sets`: how many the model has been given.
  void judge_model(const model::Model&, std::int64_t sets);
  std::int64_t violations() const { return violations_; }

 private:
  std::int64_t violations_ = 0;
};

/// Writes the finished model and the summary of a run, adding what the model says of itself, and says it for
/// people. Returns the exit code. Throws io::OutputError.
int save_result(const FollowArguments&, FollowSummary, const model::Model&, const RunJudge&);

}  // namespace limpet::app
