// Copyright the limpet authors. GPL-3.0-or-later.
//
// `limpet follow`: a simulated robot feels an object until its model is complete.
#include <chrono>
#include <cstdio>
#include <limpet/app/commands.hpp>
#include <limpet/app/follow_judgement.hpp>
#include <limpet/app/follow_result.hpp>
#include <limpet/app/follow_run.hpp>
#include <limpet/app/interrupt.hpp>
#include <limpet/app/progress.hpp>
#include <limpet/app/run_record.hpp>
#include <limpet/geometry/predicates.hpp>
#include <limpet/io/text.hpp>
#include <limpet/model/view.hpp>
#include <optional>
#include <utility>

namespace limpet::app {
namespace {

void say_choice(const FollowArguments& args, const FollowSetup& setup) {
  if (args.quiet) return;
  std::fprintf(stderr, "limpet: resolution %s, start %s,%s,%s, seed %llu\n",
               io::short_text(setup.model.resolution).c_str(), io::short_text(setup.start.x()).c_str(),
               io::short_text(setup.start.y()).c_str(), io::short_text(setup.start.z()).c_str(),
               static_cast<unsigned long long>(setup.seed));
}

RunHead head_of(const FollowSetup& setup) {
  return {geometry::arithmetic(), setup.strategy, setup.seed,         setup.model,
          setup.following,        setup.robot,    setup.world.initial};
}

RunSet set_of(const FollowStep& step) {
  RunSet set;
  if (step.motion.end == following::End::none) set.mode = step.motion.mode;
  set.sensed = step.sensed;
  set.control_point = step.control_point;
  return set;
}

std::string note_on(const FollowStep& step) {
  const model::Counts counts = step.seen.model.counts();
  return std::to_string(counts.polygons) + " polygons, " +
         std::to_string(counts.edges - 2 * counts.shared_edges) + " open edges, " +
         std::string(following::name_of(step.motion.mode));
}

}  // namespace

int run(const FollowArguments& args) {
  if (!args.replay.empty()) return run_again(args);
  require_outputs(args);
  const FollowSetup setup = make_setup(args);
  say_choice(args, setup);
  catch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  FollowRun follow(setup);
  std::optional<RunRecord> record;
  if (!args.record.empty()) record.emplace(args.record, head_of(setup));
  Progress progress("following", -1, args.quiet);
  RunJudge judge;
  std::int64_t sets = 0;
  FollowSummary summary;
  summary.run = follow.go([&](const FollowStep& step) {
    ++sets;
    if (record) record->add(set_of(step));
    progress.step(sets, note_on(step));
    if (args.check_every > 0 && sets % args.check_every == 0) judge.judge_model(step.seen.model, sets);
  });
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  progress.clear();
  if (record) record->end({summary.run.ended, summary.run.marks});
  judge.judge_model(follow.model(), sets);
  if (setup.world.truth) summary.truth = judge_by_truth(setup, summary.run, follow.model());
  return save_result(args, std::move(summary), follow.model(), judge);
}

}  // namespace limpet::app
