// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "new_ground_internal.hpp"
#include "outlook_internal.hpp"

namespace limpet::following::internal {

/// A ray as far as it is asked about.
struct Ray {
  Eigen::Vector3d from, axis;  ///< axis: unit vector
  double range;
};

/// Where a ray crosses the plane {p : normal·p = height} from its front, no flatter than this cosine of
/// incidence, which is > 0; none: it does not.
inline std::optional<Eigen::Vector3d> crossing(const Ray& ray, const Eigen::Vector3d& normal, double height,
                                               double least_cosine) {
  const double fall = -ray.axis.dot(normal);
  if (fall < least_cosine) return std::nullopt;
  const double rise = normal.dot(ray.from) - height;
  if (rise < 0 || rise > ray.range * fall) return std::nullopt;
  return ray.from + rise / fall * ray.axis;
}

/// The planes near the control point in which surface is expected, and what readings in them are worth.
class ExpectedPlanes {
 public:
  ExpectedPlanes(double resolution, const Outlook&);

  /// Places are valued from now on by these rays, which are relative to the place, incidence up to this
  /// cosine (> 0).
  void look_along(const std::vector<Ray>&, double least_cosine);
  /// What the readings of the rays from a place are worth together: a ray serves one target, and a target one
  /// ray; or it meets new ground. Rays are served in their order. The answer does not depend on earlier
  /// questions. Precondition: look_along() has been called; else it is 0.
  double worth(const Eigen::Vector3d& place);
  /// Is the place less than this far over new ground, straight above it?
  bool is_low_over_new_ground(const Eigen::Vector3d& place, double distance) const;
  /// Adds where a ray meets new ground, for each plane.
  void add_new_ground(const Ray&, double least_cosine, std::vector<Eigen::Vector3d>& places) const;

 private:
  struct PlaneTarget {
    std::size_t target;
    Eigen::Vector2d flat;  ///< on the plane
    double lift2;          ///< squared distance from it
  };
  struct Plane {
    Eigen::Vector3d normal;
    double height;
    std::vector<PlaneTarget> targets;
    NewGround ground;
  };
  /// A ray's way to a plane, from a place that is `height` above it and over `flat`: where the sum with
  /// `from` is between 0 and `reach`, it meets the plane there.
  struct Way {
    std::size_t ray, plane;
    double from, reach;          ///< heights
    Eigen::Vector2d off, slope;  ///< on the plane: of the beginning, and for each unit of height
  };
  /// A place over a plane.
  struct Over {
    double height;
    Eigen::Vector2d flat;
  };
  struct Worth {
    double value = 0;
    std::optional<std::size_t> target;  ///< that is served; none: new ground is met, or nothing
  };
  Plane& plane_at(const Eigen::Vector3d& place, const Eigen::Vector3d& normal);
  Worth worth(const Plane&, const Eigen::Vector2d& meets) const;

  double lambda_;
  std::vector<Target> targets_;
  std::vector<int> met_;  ///< per target: the number of the last place from which it was met
  int place_number_ = 0;
  std::vector<Plane> planes_;
  std::vector<Way> ways_;   ///< ray by ray
  std::vector<Over> over_;  ///< each plane, of the place that is valued
};

}  // namespace limpet::following::internal
