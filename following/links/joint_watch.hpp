// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <limpet/kinematics/posture.hpp>
#include <vector>

namespace limpet::following {

/// Finds joints that do not do what they are told. A robot one of whose joints sticks makes other motions
/// than were found to be clear.
///
///     JointWatch watch(robot.joint_count());
///     watch.told(changes);
///     ...
///     watch.look(posture.configuration());
///
/// A joint that was told to move by a good part of what the ceilings let it, at three sets in a row of those
/// at which it was told so, and has made less than a tenth of it at each, is stuck, and stays so.
class JointWatch {
 public:
  explicit JointWatch(std::size_t joints) : idle_(joints, 0), stuck_(joints, false) {}

  /// The changes that the robot is to make next.
  void told(const kinematics::Robot&, const kinematics::Configuration& changes);
  /// Where the joints are after that, as their encoders say. Returns whether a joint has been found to be
  /// stuck that was not before.
  bool look(const kinematics::Configuration& now);
  /// The joints that are stuck, ascending.
  std::vector<std::size_t> stuck() const;

 private:
  kinematics::Configuration before_, told_;
  std::vector<bool> matters_;  ///< was the joint told to move far enough to judge by?
  std::vector<int> idle_;      ///< sets in a row, of those that matter, at which a joint did not move
  std::vector<bool> stuck_;
};

}  // namespace limpet::following
