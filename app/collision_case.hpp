// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/app/collision_watch.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/app/scene_file.hpp>
#include <string>
#include <vector>

namespace limpet::app {

/// Where the case of a collision is written: beside the first model, "NAME-collision.toml" for NAME.off, or
/// "NAME-collision-2.toml" and so on where that is one of these files, which are read or written otherwise.
std::string case_path(const std::string& model, const std::vector<std::string>& taken);

/// A scene file for this path, from which `limpet follow` makes the same run up to the collision: the scene
/// with all that the command line said, and max_sets at the collision.
std::string case_text(SceneFile, const Collision&, const std::string& path);

}  // namespace limpet::app
