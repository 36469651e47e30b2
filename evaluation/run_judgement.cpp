// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/run_judgement.hpp>

#include <limpet/evaluation/planar_face.hpp>
#include <stdexcept>

namespace limpet::evaluation {
namespace {

void require(bool good, const char* what) {
  if (!good) throw std::invalid_argument(what);
}

RunJudgementOptions checked(RunJudgementOptions options, const FollowingRun& run) {
  require(!run.path.empty(), "a run to be judged has at least one position");
  require(options.resolution > 0, "judging needs a linear resolution above zero");
  require(options.follow_distance > options.resolution,
          "the follow distance must be larger than the linear resolution");
  require(options.arm || options.sensing.range > 0, "the sensing range must be positive");
  require(options.spacing >= 0, "the spacing of samples must not be negative");
  require(!options.tour || !options.arm, "there is no offline tour of an arm");
  require(!options.tour || options.ceiling > 0, "an offline tour needs a longest step above zero");
  if (options.spacing == 0) options.spacing = options.resolution / 4;
  return options;
}

FreeSpaceOptions space_of(const FollowingRun& run, const RunJudgementOptions& options) {
  FreeSpaceOptions space;
  space.start = run.path.front();
  space.clearance = options.follow_distance - options.resolution;
  space.margin = options.sensing.range;
  space.pitch = options.pitch;
  return space;
}

TourOptions tour_of(const FollowingRun& run, const RunJudgementOptions& options) {
  TourOptions tour;
  tour.start = run.path.front();
  tour.resolution = options.resolution;
  tour.follow_distance = options.follow_distance;
  tour.max_step = options.ceiling;
  return tour;
}

ArmSearchOptions search_of(const RunJudgementOptions& options) {
  ArmSearchOptions search;
  search.resolution = options.resolution;
  search.control_clearance = options.follow_distance - options.resolution;
  search.least_cosine = options.sensing.least_cosine;
  search.samples = options.arm_samples;
  return search;
}

void take_figures(RunJudgement& result) {
  result.coverage = result.covered.of_reachable;
  result.coverage_total = result.covered.of_all;
  result.reachable_share = result.reachability.share;
  result.doubtful_share = result.reachability.doubtful;
  result.path_length = result.clearance.length;
  result.collisions = result.clearance.collisions;
  result.clearance_control_point = result.clearance.along;
  result.worst_step = result.clearance.worst;
  result.false_unreachable = result.marks.count;
  result.isomorphic = result.topology.isomorphic;
}

}  // namespace

RunJudgement judge_run(const simulation::Mesh& truth, const FollowingRun& run,
                       const RunJudgementOptions& wanted) {
  const RunJudgementOptions options = checked(wanted, run);
  const double resolution = options.resolution;
  const TrueSurface surface(truth);
  std::optional<FreeSpace> space;
  RunJudgement result;
  result.sets = run.path.size();
  if (options.arm) {
    result.reachability = find_reachable(truth, surface, *options.arm, search_of(options)).reachability;
  } else {
    space.emplace(surface, simulation::bounds_of(truth), space_of(run, options));
    result.reachability = find_reachable(truth, surface, *space, options.sensing, options.spacing);
  }
  result.covered = coverage_of(planar_faces(run.model), result.reachability, resolution);
  result.clearance = clearance_of(run.path, surface);
  result.marks = false_unreachable(run.marks, result.reachability, result.covered, resolution);
  result.topology = judge_reachable_topology(run.model, truth, result.reachability, resolution);
  take_figures(result);
  if (options.tour)
    result.tour =
        offline_tour(truth, surface, *space, result.reachability, options.sensing, tour_of(run, options));
  return result;
}

}  // namespace limpet::evaluation
