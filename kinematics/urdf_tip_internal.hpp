// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace limpet::kinematics::internal {

/// A link that could be the tip of a robot.
struct TipCandidate {
  std::string name;
  std::size_t depth = 0;          ///< links from the base
  std::size_t moving_joints = 0;  ///< on the chain to it, that move by themselves
};

/// Which of them is the tip, when nobody says (UrdfOptions::tip): one when that is sure, several when it is
/// not. Precondition: there is a candidate.
std::vector<std::size_t> likely_tips(const std::vector<TipCandidate>&);

}  // namespace limpet::kinematics::internal
