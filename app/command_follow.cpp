// Copyright the limpet authors. GPL-3.0-or-later.
//
// `limpet follow`: a simulated robot feels an object until its model is complete.
#include <chrono>
#include <cstdio>
#include <limpet/app/collision_case.hpp>
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
#include <vector>

namespace limpet::app {
namespace {

void say_choice(const FollowArguments& args, const FollowSetup& setup) {
  if (args.quiet) return;
  if (!setup.chosen_tip.empty())
    std::fprintf(stderr,
                 "limpet: the robot's tip is taken to be '%s', to which %zu joints move; a robot file "
                 "(.toml) can name another\n",
                 setup.chosen_tip.c_str(), setup.robot.joint_count());
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

struct Input {
  std::string role, path;
};

std::vector<Input> inputs_of(const FollowArguments& args, const SceneFile& scene) {
  std::vector<Input> inputs{{"SCENE", args.scene},
                            {"the scene's image", scene.world.image},
                            {"the initial faces", scene.world.initial_mesh}};
  if (scene.world.mesh != args.scene) inputs.push_back({"the scene's mesh", scene.world.mesh});
  const std::string robot = scene.robot.kind.value_or("point");
  if (robot != "point" && robot != "arm")
    inputs.push_back({args.robot.empty() ? "the scene's robot" : "--robot", robot});
  return inputs;
}

void require_files(const FollowArguments& args, const SceneFile& scene) {
  FileRoles files = outputs_of(args);
  for (const auto& [role, path] : inputs_of(args, scene)) files.reads(role, path);
  files.require_apart();
}

/// Says what the robot has run into, and leaves a scene that comes to it again.
void tell_collision(const FollowArguments& args, const SceneFile& scene, const Collision& collision,
                    Outputs& outputs) {
  std::vector<std::string> taken = args.models;
  taken.insert(taken.end(), {args.json, args.record});
  for (const Input& input : inputs_of(args, scene)) taken.push_back(input.path);
  const std::string path = case_path(args.models.front(), taken);
  outputs.attempt(path, [&] { save_text(path, case_text(scene, collision, path)); });
  std::fprintf(stderr, "limpet: %s; %s comes to it again\n", text_of(collision).c_str(), path.c_str());
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

/// Judged by the truth, with a line that says how far each search for what an arm can feel is.
evaluation::RunJudgement judged(const FollowSetup& setup, const FollowOutcome& outcome,
                                const model::Model& model, bool quiet) {
  std::optional<Progress> line;
  return judge_by_truth(setup, outcome, model, false, [&](std::int64_t done, std::int64_t whole) {
    if (done == 0) line.emplace("judging", whole, quiet);
    line->step(done);
  });
}

}  // namespace

int run(const FollowArguments& args) {
  if (!args.replay.empty()) return run_again(args);
  const SceneFile scene = scene_of(args);
  require_files(args, scene);
  FollowSetup setup = make_setup(scene);
  setup.end_at_collision = !args.count_collisions;
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
  if (summary.run.collision) tell_collision(args, scene, *summary.run.collision, outputs);
  judge.judge_model(follow.model(), sets);
  if (setup.world.truth) summary.truth = judged(setup, summary.run, follow.model(), args.quiet);
  summary.links = judge_links(setup, summary.run);
  summary.has_switches = !setup.robot.switches.empty();
  return save_result(args, std::move(summary), follow.model(), judge, outputs);
}

}  // namespace limpet::app
