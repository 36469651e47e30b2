// Copyright the limpet authors. GPL-3.0-or-later.
#include "simulated_run.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <limpet/simulation/box_world.hpp>
#include <limpet/simulation/initial_faces.hpp>
#include <limpet/simulation/shapes.hpp>
#include <limpet/simulation/world.hpp>
#include <limpet/survey/random.hpp>

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using simulation::Mesh;

Mesh boxes(const std::vector<std::array<Vector3d, 2>>& added,
           const std::vector<std::array<Vector3d, 2>>& carved = {}) {
  simulation::BoxWorld world;
  for (const auto& [low, high] : added) world.add(low, high);
  for (const auto& [low, high] : carved) world.carve(low, high);
  return world.surface();
}

Mesh icosahedron() {
  const double g = 1.6180339887498949;
  std::vector<Vector3d> v;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-g, g}) {
      v.emplace_back(0, a, b), v.emplace_back(a, b, 0), v.emplace_back(b, 0, a);
    }
  std::vector<std::vector<int>> faces;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j)
      for (int k = 0; k < 12; ++k) {
        const auto apart = [&](int a, int b) { return std::abs((v[a] - v[b]).norm() - 2) < 1e-6; };
        if (i < j && i < k && apart(i, j) && apart(j, k) && apart(k, i) &&
            (v[j] - v[i]).cross(v[k] - v[i]).dot(v[i]) > 0)
          faces.push_back({i, j, k});
      }
  for (Vector3d& p : v) p *= 0.5;  // edges of length 1
  return simulation::make_mesh(v, faces);
}

double distance_to_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d n = (b - a).cross(c - a).normalized();
  const auto inside = [&](const Vector3d& u, const Vector3d& v) { return n.dot((v - u).cross(p - u)) >= 0; };
  if (inside(a, b) && inside(b, c) && inside(c, a)) return std::abs(n.dot(p - a));
  const auto to_side = [&](const Vector3d& u, const Vector3d& v) {
    const double t = std::clamp((p - u).dot(v - u) / (v - u).squaredNorm(), 0.0, 1.0);
    return (u + t * (v - u) - p).norm();
  };
  return std::min({to_side(a, b), to_side(b, c), to_side(c, a)});
}

double distance_to(const Mesh& mesh, const Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles)
    least = std::min(least,
                     distance_to_triangle(p, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]));
  return least;
}

/// A place at the follow distance from the mesh, before one of its faces.
Vector3d random_start(const Mesh& mesh, double distance, survey::Random& random) {
  const auto faces = simulation::faces_of(mesh);
  for (;;) {
    const auto& t = mesh.triangles[random.below(mesh.triangles.size())];
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Vector3d place = a + u * (b - a) + v * (c - a) + distance * (b - a).cross(c - a).normalized();
    if (distance_to(mesh, place) > 0.999 * distance) return place;
  }
}

Eigen::Quaterniond random_heading(survey::Random& random) {
  const double w = random.normal(), x = random.normal(), y = random.normal(), z = random.normal();
  return Eigen::Quaterniond(w, x, y, z).normalized();
}

class SimulatedRobot {
 public:
  SimulatedRobot(const Mesh& mesh, const RunOptions& options, double range)
      : world_(simulation::make_mesh_world(mesh)),
        random_(options.seed),
        noise_(options.noise),
        robot_(kinematics::point_robot({range, options.resolution, random_heading(random_)})),
        posture_(robot_, random_start(mesh, 2 * options.resolution, random_)) {}

  std::vector<model::SensorPoint> sense() {
    std::vector<model::SensorPoint> readings;
    for (std::size_t i = 0; i < robot_.sensors.size(); ++i) {
      const auto sensor = posture_.sensor(i);
      if (const auto seen = world_->sight(sensor.position, sensor.axis, sensor.range))
        readings.push_back(posture_.sensor_point(i, seen->distance + noise_ * random_.normal()));
    }
    return readings;
  }
  void move(const kinematics::Configuration& changes) {
    posture_ = kinematics::Posture(robot_, posture_.configuration() + changes);
  }
  const kinematics::Posture& posture() const { return posture_; }

