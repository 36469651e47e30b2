// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>

#include "progress_internal.hpp"

namespace limpet::following::internal {

void Progress::restart(double way) {
  constexpr double kPatience = 10;
  most_steps_ = 10 * period_ + kPatience * way / longest_step_;
  window_.clear();
  steps_ = 0;
  insufficient_ = false;
}

void Progress::step(const kinematics::Posture& posture) {
  constexpr double kStill = 1e-3;  // of γ
  const bool still = last_ && is_near(posture.robot(), *last_, posture.configuration(), kStill);
  still_ = still ? still_ + 1 : 0;
  last_ = posture.configuration();
  window_.push_back(posture.configuration());
  const auto size = 2 * static_cast<std::size_t>(period_) + 1;
  if (window_.size() > size) window_.erase(window_.begin());
  if (steps_ > 0 && steps_ % period_ == 0) {
    const Configuration& before = window_[window_.size() - 1 - static_cast<std::size_t>(period_)];
    insufficient_ = is_near(posture.robot(), window_.back(), before, 1) ||
                    (window_.size() == size && circles(posture.robot())) || steps_ > most_steps_;
  }
  ++steps_;
}

bool Progress::is_near(const kinematics::Robot& robot, const Configuration& a, const Configuration& b,
                       double ceilings) const {
  const kinematics::LengthsByKind apart = kinematics::lengths_by_kind(robot, a - b);
  return apart.prismatic < ceilings * std::min(robot.ceilings.prismatic, longest_step_) &&
         apart.revolute_rad < ceilings * std::min(robot.ceilings.revolute_rad, angle_rad_);
}

bool Progress::circles(const kinematics::Robot& robot) const {
  Configuration mean = Configuration::Zero(window_.back().size());
  for (const Configuration& c : window_) mean += c;
  mean /= static_cast<double>(window_.size());
  return std::all_of(window_.begin(), window_.end(),
                     [&](const Configuration& c) { return is_near(robot, c, mean, 3); });
}

}  // namespace limpet::following::internal
