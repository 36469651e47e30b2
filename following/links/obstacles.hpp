// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include <limpet/following/recent_readings.hpp>
#include <limpet/kinematics/body.hpp>
#include <limpet/kinematics/redundancy.hpp>
#include <limpet/model/view.hpp>

namespace limpet::following {

/// What a robot's links have to keep off, near where they are now: the surface model, and readings.
class Obstacles {
 public:
  /// `readings`: those that may matter are within `reach` of the body in this posture, or are left out.
  Obstacles(const model::View& view, const RecentReadings& readings,
            std::span<const kinematics::BodyPart> body, const kinematics::Posture&, double reach);

  /// Distance of a capsule (world) from the nearest obstacle, or `reach` when there is none that near.
  double distance(const model::Capsule&, double reach) const;
  /// The nearest obstacle of each part, if it is within `reach` (thesis §3.3: one pair of points for each
  /// link; of a link of several parts, the nearest).
  void nearest_of_links(const kinematics::Posture&, std::span<const kinematics::BodyPart> body, double reach,
                        std::vector<kinematics::Proximity>&) const;
  /// For each part, the nearest point of each model segment within `reach`, and of each reading that is
  /// nearest in its direction.
  void near(const kinematics::Posture&, std::span<const kinematics::BodyPart> body, double reach,
            std::vector<kinematics::Proximity>&) const;

 private:
  const model::View& view_;
  std::vector<Eigen::Vector3d> readings_;
};

}  // namespace limpet::following
