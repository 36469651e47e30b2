// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/drawing/drawing.hpp>
#include <string>
#include <vector>

namespace limpet::app {

/// A recorded run as stages of growth, evenly spaced in sets, each with the path of the control point so far
/// (thesis Figures 44 to 47). The last is the finished model with all of the path. Warns on standard error
/// when the run was cut short. Errors: io::InputError.
std::vector<drawing::Figure> run_stages(const std::string& path, int count);

}  // namespace limpet::app
