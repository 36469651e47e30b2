// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <limpet/drawing/placing.hpp>
#include <limpet/drawing/robot_figure.hpp>
#include <limpet/drawing/sheet.hpp>

namespace limpet::drawing {

/// The box that holds the robot's body and bones, too.
void extend(Eigen::AlignedBox3d& box, const RobotFigure&);

/// The robot's body as patches of those facets that face the viewer, and all else of it as lines and dots.
void add_robot(const RobotFigure&, const Placing&, Panel&);

}  // namespace limpet::drawing
