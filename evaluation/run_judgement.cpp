// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/run_judgement.hpp>

#include <algorithm>
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
  require(!options.arm || options.arm_samples > 0, "what an arm can feel is judged by one sample at least");
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
  search.link_clearance = options.arm->link_clearance;
  search.spared = options.arm->spared;
  search.least_cosine = options.sensing.least_cosine;
  return search;
}

/// Of the samples that are not covered, at most `count`, evenly.
std::vector<char> to_ask_for(const std::vector<char>& covered, std::size_t count) {
  const auto open = static_cast<std::size_t>(std::count(covered.begin(), covered.end(), char{0}));
  const std::size_t every = std::max<std::size_t>(1, (open + count - 1) / count);
  std::vector<char> asked;
  std::size_t passed = 0;
  for (const char is_covered : covered) asked.push_back(is_covered == 0 && passed++ % every == 0);
  return asked;
}

/// Which of an arm's marks are contradicted: by samples that lie closer than those of all of the surface.
FalseUnreachable contradicted(const simulation::Mesh& truth, const FollowingRun& run,
                              const std::vector<PlanarFace>& model, const RunJudgementOptions& options,
                              ArmReach& reach) {
  if (run.marks.empty()) return {};
  const double resolution = options.resolution, spacing = resolution / 4;
  Reachability near;
  near.samples = near_marks(run.marks, samples_of(truth, spacing), resolution);
  near.verdicts.resize(near.samples.size(), Verdict::doubtful);
  near.faces.resize(static_cast<std::size_t>(truth.face_count));
  const Coverage covered = coverage_of(model, near, resolution);
  near = reach
             .of(std::move(near.samples), spacing, to_ask_for(covered.covered, 2 * options.arm_samples),
                 options.progress)
             .reachability;
  return false_unreachable(run.marks, near, covered, resolution);
}

void judge_arm(const simulation::Mesh& truth, const TrueSurface& surface, const FollowingRun& run,
               const RunJudgementOptions& options, RunJudgement& result) {
  const std::vector<PlanarFace> model = planar_faces(run.model);
  ArmReach reach(truth, surface, *options.arm, search_of(options));
  auto [samples, spacing] = about(options.arm_samples, truth);
  result.reachability = reach.of(std::move(samples), spacing, {}, options.progress).reachability;
  result.covered = coverage_of(model, result.reachability, options.resolution);
  result.marks = contradicted(truth, run, model, options, reach);
}

void judge_point_robot(const simulation::Mesh& truth, const TrueSurface& surface, const FollowingRun& run,
                       const RunJudgementOptions& options, RunJudgement& result) {
  const FreeSpace space(surface, simulation::bounds_of(truth), space_of(run, options));
  result.reachability = find_reachable(truth, surface, space, options.sensing, options.spacing);
  result.covered = coverage_of(planar_faces(run.model), result.reachability, options.resolution);
  result.marks = false_unreachable(run.marks, result.reachability, result.covered, options.resolution);
  if (options.tour)
    result.tour =
        offline_tour(truth, surface, space, result.reachability, options.sensing, tour_of(run, options));
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
  const TrueSurface surface(truth);
  RunJudgement result;
  result.sets = run.path.size();
  if (options.arm)
    judge_arm(truth, surface, run, options, result);
  else
    judge_point_robot(truth, surface, run, options, result);
  result.clearance = clearance_of(run.path, surface);
  result.topology = judge_reachable_topology(run.model, truth, result.reachability, options.resolution);
  take_figures(result);
  return result;
}

}  // namespace limpet::evaluation
