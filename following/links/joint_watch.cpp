// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/joint_watch.hpp>

#include <cmath>

namespace limpet::following {

using kinematics::Configuration;
using kinematics::Joint;

void JointWatch::told(const kinematics::Robot& robot, const Configuration& changes) {
  constexpr double kFarEnough = 0.1;  // of the ceiling
  told_ = changes;
  matters_.clear();
  kinematics::for_each_moving_joint(robot, [&](Eigen::Index k, const Joint& joint) {
    matters_.push_back(std::abs(changes[k]) > kFarEnough * robot.ceilings.of(joint));
  });
}

bool JointWatch::look(const Configuration& now) {
  constexpr int kSets = 3;
  constexpr double kDone = 0.1;  // of what it was told
  bool found = false;
  for (std::size_t i = 0; i < matters_.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    if (!matters_[i] || stuck_[i]) continue;
    idle_[i] = std::abs(now[k] - before_[k]) < kDone * std::abs(told_[k]) ? idle_[i] + 1 : 0;
    if (idle_[i] >= kSets) found = stuck_[i] = true;
  }
  before_ = now;
  return found;
}

std::vector<std::size_t> JointWatch::stuck() const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < stuck_.size(); ++i)
    if (stuck_[i]) result.push_back(i);
  return result;
}

}  // namespace limpet::following
