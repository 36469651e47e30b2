// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include <limpet/kinematics/robot.hpp>

namespace limpet::kinematics {

// Range finders in patterns, so that a robot's skin is a few lines. Places and directions are in the frame of
// the link that carries the sensors; a direction may have any finite length but 0. Each function throws
// std::invalid_argument, with one line that says what is wrong, when something is not finite, a range is not
// positive, a radius is negative, a direction has no length, or a count is 0.

/// Sensors around a link, that look away from its axis.
struct Ring {
  std::size_t link = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< of the link, through the centre
  double radius = 0;                                ///< of the circle that the sensors are on
  std::size_t count = 8;
  double tilt_rad = 0;  ///< how far the sensing axes lean from straight outwards towards `axis`
  /// Where the first sensor is: turned so far about `axis`, from the direction nearest to the coordinate axis
  /// that is least along it (of equal ones the first). The others follow in equal steps.
  double turn_rad = 0;
  double range = 0;
};
std::vector<RangeSensor> ring(const Ring&);

/// Rings at equal distances along a segment, from its one end to its other, about the segment.
struct Rings {
  std::size_t link = 0;
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::UnitX();  ///< centres: first, last
  std::size_t rings = 4;                                                          ///< one: in the middle
  double radius = 0;
  std::size_t count = 8;  ///< sensors of each ring
  double tilt_rad = 0;    ///< towards `to`
  bool staggered = true;  ///< every other ring is turned by half a step
  double range = 0;
};
std::vector<RangeSensor> rings(const Rings&);

/// A grid on a rectangle, that looks away from one side of it. The outermost sensors are on its border.
struct Patch {
  std::size_t link = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();   ///< one side, as long as the side is
  Eigen::Vector3d across = Eigen::Vector3d::UnitY();  ///< the other, orthogonal to it
  std::size_t columns = 2, rows = 2;                  ///< sensors along and across; one is in the middle
  double range = 0;                                   ///< the sensing axes are along × across
};
std::vector<RangeSensor> patch(const Patch&);

/// Sensors in one place that look all around: in the directions from a cube's centre to its 6 faces, 12 edges
/// and 8 corners, in this order (thesis §4.3, figure 40). Those within a cone may be left out, because the
/// robot itself is there.
struct Ball {
  std::size_t link = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> without{};            ///< the cone's axis
  double without_rad = 60 * (std::numbers::pi / 180);  ///< from the axis; 60° about a face's leaves out 9
  double range = 0;
};
std::vector<RangeSensor> ball(const Ball&);

/// Staggered rings on all capsules of a link, as on the links of the thesis's arm, but for sensors that would
/// be inside another capsule of the link.
struct Skin {
  std::size_t link = 0;
  double spacing = 0;  ///< of the rings, at most; a capsule has one at each end, or one if it is a ball
  /// Sensors of each ring; 0: as many as see as densely as those on the thesis's arm do, whose links are
  /// thinner: 1.35 spacings from ray to ray, 0.6 spacings in front of the capsule. At least 4.
  std::size_t count = 0;
  double range = 0;
};
std::vector<RangeSensor> skin(const Robot&, const Skin&);

/// Sensors for a robot that nobody has given any: a ball at the control point, without what looks back to
/// where its link is held, and a skin on each link that a joint moves, with rings half a range apart.
std::vector<RangeSensor> usual_sensors(const Robot&, double range);

}  // namespace limpet::kinematics
