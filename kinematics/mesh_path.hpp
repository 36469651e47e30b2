// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace limpet::kinematics {

/// The file that is meant by a name in a robot's file. A name is a path, `file://` and a path, or
/// `package://` (or another scheme) and a path that begins with the name of a package. It is sought in this
/// order: where it says, when the path is absolute; in the folder `beside`; in each of the folders given,
/// whole, then without its first part, without the first two, and so on down to its base name; and for
/// packages in the folders that hold `beside`, where a checkout has them. None: it is nowhere.
std::optional<std::string> find_robot_file(const std::string& name, const std::string& beside,
                                           const std::vector<std::string>& folders);

}  // namespace limpet::kinematics
