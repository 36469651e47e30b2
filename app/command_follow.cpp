// Copyright the limpet authors. GPL-3.0-or-later.
//
// `limpet follow`: a simulated robot feels an object until its model is complete.
#include <chrono>
#include <cstdio>
#include <limpet/app/arguments.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/app/follow_run.hpp>
#include <limpet/app/follow_summary.hpp>
#include <limpet/app/interrupt.hpp>
#include <limpet/app/progress.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/mesh_writer.hpp>
#include <limpet/io/text.hpp>
#include <limpet/model/view.hpp>

namespace limpet::app {
namespace {

void require_outputs(const FollowArguments& args) {
  for (const std::string& path : args.models) {
    require_model_name(path);
    require_writable(path);
  }
  if (!args.json.empty() && args.json != "-") require_writable(args.json);
}

void say_choice(const FollowArguments& args, const FollowSetup& setup) {
  if (args.quiet) return;
  std::fprintf(stderr, "limpet: resolution %s, start %s,%s,%s, seed %llu\n",
               io::short_text(setup.model.resolution).c_str(), io::short_text(setup.start.x()).c_str(),
               io::short_text(setup.start.y()).c_str(), io::short_text(setup.start.z()).c_str(),
               static_cast<unsigned long long>(setup.seed));
}

/// The marks of a run as the judge takes them. `view` is that of the model they were made in.
std::vector<evaluation::GivenUp> given_up(const model::View& view, const following::Marks& marks) {
  std::vector<evaluation::GivenUp> result;
  const auto add = [&](const model::View::Edge& edge) {
    const Eigen::Vector3d normal = view.segment(edge.segment)->plane.normal;
    const Eigen::Vector3d outward = (edge.to - edge.from).cross(normal);
    if (outward.norm() > 0) result.push_back({edge.from, edge.to, outward.normalized()});
  };
  for (const auto* ids : {&marks.unreachable_edges, &marks.unclosable_edges})
    for (const geometry::EdgeId id : *ids)
      if (const auto edge = view.edge(id)) add(*edge);
  std::vector<model::View::Edge> edges;
  for (const model::SegmentId segment : marks.unreachable_segments) {
    view.open_edges(segment, edges);
    for (const auto& edge : edges) add(edge);
  }
  return result;
}

evaluation::RunJudgement judge_by_truth(const FollowSetup& setup, const FollowOutcome& outcome,
                                        const model::Model& model) {
  evaluation::RunJudgementOptions options;
  options.resolution = setup.following.resolution;
  options.follow_distance = setup.following.follow_distance;
  options.ceiling = setup.robot.ceilings.prismatic;
  const kinematics::Configuration start = setup.start;
  options.sensing = evaluation::sensing_of(kinematics::Posture(setup.robot, start));
  return evaluation::judge_run(
      *setup.world.truth, {outcome.path, model.record(), given_up(model.view(), outcome.marks)}, options);
}

}  // namespace

int run(const FollowArguments& args) {
  require_outputs(args);
  const FollowSetup setup = make_setup(args);
  say_choice(args, setup);
  catch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  FollowRun follow(setup);
  Progress progress("following", -1, args.quiet);
  std::int64_t sets = 0, violations = 0;
  const auto judge_model = [&] {
    for (const auto& violation : judge(follow.model().record()))
      if (violations++ < 20)
        std::fprintf(stderr, "limpet: broken after set %lld: %s, %s: %s\n", static_cast<long long>(sets),
                     violation.law.c_str(), violation.where.c_str(), violation.what.c_str());
  };
  FollowSummary summary;
  summary.run = follow.go([&](const FollowStep& step) {
    ++sets;
    const model::Counts counts = step.model.counts();
    progress.step(sets, std::to_string(counts.polygons) + " polygons, " +
                            std::to_string(counts.edges - 2 * counts.shared_edges) + " open edges, " +
                            std::string(following::name_of(step.motion.mode)));
    if (args.check_every > 0 && sets % args.check_every == 0) judge_model();
  });
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  progress.clear();
  judge_model();
  const model::ModelRecord record = follow.model().record();
  summary.model = summarise(record, follow.model().open_edges());
  summary.model.violations = violations;
  summary.model.seconds = summary.seconds;
  for (const std::string& path : args.models) io::save_model(path, record);
  if (setup.world.truth) summary.truth = judge_by_truth(setup, summary.run, follow.model());
  if (!args.json.empty()) save_text(args.json, to_json(summary));
  if (!args.quiet) std::fprintf(args.json == "-" ? stderr : stdout, "%s", to_text(summary).c_str());
  return violations > 0 || summary.run.ended != "complete" ? kFallsShort : kDone;
}

}  // namespace limpet::app
