// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/drawing/drawing.hpp>
#include <optional>
#include <string>
#include <vector>

namespace limpet::app {

struct RunStages {
  int count = 4;                   ///< evenly spaced in sets; the last is the finished model
  std::optional<std::int64_t> at;  ///< instead, one stage: the model after so many sets, from 1 on
  bool with_robot = true;          ///< where it stood at the stage's last set, if it has links to be seen
};

/// A recorded run as stages of growth, each with the path of the control point so far (thesis Figures 44 to
/// 47) and the robot. Warns on standard error when the run was cut short. Errors: io::InputError; UsageError
/// where the run has fewer sets than are asked for.
std::vector<drawing::Figure> run_stages(const std::string& path, const RunStages&);

}  // namespace limpet::app
