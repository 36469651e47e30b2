// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/drawing/sheet.hpp>
#include <string>
#include <vector>

namespace limpet::drawing {

/// The strokes of a line of text in a plain font of straight lines (ASCII; other letters become '?').
std::vector<Mark> strokes(const Label& label);

/// Width of a line of text whose capitals are `size` high.
double text_width(const std::string& text, double size);

}  // namespace limpet::drawing
