// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include <limpet/kinematics/body.hpp>
#include <limpet/kinematics/redundancy.hpp>
#include <limpet/model/view.hpp>

namespace limpet::following {

/// What a robot's links have to keep off: the surface model, and readings that it does not have yet, around
/// each of which a ball counts as surface.
class Obstacles {
 public:
  /// Valid as long as the view. `reading_radius`: of the balls; ≥ 0.
  Obstacles(const model::View& view, std::vector<Eigen::Vector3d> readings, double reading_radius)
      : view_(view), readings_(std::move(readings)), radius_(reading_radius) {}

  const model::View& view() const { return view_; }

  /// Distance of a capsule (world) from the nearest obstacle, or `reach` when there is none that near.
  double distance(const model::Capsule&, double reach) const;
  /// The nearest segment of the model to each link, if it is within `reach` (thesis §3.3: one pair of points
  /// for each link; of a link of several parts, the nearest).
  void nearest_of_links(const kinematics::Posture&, std::span<const kinematics::BodyPart> body, double reach,
                        std::vector<kinematics::Proximity>&) const;
  /// For each part, the nearest point of each model segment within `reach`, and of each reading that is
  /// nearest in its direction.
  void near(const kinematics::Posture&, std::span<const kinematics::BodyPart> body, double reach,
            std::vector<kinematics::Proximity>&) const;
  /// The smallest distance of any part from the model and from the readings themselves, if within `reach`;
  /// else infinite.
  double clearance(const kinematics::Posture&, std::span<const kinematics::BodyPart> body,
                   double reach) const;

 private:
  double distance(const model::Capsule&, double reach, double reading_radius) const;

  model::View view_;
  std::vector<Eigen::Vector3d> readings_;
  double radius_;
};

}  // namespace limpet::following
