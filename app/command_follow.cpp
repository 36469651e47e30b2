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
  return {geometry::arithmetic(), setup.strategy, setup.seed,  setup.model,
          setup.following,        setup.links,    setup.robot, setup.world.initial};
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

void require_files(const FollowArguments& args, const SceneFile& scene) {
  FileRoles files = outputs_of(args);
  files.reads("SCENE", args.scene);
  if (scene.world.mesh != args.scene) files.reads("the scene's mesh", scene.world.mesh);
  files.reads("the scene's image", scene.world.image);
  files.reads("the initial faces", scene.world.initial_mesh);
  if (args.robot != "point" && args.robot != "arm") files.reads("--robot", args.robot);
  files.require_apart();
}

/// Records a run as long as that goes well: the run does not end because its record cannot be written.
class Recorder {
 public:
  Recorder(std::string path, const FollowSetup& setup, Outputs& outputs)
      : path_(std::move(path)), outputs_(outputs) {
    if (!path_.empty()) record_.emplace(path_, head_of(setup));
  }
  void add(const FollowStep& step) {
    attempt([&] { record_->add(set_of(step)); });
  }
  void end(const FollowOutcome& outcome) {
    attempt([&] { record_->end({outcome.ended, outcome.marks}); });
  }

 private:
  template <class Write>
  void attempt(Write&& write) {
    if (!record_) return;
    outputs_.attempt(path_, write);
    if (!outputs_.failed()) return;
    record_.reset();
    std::fprintf(stderr, "limpet: warning: %s: cannot be written any more; the run goes on without\n",
                 path_.c_str());
  }

  std::string path_;
  Outputs& outputs_;
  std::optional<RunRecord> record_;
};

}  // namespace

int run(const FollowArguments& args) {
  if (!args.replay.empty()) return run_again(args);
  const SceneFile scene = scene_of(args);
  require_files(args, scene);
  const FollowSetup setup = make_setup(scene);
  say_choice(args, setup);
  catch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  FollowRun follow(setup);
  Outputs outputs;
  Recorder recorder(args.record, setup, outputs);
  Progress progress("following", -1, args.quiet);
  RunJudge judge;
  std::int64_t sets = 0;
  FollowSummary summary;
  summary.run = follow.go([&](const FollowStep& step) {
    ++sets;
    recorder.add(step);
    progress.step(sets, note_on(step));
    if (args.check_every > 0 && sets % args.check_every == 0) judge.judge_model(step.seen.model, sets);
  });
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  progress.clear();
  recorder.end(summary.run);
  save_models(args, follow.model(), summary.run.ended == "interrupted", sets, outputs);
  judge.judge_model(follow.model(), sets);
  if (setup.world.truth) summary.truth = judge_by_truth(setup, summary.run, follow.model());
  summary.links = judge_links(setup, summary.run);
  summary.has_switches = !setup.robot.switches.empty();
  return save_result(args, std::move(summary), follow.model(), judge, outputs);
}

}  // namespace limpet::app
