// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limpet/following/follower.hpp>
#include <limpet/kinematics/robot.hpp>
#include <limpet/model/model.hpp>
#include <limpet/simulation/sensing.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What a recorded run of following consists of (docs/run_format.md). Lengths are in the scan's unit.
namespace limpet::app {

inline constexpr std::string_view kRunMagic = "limpet run ";
inline constexpr std::string_view kRunFormat = "1";

/// What is known before the first set.
struct RunHead {
  std::string arithmetic;  ///< of the program that made the run
  following::Strategy strategy = following::Strategy::frontier;
  std::uint64_t seed = 1;
  model::Parameters model;
  following::Parameters following;
  std::optional<following::LinkParameters> links;  ///< none: the robot has no links that are kept off
  kinematics::Robot robot;
  std::vector<model::InitialFace> initial;
};

/// One set, and what was decided after it.
struct RunSet {
  std::optional<following::Mode> mode;  ///< of the motion after it; none: the run ended there
  simulation::Sensed sensed;
  Eigen::Vector3d control_point = Eigen::Vector3d::Zero();  ///< where it truly was
};

/// How a run ended.
struct RunEnd {
  std::string reason;  ///< complete, max-sets, interrupted or stopped
  following::Marks marks;
};

/// The model of a run before its first set. Throws std::invalid_argument when the parameters or the initial
/// faces make no sense.
model::Model model_before(const RunHead&);

/// A number as text, exactly: C's hexadecimal form, as in -0x1.8p-3; inf and -inf.
std::string hexadecimal(double);

}  // namespace limpet::app
