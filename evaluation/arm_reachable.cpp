// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limpet/evaluation/arm_reachable.hpp>
#include <limpet/evaluation/arm_search_internal.hpp>
#include <limpet/evaluation/out_of_reach_internal.hpp>
#include <limpet/evaluation/reachable_internal.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

namespace limpet::evaluation {
namespace {

using kinematics::Posture;

constexpr int kRandom = 300;            // configurations that the roadmap begins with, clear or not
constexpr double kPrecision = 1e-3;     // of a sighting, in λ
constexpr double kFineness = 1.0 / 50;  // of ways, in λ
constexpr std::uint64_t kStream = 0x726f61646d617073u;

ArmSearchOptions checked(ArmSearchOptions options, const PlacedArm& arm) {
  const auto require = [](bool good, const char* what) {
    if (!good) throw std::invalid_argument(what);
  };
  require(options.resolution > 0, "judging needs a linear resolution above zero");
  require(options.control_clearance > 0, "the clearance of the control point must be positive");
  require(options.link_clearance >= 0, "the clearance of links must not be negative");
  require(!arm.robot.sensors.empty(), "the robot has no sensors");
  require(static_cast<std::size_t>(arm.start.size()) == arm.robot.joint_count() && arm.start.allFinite(),
          "the start must have one finite position for each joint");
  if (options.link_clearance == 0) options.link_clearance = options.resolution / 10;
  return options;
}

ArmClearances clearances_of(const ArmSearchOptions& options, const simulation::Mesh& mesh,
                            const TrueSurface& truth, const PlacedArm& arm) {
  ArmClearances clearances;
  clearances.control_point = options.control_clearance;
  clearances.links = options.link_clearance;
  clearances.own = options.resolution / 10;
  clearances.spared = options.spared;
  clearances.fineness = kFineness * options.resolution;
  clearances.slide =
      simulation::bounds_of(mesh).diagonal() + truth.distance(Posture(arm.robot, arm.start).control_point());
  return clearances;
}

}  // namespace

struct ArmReach::Inside {
  Inside(const simulation::Mesh& mesh, const TrueSurface& truth, const PlacedArm& placed,
         const ArmSearchOptions& checked_options)
      : arm(placed),
        options(checked_options),
        faces(static_cast<std::size_t>(mesh.face_count)),
        out_of_reach(mesh, truth, Posture(arm.robot, arm.start), options.control_clearance),
        space(arm.robot, truth, arm.start, clearances_of(options, mesh, truth, arm)),
        random(options.seed ^ kStream),
        planner(space, arm.start, random) {
    planner.add_way(arm.known);
    planner.add_random(kRandom);
  }

  const PlacedArm& arm;
  ArmSearchOptions options;
  std::size_t faces;
  OutOfReach out_of_reach;
  ArmSpace space;
  survey::Random random;
  ArmPlanner planner;
};

ArmReach::ArmReach(const simulation::Mesh& mesh, const TrueSurface& truth, const PlacedArm& arm,
                   const ArmSearchOptions& options)
    : inside_(std::make_unique<Inside>(mesh, truth, arm, checked(options, arm))) {}
ArmReach::~ArmReach() = default;

const ArmRoadmap& ArmReach::roadmap() const { return inside_->planner.roadmap(); }

ArmReachability ArmReach::of(std::vector<SurfaceSample> samples, double spacing, std::vector<char> asked,
                             const SearchProgress& progress) {
  ArmReachability result;
  Reachability& found = result.reachability;
  found.samples = std::move(samples);
  found.spacing = spacing;
  found.faces.resize(inside_->faces);
  asked.resize(found.samples.size(), asked.empty());
  std::vector<char> ruled_out;
  for (std::size_t i = 0; i < found.samples.size(); ++i) {
    ruled_out.push_back(inside_->out_of_reach.holds(found.samples[i]));
    if (ruled_out[i] != 0) asked[i] = false;
  }
  ArmSearch search(inside_->space, inside_->planner, found.samples, spacing,
                   {inside_->options.least_cosine, kPrecision * inside_->options.resolution},
                   inside_->random);
  search.look_for(asked, progress);
  for (std::size_t i = 0; i < found.samples.size(); ++i) {
    const auto sighting = search.sighting(i);
    found.verdicts.push_back(sighting ? Verdict::yes : ruled_out[i] != 0 ? Verdict::no : Verdict::doubtful);
    result.sightings.push_back(sighting.value_or(ArmReachability::Sighting()));
    found.seen_from.push_back(found.samples[i].at);
    if (!sighting) continue;
    const Posture posture(inside_->arm.robot, roadmap().at(sighting->node));
    found.seen_from.back() = posture.sensor(sighting->sensor).position;
  }
  sum_up(found);
  return result;
}

std::pair<std::vector<SurfaceSample>, double> about(std::size_t count, const simulation::Mesh& mesh) {
  double area = 0;
  for (const simulation::Face& face : simulation::faces_of(mesh)) area += face.area;
  const double each = area / static_cast<double>(count), spacing = std::sqrt(each);
  std::vector<SurfaceSample> all = samples_of(mesh, spacing), some;
  if (all.size() <= 2 * count) return {std::move(all), spacing};
  double passed = -each / 2;
  for (const SurfaceSample& sample : all)
    for (passed += sample.area; passed > 0; passed -= each) {
      some.push_back(sample);
      some.back().area = each;
    }
  return {std::move(some), spacing};
}

}  // namespace limpet::evaluation
