// Copyright the limpet authors. GPL-3.0-or-later.
//
// `limpet follow --replay`: a recorded run is modelled again, without its world and without a follower.
#include <chrono>
#include <cstdio>
#include <limpet/app/commands.hpp>
#include <limpet/app/follow_result.hpp>
#include <limpet/app/interrupt.hpp>
#include <limpet/app/progress.hpp>
#include <limpet/app/run_reader.hpp>
#include <limpet/geometry/predicates.hpp>
#include <utility>

namespace limpet::app {
namespace {

using Clock = std::chrono::steady_clock;

/// What is known of a set without a follower.
void add(FollowOutcome& outcome, const RunSet& set) {
  outcome.path.push_back(set.control_point);
  outcome.readings += static_cast<std::int64_t>(set.sensed.points.size());
  if (set.mode) ++outcome.steps_in_mode[static_cast<std::size_t>(*set.mode)];
}

}  // namespace

int run_again(const FollowArguments& args) {
  FileRoles files = outputs_of(args);
  files.reads("--replay", args.replay);
  files.require_apart();
  RunReader reader(args.replay);
  if (reader.head().arithmetic != geometry::arithmetic())
    warn_of_run(args.replay, "recorded with other arithmetic (" + reader.head().arithmetic +
                                 "): the model may not be the same");
  catch_interrupts();
  const auto start = Clock::now();
  model::Model model = model_before(reader.head());
  Progress progress("replaying", -1, args.quiet);
  RunJudge judge;
  FollowSummary summary;
  std::int64_t sets = 0;
  for (RunSet set; !interrupted() && reader.next(set);) {
    const auto begun = Clock::now();
    model.update(set.sensed.points);
    summary.run.model_us.push_back(std::chrono::duration<double, std::micro>(Clock::now() - begun).count());
    add(summary.run, set);
    progress.step(++sets);
    if (args.check_every > 0 && sets % args.check_every == 0) judge.judge_model(model, sets);
  }
  const bool was_interrupted = reader.is_whole() && reader.end().reason == "interrupted";
  if (!was_interrupted) model.finish(interrupted);  // else its model was not finished, either
  summary.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  progress.clear();
  if (!reader.is_whole() && !interrupted())
    warn_of_run(args.replay, "the run was cut short: it ends without its end");
  summary.run.ended = reader.end().reason;
  summary.run.marks = reader.end().marks;
  Outputs outputs;
  save_models(args, model, interrupted(), sets, outputs);
  judge.judge_model(model, sets);
  return save_result(args, std::move(summary), model, judge, outputs);
}

}  // namespace limpet::app
