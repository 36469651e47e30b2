// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/app/commands.hpp>
#include <limpet/app/file_roles.hpp>
#include <limpet/app/follow_summary.hpp>
#include <limpet/app/outputs.hpp>
#include <limpet/model/model.hpp>

namespace limpet::app {

/// The outputs of a run, to which its inputs are added.
FileRoles outputs_of(const FollowArguments&);

/// Asks the oracle about the model of a run, and tells of the first laws that are broken.
class RunJudge {
 public:
  /// `sets`: how many the model has been given.
  void judge_model(const model::Model&, std::int64_t sets);
  std::int64_t violations() const { return violations_; }

 private:
  std::int64_t violations_ = 0;
};

/// Writes the model of a run, and says so if the run was interrupted: what comes after may take a while.
void save_models(const FollowArguments&, const model::Model&, bool interrupted, std::int64_t sets, Outputs&);

/// Writes the summary of a run, adding what the model says of itself, and says it for
/// people. `outputs`: what else was written, and has perhaps failed. Returns the exit code. Throws
/// io::OutputError.
int save_result(const FollowArguments&, FollowSummary, const model::Model&, const RunJudge&,
                Outputs& outputs);

}  // namespace limpet::app
