// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/app/toml_section_internal.hpp>
#include <limpet/kinematics/robot.hpp>
#include <string>
#include <vector>

namespace limpet::app::internal {

/// The link that a key names; the control point's when the key is not there. Throws io::InputError when there
/// is none of that name.
std::size_t link_of(const kinematics::Robot&, const TomlSection&, const std::string& key);

/// The sensors of all [[sensors]] of a robot file, in their order (docs/robots.md). `range`: of those that do
/// not say theirs. Throws io::InputError.
std::vector<kinematics::RangeSensor> read_sensors(const kinematics::Robot&, const TomlSection& file,
                                                  double range);

}  // namespace limpet::app::internal
