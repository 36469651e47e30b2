// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <limpet/evaluation/coverage.hpp>
#include <limpet/evaluation/reachable.hpp>
#include <limpet/simulation/box_world.hpp>
#include <limpet/simulation/shapes.hpp>
#include <memory>
#include <vector>

#include "../io/models.hpp"

/// Worlds for a point robot, with λ 0.1 and the thesis's multiples of it.
namespace limpet::evaluation::testing {

inline constexpr double kResolution = 0.1, kFollowDistance = 0.2, kRange = 0.4;
inline constexpr double kClearance = kFollowDistance - kResolution;

/// The 26 axes of the point robot, in some heading that is in line with nothing.
inline Sensing point_robot_sensing(const Eigen::Quaterniond& heading = Eigen::Quaterniond(0.9, 0.1, 0.3,
                                                                                          0.2)) {
  kinematics::PointRobotOptions options;
  options.sensing_range = kRange;
  options.heading = heading.normalized();
  const kinematics::Robot robot = kinematics::point_robot(options);
  return sensing_of(kinematics::Posture(robot, Eigen::Vector3d(0, 0, 0)));
}

/// A mesh, and what a robot that starts somewhere can reach of it.
struct RunWorld {
  simulation::Mesh mesh;
  std::unique_ptr<TrueSurface> surface;
  std::unique_ptr<FreeSpace> space;

  explicit RunWorld(simulation::Mesh truth, const Eigen::Vector3d& start = {-1, -1, -1}, double pitch = 0)
      : mesh(std::move(truth)), surface(std::make_unique<TrueSurface>(mesh)) {
    FreeSpaceOptions options;
    options.start = start;
    options.clearance = kClearance;
    options.margin = kRange;
    options.pitch = pitch;
    space = std::make_unique<FreeSpace>(*surface, simulation::bounds_of(mesh), options);
  }

  Reachability reachable(const Sensing& sensing = point_robot_sensing()) const {
    return find_reachable(mesh, *surface, *space, sensing, kResolution / 4);
  }
};

inline simulation::Mesh cube() { return simulation::make_shape("cube"); }

/// A unit cube with a slot of some width all along y, `depth` deep from the top.
inline simulation::Mesh slotted(double width, double depth) {
  simulation::BoxWorld world;
  world.add({0, 0, 0}, {1, 1, 1});
  world.carve({0.5 - width / 2, 0, 1 - depth}, {0.5 + width / 2, 1, 1});
  return world.surface();
}

/// A cube of side 2 with a cube of side 1 hollow in its middle.
inline simulation::Mesh hollow() {
  simulation::BoxWorld world;
  world.add({0, 0, 0}, {2, 2, 2});
  world.carve({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5});
  return world.surface();
}

/// The face of a mesh that looks this way and goes through this place; −1: none.
inline int face_at(const simulation::Mesh& mesh, const Eigen::Vector3d& normal, const Eigen::Vector3d& at) {
  const auto faces = simulation::faces_of(mesh);
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (faces[f].normal.dot(normal) > 0.99 && std::abs((at - faces[f].centroid).dot(normal)) < 1e-9)
      return static_cast<int>(f);
  return -1;
}

/// A model of those faces of a mesh that are wanted: perfect, and shared where two of them meet.
template <typename Wanted>
model::ModelRecord model_of(const simulation::Mesh& mesh, const Wanted& wanted) {
  io::testing::ModelMaker maker;
  const auto faces = simulation::faces_of(mesh);
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (wanted(static_cast<int>(f))) maker.face(faces[f].loops);
  return maker.make();
}
inline model::ModelRecord model_of(const simulation::Mesh& mesh) {
  return model_of(mesh, [](int) { return true; });
}

}  // namespace limpet::evaluation::testing
