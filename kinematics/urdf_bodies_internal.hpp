// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <urdf_model/link.h>

#include <limpet/kinematics/urdf.hpp>
#include <string>
#include <vector>

namespace limpet::kinematics::internal {

/// Capsules that hold the collision shapes of a link, in its frame. `path`: the URDF's. Throws RobotError.
std::vector<model::Capsule> body_of(const urdf::Link&, const std::string& path, const UrdfOptions&);

}  // namespace limpet::kinematics::internal
