// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <functional>
#include <limpet/following/links/link_motion.hpp>
#include <limpet/following/links/roadmap.hpp>
#include <limpet/following/links/task.hpp>
#include <vector>

namespace limpet::following::internal {

/// What a posture is to be good for.
struct Wish {
  TaskIn task;  ///< leads to it
  /// How far a posture is from it; the less, the sooner it is tried to begin with.
  std::function<double(const kinematics::Posture&)> miss;
  /// What holds where the task has nothing left to go; empty: that will do.
  std::function<bool(const kinematics::Posture&)> holds;
};

/// Clear configurations that fulfil one of the wishes, as goal_postures() tells. `place`: nodes of the
/// roadmap near it are begun with.
std::vector<kinematics::Configuration> clear_goals(LinkMotion&, const Roadmap&, const Eigen::Vector3d& place,
                                                   const std::vector<Wish>&);

}  // namespace limpet::following::internal
