// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>

#include <limpet/app/follow_judgement.hpp>
#include <limpet/app/follow_run.hpp>
#include <limpet/app/follow_setup.hpp>
#include <limpet/app/summary.hpp>
#include <limpet/model/view.hpp>
#include <limpet/simulation/world_description.hpp>

#include "../scan_case.hpp"
#include "run_figures.hpp"

namespace limpet::benchmarks {
namespace {

/// Tells the sets on which the follower asked what finishing would close, and asks the oracle.
class Watcher {
 public:
  explicit Watcher(std::int64_t oracle_every) : oracle_every_(oracle_every) {}

  void look(const app::FollowStep& step) {
    const std::int64_t asked = step.follower.outcomes_asked();
    has_asked_.push_back(asked != asked_);
    asked_ = asked;
    if (oracle_every_ > 0 && std::ssize(has_asked_) % oracle_every_ == 0) judge(step.seen.model);
  }
  void judge(const model::Model& model) {
    violations_ += std::ssize(app::judge(model.record()));
    ++models_;
  }

  void tell(const app::FollowOutcome& outcome, RunFigures& figures) const {
    std::vector<double> step, asking;
    for (std::size_t i = 0; i < outcome.step_us.size(); ++i)
      (has_asked_[i] ? asking : step).push_back(outcome.step_us[i]);
    figures.step = spread_of(step);
    figures.asking = spread_of(asking);
    figures.update = spread_of(outcome.model_us);
    figures.oracle_models = models_;
    figures.violations = violations_;
  }

 private:
  std::int64_t oracle_every_, asked_ = 0, models_ = 0, violations_ = 0;
  std::vector<bool> has_asked_;
};

/// Of the true surface, less what is known beforehand.
double felt_area(const simulation::BuiltWorld& world) {
  double area = area_of(*world.truth);
  for (const model::InitialFace& face : world.initial)
    for (const auto& cycle : face.cycles) {
      Eigen::Vector3d twice = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < cycle.size(); ++i)
        twice += (cycle[i] - cycle[0]).cross(cycle[(i + 1) % cycle.size()] - cycle[0]);
      area -= (&cycle == &face.cycles.front() ? 0.5 : -0.5) * twice.norm();
    }
  return area;
}

void tell_model(const model::Model& model, RunFigures& figures) {
  std::vector<model::View::Edge> open;
  model.view().open_edges(open);
  figures.polygons = model.counts().polygons;
  figures.open_edges = std::ssize(open);
  figures.closed = figures.polygons > 0 && open.empty();
}

void tell_judgement(const evaluation::RunJudgement& judged, double clearance, RunFigures& figures) {
  figures.path = judged.path_length;
  figures.isomorphic_reachable = judged.isomorphic;
  figures.reachable_throughout = judged.topology.faces == std::ssize(judged.reachability.faces);
  figures.isomorphic = judged.isomorphic && figures.reachable_throughout;
  figures.reachable = judged.reachable_share;
  figures.coverage = judged.coverage;
  figures.coverage_total = judged.coverage_total;
  figures.collisions = static_cast<std::int64_t>(judged.collisions);
  figures.clearance = judged.clearance_control_point / clearance;
  figures.false_unreachable = static_cast<std::int64_t>(judged.false_unreachable);
  if (!judged.tour) return;
  figures.tour_sets = static_cast<std::int64_t>(judged.tour->sets);
  figures.tour_transit = static_cast<std::int64_t>(judged.tour->transit_steps);
  figures.tour_path = judged.tour->path_length;
}

void tell_links(const evaluation::LinkClearance& links, double resolution, RunFigures& figures) {
  figures.link_collisions = static_cast<std::int64_t>(links.collisions + links.self_collisions);
  figures.link_clearance = links.to_surface / resolution;
  figures.link_own_clearance = links.to_itself / resolution;
}

}  // namespace

RunFigures measure_run(const RunCase& wanted) {
  app::FollowSetup setup = app::make_setup(app::parse_scene(wanted.scene, wanted.name));
  setup.max_seconds = wanted.max_seconds;
  app::FollowRun run(setup);
  Watcher watcher(wanted.oracle_every);
  RunFigures figures;
  const WallWatch running;
  const app::FollowOutcome outcome = run.go([&](const app::FollowStep& step) { watcher.look(step); });
  figures.seconds = running.seconds();
  watcher.judge(run.model());
  watcher.tell(outcome, figures);
  figures.ended = outcome.ended;
  figures.sets = std::ssize(outcome.path);
  figures.area = felt_area(setup.world);
  figures.resolution = setup.model.resolution;
  figures.unreachable =
      std::ssize(outcome.marks.unreachable_edges) + std::ssize(outcome.marks.unreachable_segments);
  figures.unclosable = std::ssize(outcome.marks.unclosable_edges);
  tell_model(run.model(), figures);
  const WallWatch judging;
  tell_judgement(app::judge_by_truth(setup, outcome, run.model(), wanted.tour), setup.following.clearance(),
                 figures);
  if (const auto links = app::judge_links(setup, outcome))
    tell_links(*links, setup.following.resolution, figures);
  figures.judge_seconds = judging.seconds();
  return figures;
}

}  // namespace limpet::benchmarks
