// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/drawing/sheet.hpp>
#include <string>

namespace limpet::drawing {

/// The sheet as an SVG file's bytes: faces painted over each other from far to near. Dots of loose points
/// lie on top, whether or not a face hides them.
std::string svg_bytes(const Sheet& sheet);

}  // namespace limpet::drawing
