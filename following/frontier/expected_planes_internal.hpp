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
std::optional<Eigen::Vector3d> crossing(const Ray&, const Eigen::Vector3d& normal, double height,
                                        double least_cosine);

/// The planes near the control point in which surface is expected, and what readings in them are worth.
class ExpectedPlanes {
 public:
  ExpectedPlanes(double resolution, const Outlook&);

  /// What the readings of the rays from one place are worth together, incidence up to this cosine (> 0): a
  /// ray serves one target, and a target one ray; or it meets new ground. Rays are served in their order. The
  /// answer does not depend on earlier questions.
  double worth(const std::vector<Ray>&, double least_cosine);
  /// Is the place less than this far over new ground, straight above it?
  bool is_low_over_new_ground(const Eigen::Vector3d& place, double distance) const;
  /// Adds where a ray meets new ground, for each plane.
  void add_new_ground(const Ray&, double least_cosine, std::vector<Eigen::Vector3d>& places) const;

 private:
  struct Plane {
    Eigen::Vector3d normal;
    double height;
    std::vector<std::size_t> targets;
    NewGround ground;
  };
  struct Worth {
    double value = 0;
    std::optional<std::size_t> target;  ///< that is served; none: new ground is met, or nothing
  };
  Plane& plane_at(const Eigen::Vector3d& place, const Eigen::Vector3d& normal);
  Worth worth(const Plane&, const Eigen::Vector3d& meets) const;

  double lambda_;
  std::vector<Target> targets_;
  std::vector<int> met_;  ///< per target: the number of the last place from which it was met
  int place_number_ = 0;
  std::vector<Plane> planes_;
};

}  // namespace limpet::following::internal
