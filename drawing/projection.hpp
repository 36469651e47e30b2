// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <limpet/drawing/drawing.hpp>
#include <limpet/drawing/sheet.hpp>
#include <limpet/io/lifted.hpp>
#include <unordered_map>
#include <vector>

namespace limpet::drawing {

/// What of a model is drawn, in the world.
struct Scene {
  std::vector<io::LiftedPolygon> polygons;  ///< finite, each with a perimeter of three vertices at least
  std::vector<Eigen::Vector3d> loose;       ///< centres of the point segments
  std::vector<Eigen::Vector3d> way;
  std::size_t whole_way = 0;  ///< places of the way that `way` is the beginning of
  std::optional<RobotFigure> robot;
  /// Of the polygons, the way and the robot's body; of the loose points where there are no polygons.
  Eigen::AlignedBox3d box;
  std::unordered_map<std::uint64_t, model::Refusal> refusals;  ///< of open edges, by identity

  model::Refusal refusal_of(std::uint64_t edge) const {
    const auto known = refusals.find(edge);
    return known == refusals.end() ? model::Refusal::alone : known->second;
  }
};

Scene make_scene(const Figure& figure, bool loose_points);

/// The views that show these scenes well (see default_views).
std::vector<View> choose_views(const std::vector<Scene>& scenes);

/// Extent of a box across a view: width and height, in the box's unit.
Eigen::Vector2d projected_size(const Eigen::AlignedBox3d& box, const View& view);

/// Fills a panel: `box` in its middle, `scale` pixels to a unit.
void project(const Scene& scene, const View& view, const Eigen::AlignedBox3d& box, double scale,
             Panel& panel);

}  // namespace limpet::drawing