 private:
  std::unique_ptr<simulation::World> world_;
  survey::Random random_;
  double noise_;
  kinematics::Robot robot_;
  kinematics::Posture posture_;
};

double least_along(const Mesh& mesh, const Vector3d& a, const Vector3d& b) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 4; ++i) least = std::min(least, distance_to(mesh, a + i / 4.0 * (b - a)));
  return least;
}

}  // namespace

const std::vector<std::string>& world_names() {
  static const std::vector<std::string> names{"cube",  "box",   "L",           "step",
                                              "notch", "cross", "icosahedron", "octahedron"};
  return names;
}

Mesh make_world_mesh(const std::string& name) {
  if (name == "box") return boxes({{{{0, 0, 0}, {1.5, 1, 0.5}}}});
  if (name == "step")  // a staircase
    return boxes({{{{0, 0, 0}, {1.5, 1, 0.5}}}, {{{0, 0, 0.5}, {1, 1, 1}}}, {{{0, 0, 1}, {0.5, 1, 1.5}}}});
  if (name == "notch") return boxes({{{{0, 0, 0}, {1.5, 1, 1}}}}, {{{{0.5, 0, 0.5}, {1, 1, 1}}}});
  if (name == "cross") return boxes({{{{0, 0.5, 0}, {1.5, 1, 0.5}}}, {{{0.5, 0, 0}, {1, 1.5, 0.5}}}});
  if (name == "icosahedron") return icosahedron();
  return simulation::make_shape(name);
}

RunResult run_following(const Mesh& mesh, const RunOptions& options,
                        const std::function<void(const Observation&, const Motion&)>& watch) {
  const Parameters parameters = usual_parameters(options.resolution);
  SimulatedRobot robot(mesh, options, parameters.sensing_range);
  model::Parameters model_parameters;
  model_parameters.resolution = options.resolution;
  model_parameters.noise = options.noise;
  model::Model model(model_parameters);
  model.add_initial(simulation::initial_faces(mesh, options.known));
  const auto follower = make_follower(options.strategy, parameters);
  RunResult result;
  result.clearance = result.model_clearance = std::numeric_limits<double>::infinity();
  while (result.sets < options.most_sets) {
    const auto readings = robot.sense();
    const auto& changes = model.update(readings);
    ++result.sets;
    const Vector3d before = robot.posture().control_point();
    result.places.push_back(before);
    const Observation seen{model, changes, robot.posture(), readings};
    const auto start = std::chrono::steady_clock::now();
    const Motion motion = follower->next(seen);
    result.step_us.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
    if (watch) watch(seen, motion);
    ++result.sets_by_mode[static_cast<std::size_t>(motion.mode)];
    result.end = motion.end;
    if (motion.end != End::none) break;
    robot.move(kinematics::actuator_changes(robot.posture(), motion.displacement));
    const Vector3d after = robot.posture().control_point();
    result.path += (after - before).norm();
    result.clearance = std::min(result.clearance, least_along(mesh, before, after));
    const auto near = model.view().nearest(model::Capsule{before, after, 0}, 1);
    const auto start_near = model.view().nearest(before, 1);
    if (near && start_near) {
      result.model_clearance = std::min(result.model_clearance, near->distance);
      const double allowed = std::min(parameters.clearance(), start_near->distance);
      result.encroachment = std::max(result.encroachment, allowed - near->distance);
    }
  }
  result.marks = follower->marks();
  model.finish();
  result.polygons = model.counts().polygons;
  result.confirmed = model.counts().confirmed;
  std::vector<model::View::Edge> open;
  model.view().open_edges(open);
  result.open_edges = std::ssize(open);
  result.closed = result.polygons > 0 && result.open_edges == 0;
  return result;
}

Motion motion_at_rest(Strategy strategy, const std::vector<model::SensorPoint>& readings, int sets,
                      model::Model& model) {
  const auto robot = kinematics::point_robot({});
  const kinematics::Posture posture(robot, Vector3d(0, 0, 0.1));
  const auto follower = make_follower(strategy, usual_parameters(0.05));
  Motion motion;
  for (int i = 0; i < sets && motion.end == End::none; ++i)
    motion = follower->next({model, model.update(readings), posture, readings});
  return motion;
}

}  // namespace limpet::following
