// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/following/links/link_motion.hpp>
#include <limpet/kinematics/arm.hpp>
#include <limpet/model/model.hpp>
#include <vector>

#include "../kinematics/robots.hpp"

namespace limpet::following {

namespace robots = kinematics::testing;

/// A square of this half side around a place, facing somewhere, as a face known beforehand.
inline void add_square(model::Model& model, survey::Random& random, const Eigen::Vector3d& about,
                       double half = 1) {
  Eigen::Isometry3d pose = robots::random_pose(random);
  pose.translation() = about;
  std::vector<Eigen::Vector3d> cycle;
  for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
    cycle.push_back(pose * (half * Eigen::Vector3d(x, y, 0)));
  model.add_initial(std::vector<model::InitialFace>{{{cycle}}});
}

/// A planar arm whose links are bars, with limits: all that it does is in the plane z = 0.
inline kinematics::Robot bars(int links) {
  kinematics::Robot robot = robots::planar_arm(links);
  for (kinematics::Link& link : robot.links) {
    link.body = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), 0.02}};
    link.joint.low = -3, link.joint.high = 3;
  }
  robot.ceilings.revolute_rad = 0.1;
  return robot;
}

/// A wall in the plane x = `x`, from y0 to y1.
inline model::InitialFace wall(double x, double y0, double y1) {
  return {{{{x, y0, -1}, {x, y0, 1}, {x, y1, 1}, {x, y1, -1}}}};
}

/// The smallest distance of any part of the body from the model along a way that is straight in joint space,
/// as far as 1, by looking at many places.
inline double least_distance(const LinkGuard& guard, const model::View& view,
                             const kinematics::Configuration& from, const kinematics::Configuration& to) {
  constexpr int kPlaces = 40;
  double least = 1;
  for (int i = 0; i <= kPlaces; ++i) {
    const kinematics::Posture posture(guard.robot(), from + (to - from) * (double(i) / kPlaces));
    for (const kinematics::BodyPart& part : guard.body())
      if (const auto near = view.nearest(kinematics::in_world(part, posture), least))
        least = std::min(least, near->distance);
  }
  return least;
}

}  // namespace limpet::following
