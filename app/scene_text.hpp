// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/app/scene_file.hpp>
#include <string>

namespace limpet::app {

/// A scene as the text of a scene file in this folder (empty: the working one): parse_scene() gives the same
/// scene again, to the last bit. Files are named from the folder on. What the scene leaves open is left open.
std::string scene_text(const SceneFile&, const std::string& folder);

}  // namespace limpet::app
