// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limpet/evaluation/arm_reachable.hpp>
#include <limpet/evaluation/arm_search_internal.hpp>
#include <limpet/evaluation/joint_levers_internal.hpp>
#include <limpet/evaluation/reachable_internal.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using kinematics::Posture;
using kinematics::Robot;

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
  require(options.samples > 0, "what an arm can feel is judged by one sample at least");
  require(!arm.robot.sensors.empty(), "the robot has no sensors");
  require(static_cast<std::size_t>(arm.start.size()) == arm.robot.joint_count() && arm.start.allFinite(),
          "the start must have one finite position for each joint");
  if (options.link_clearance == 0) options.link_clearance = options.resolution / 10;
  return options;
}

/// About so many samples, spread evenly. Of a mesh with more faces than that some faces have none.
std::vector<SurfaceSample> spread(const simulation::Mesh& mesh, std::size_t count, double& spacing) {
  double area = 0;
  for (const simulation::Face& face : simulation::faces_of(mesh)) area += face.area;
  spacing = std::sqrt(area / static_cast<double>(count));
  std::vector<SurfaceSample> all = samples_of(mesh, spacing), some;
  if (all.size() < 2 * count) return all;
  const double each = area / static_cast<double>(count);
  double passed = -each / 2;
  for (const SurfaceSample& sample : all)
    for (passed += sample.area; passed > 0; passed -= each) {
      some.push_back(sample);
      some.back().area = each;
    }
  return some;
}

/// What samples of the surface no configuration can see, whatever is in the way.
class OutOfReach {
 public:
  OutOfReach(const simulation::Mesh& mesh, const TrueSurface& truth, const PlacedArm& arm, double clearance) {
    const Vector3d control_point = Posture(arm.robot, arm.start).control_point();
    bool all_at_control_point = true;
    for (const kinematics::RangeSensor& sensor : arm.robot.sensors) {
      ReachBall ball = reach_of_point(arm.robot, sensor.link, sensor.position);
      ball.radius += sensor.range;
      const auto is_known = [&](const ReachBall& other) {
        return other.centre == ball.centre && other.radius >= ball.radius;
      };
      if (std::none_of(balls_.begin(), balls_.end(), is_known)) balls_.push_back(ball);
      range_ = std::max(range_, sensor.range);
      all_at_control_point &= sensor.link == arm.robot.control_point.link &&
                              (sensor.position - arm.robot.control_point.position).norm() < 1e-9 * range_;
    }
    if (!all_at_control_point) return;
    FreeSpaceOptions options;
    options.start = control_point;
    options.clearance = clearance;
    options.margin = range_;
    space_.emplace(truth, simulation::bounds_of(mesh), options);
  }

  bool holds(const SurfaceSample& sample) const {
    const auto is_beyond = [&](const ReachBall& ball) {
      return (sample.at - ball.centre).norm() > ball.radius * (1 + 1e-9);
    };
    return std::all_of(balls_.begin(), balls_.end(), is_beyond) || (space_ && is_enclosed(sample));
  }

 private:
  /// Does the control point get nowhere within range? Looked at in each cell of the lattice.
  bool is_enclosed(const SurfaceSample& sample) const {
    const double pitch = space_->pitch(), far = range_ + std::sqrt(3.0) * pitch;
    const int count = static_cast<int>(std::ceil(far / pitch));
    for (int x = -count; x <= count; ++x)
      for (int y = -count; y <= count; ++y)
        for (int z = -count; z <= count; ++z) {
          const Vector3d away = pitch * Vector3d(x, y, z);
          if (away.norm() > far || away.dot(sample.normal) < -std::sqrt(3.0) * pitch) continue;
          if (space_->ruled_out(sample.at + away, Vector3d::UnitX()) == 0) return false;
        }
    return true;
  }

  std::vector<ReachBall> balls_;
  double range_ = 0;
  std::optional<FreeSpace> space_;
};

ArmClearances clearances_of(const ArmSearchOptions& options, const simulation::Mesh& mesh,
                            const TrueSurface& truth, const PlacedArm& arm) {
  ArmClearances clearances;
  clearances.control_point = options.control_clearance;
  clearances.links = clearances.own = options.link_clearance;
  clearances.fineness = kFineness * options.resolution;
  clearances.slide =
      simulation::bounds_of(mesh).diagonal() + truth.distance(Posture(arm.robot, arm.start).control_point());
  return clearances;
}

}  // namespace

ArmReachability find_reachable(const simulation::Mesh& mesh, const TrueSurface& truth, const PlacedArm& arm,
                               const ArmSearchOptions& wanted) {
  const ArmSearchOptions options = checked(wanted, arm);
  ArmReachability result;
  Reachability& found = result.reachability;
  found.samples = spread(mesh, options.samples, found.spacing);
  found.faces.resize(static_cast<std::size_t>(mesh.face_count));
  const OutOfReach out_of_reach(mesh, truth, arm, options.control_clearance);
  std::vector<char> perhaps;
  for (const SurfaceSample& sample : found.samples) perhaps.push_back(!out_of_reach.holds(sample));

  const ArmSpace space(arm.robot, truth, arm.start, clearances_of(options, mesh, truth, arm));
  survey::Random random(options.seed ^ kStream);
  ArmPlanner planner(space, arm.start, random);
  planner.add_way(arm.known);
  planner.add_random(kRandom);
  ArmSearch search(space, planner, found.samples, found.spacing,
                   {options.least_cosine, kPrecision * options.resolution}, random);
  search.look_for(perhaps);

  for (std::size_t i = 0; i < found.samples.size(); ++i) {
    const auto sighting = search.sighting(i);
    found.verdicts.push_back(sighting ? Verdict::yes : perhaps[i] != 0 ? Verdict::doubtful : Verdict::no);
    result.sightings.push_back(sighting.value_or(ArmReachability::Sighting()));
    found.seen_from.push_back(
        sighting ? Posture(arm.robot, planner.roadmap().at(sighting->node)).sensor(sighting->sensor).position
                 : found.samples[i].at);
  }
  sum_up(found);
  result.roadmap = planner.take();
  return result;
}

}  // namespace limpet::evaluation
