// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/kinematics/posture.hpp>
#include <limpet/kinematics/robot.hpp>
#include <optional>
#include <string>
#include <vector>

namespace limpet::app {

/// A robot from a file, and where it begins.
struct RobotFile {
  kinematics::Robot robot;
  double sensing_range = 0;  ///< of the sensors that do not say their own
  std::optional<kinematics::Configuration> start;
  std::string chosen_tip;  ///< the link taken for the tip where nobody named one; else empty
};

/// The robot of a file: a URDF (.urdf), as it is, or a robot file (.toml) that says what a URDF does not:
/// docs/robots.md describes it. `package_paths`: where the URDF of a robot file, and meshes, are sought when
/// they are not where their names say. What is not said is chosen, as for a URDF alone: the control point is
/// the tip's origin, the sensors are kinematics::usual_sensors() with a fifteenth of the robot's largest
/// reach as their range, as the thesis's arm has it, and γ is kinematics::ceilings_for() that range. Throws
/// io::InputError for a robot file, also where it does not fit its URDF, with its line,
/// kinematics::RobotError for a URDF, both in one line, and
/// UsageError when the name has neither ending.
RobotFile read_robot(const std::string& path, const std::vector<std::string>& package_paths);

/// The same for the text of a robot file. `path`: for messages, and for the files it names.
RobotFile parse_robot(const std::string& text, const std::string& path,
                      const std::vector<std::string>& package_paths);

}  // namespace limpet::app
