// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limpet/following/clearance.hpp>
#include <limpet/following/follower.hpp>
#include <limpet/following/links/goal_postures.hpp>
#include <limpet/following/links/link_motion.hpp>
#include <memory>
#include <vector>

#include "travel_internal.hpp"

namespace limpet::following::internal {

/// Takes the robot to where something is left to be done. What is given to a call is of the last set.
class Transit {
 public:
  using Wanted = std::function<bool(const Eigen::Vector3d& place)>;

  virtual ~Transit() = default;

  /// The robot is here now. At the goal nothing is under way any more.
  virtual void arrive(const Observation&) = 0;
  /// Begins a way over what the robot has been at before to a place of the control point that is wanted, if
  /// there is one. Returns whether there is.
  virtual bool begin(const Wanted&) = 0;
  /// Begins a way to a place of the control point, if there may be one.
  virtual bool begin_to(const Eigen::Vector3d& place) = 0;
  /// Begins a way to where a sensor looks at a place where surface is suspected, if one is found: one at the
  /// control point if that can be. A point, which does not turn, has other ways to do that.
  virtual bool begin_to_see(const Suspicion&) { return false; }
  virtual void stop() = 0;
  /// Something has been found to do.
  virtual void arrived() = 0;
  virtual bool is_under_way() const = 0;

  // Precondition: is_under_way().

  virtual Eigen::Vector3d goal() const = 0;
  /// The places of the control point to go over, the next one first.
  virtual std::vector<Eigen::Vector3d> way() const = 0;
  /// How the last motion went; what has stopped it is gone round where that can be. What is not good, the
  /// caller stops.
  virtual Travel::Progress look(const Observation&, bool has_moved) = 0;
  virtual Motion next(const Observation&) = 0;
};

/// Of a robot that is a point: over places (Travel). `step`: its longest motion.
std::unique_ptr<Transit> make_place_transit(double resolution, double step, const Clearance&);

/// Of a robot with links whose motions are judged: over configurations (Roadmap), and to new ones by plans
/// (plan_to()).
std::unique_ptr<Transit> make_joint_transit(LinkMotion&);

}  // namespace limpet::following::internal
