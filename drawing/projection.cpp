// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limpet/drawing/open_edge_color.hpp>
#include <limpet/drawing/projection.hpp>
#include <limpet/drawing/robot_solids.hpp>
#include <limpet/drawing/way.hpp>
#include <limpet/io/text.hpp>
#include <limpet/io/triangulate.hpp>
#include <stdexcept>

namespace limpet::drawing {
namespace {

/// Axes of the picture: right, down, away from the viewer. Rows of the matrix.
Eigen::Matrix3d frame(const View& view) {
  Eigen::Matrix3d axes;
  const Eigen::Vector3d away = view.toward.normalized();
  const Eigen::Vector3d right = away.cross(view.up).normalized();
  axes << right.transpose(), away.cross(right).transpose(), away.transpose();
  return axes;
}

bool is_drawable(const io::LiftedPolygon& polygon) {
  if (polygon.cycles.empty() || polygon.cycles[0].size() < 3 || !polygon.normal.allFinite()) return false;
  for (const io::LiftedCycle& cycle : polygon.cycles) {
    for (const io::LiftedVertex& vertex : cycle) {
      if (!vertex.at.allFinite()) return false;
    }
  }
  return true;
}

/// Back sides are seen only where a surface is open: grey.
io::Color shade(const io::Color& color, const Eigen::Vector3d& normal) {
  const bool back = normal.z() > 0;
  const double lambert = std::max(0.0, (back ? -normal : normal).dot(light_from()));
  const double light = back ? 0.72 + 0.20 * lambert : 0.76 + 0.32 * lambert;
  io::Color shaded;
  for (int i = 0; i < 3; ++i) {
    const double base = back ? 0.25 * color[i] + 0.75 * kBackSide[i] : color[i];
    shaded[i] = static_cast<std::uint8_t>(std::min(255.0, base * light + 0.5));
  }
  return shaded;
}

/// So that a way can be seen before it.
io::Color paler(io::Color color) {
  for (std::uint8_t& channel : color)
    channel = static_cast<std::uint8_t>(channel + std::lround(0.6 * (255 - channel)));
  return color;
}

std::vector<io::Triangle> triangles_of(const io::LiftedPolygon& polygon) {
  std::vector<std::vector<Eigen::Vector2d>> charts;
  for (const io::LiftedCycle& cycle : polygon.cycles) {
    auto& chart = charts.emplace_back();
    for (const io::LiftedVertex& vertex : cycle) chart.push_back(vertex.chart);
  }
  return io::triangulate(charts);
}

/// Lines and dots that stay apart where a model is fine: widths follow the mean length of an edge in pixels.
void choose_widths(Panel& panel) {
  double length = 0;
  std::size_t edges = 0;
  for (const Patch& patch : panel.patches) {
    for (const Outline& outline : patch.outlines) {
      for (std::size_t i = 0; i < outline.points.size(); ++i, ++edges) {
        length += (outline.points[(i + 1) % outline.points.size()] - outline.points[i]).norm();
      }
    }
  }
  if (edges == 0) return;
  const double mean = length / static_cast<double>(edges);
  panel.shared_width = std::clamp(0.06 * mean, 0.8, 2.0);
  panel.open_width = std::clamp(0.09 * mean, 1.2, 3.0);
  panel.vertex_radius = mean < 8 ? 0 : std::clamp(0.06 * mean, 1.0, 3.2);
}

}  // namespace

Scene make_scene(const Figure& figure, bool loose_points) {
  const model::ModelRecord& model = figure.model;
  Scene scene;
  for (const model::OpenEdge& open : figure.open_edges) scene.refusals[open.edge.value] = open.refusal;
  for (io::LiftedPolygon& polygon : io::lift(model)) {
    if (!is_drawable(polygon)) continue;
    for (const io::LiftedVertex& vertex : polygon.cycles[0]) scene.box.extend(vertex.at);
    scene.polygons.push_back(std::move(polygon));
  }
  const bool nothing_else = scene.polygons.empty();
  for (const model::PointSegmentRecord& segment : model.point_segments) {
    if (segment.moments.count <= 0) continue;
    const Eigen::Vector3d at = io::centroid(segment.moments, model.grid_step);
    if (nothing_else) scene.box.extend(at);
    if (loose_points) scene.loose.push_back(at);
  }
  for (const Eigen::Vector3d& place : figure.way) {
    if (!place.allFinite()) continue;
    scene.way.push_back(place);
    scene.box.extend(place);
  }
  scene.whole_way = scene.way.size();
  if (figure.robot) {  // unless it is nowhere, as a damaged run may say
    Eigen::AlignedBox3d box = scene.box;
    extend(box, *figure.robot);
    if (box.isEmpty() || (box.min().allFinite() && box.max().allFinite())) {
      scene.robot = figure.robot;
      scene.box = box;
    }
  }
  return scene;
}

std::vector<View> choose_views(const std::vector<Scene>& scenes) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0;
  for (const Scene& scene : scenes) {
    for (const io::LiftedPolygon& polygon : scene.polygons) {
      const double size = std::abs(area(polygon));
      sum += size * polygon.normal;
      total += size;
    }
  }
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  if (total == 0 || sum.norm() < 0.3 * total) {  // a body: its normals cancel
    return {{{-0.50, 0.72, -0.48}, z, "oblique"},
            {{0.50, -0.72, 0.48}, z, "from the other side, below"},
            {-z, y, "from above"}};
  }
  // Seen from one side: look from there. Of the axes that may be up, the one least along the line of sight;
  // the surfaces that were seen lie below the eye.
  const Eigen::Vector3d side = sum.normalized();
  Eigen::Vector3d up = std::abs(side.z()) < 0.8 ? z : std::abs(side.y()) < std::abs(side.x()) + 0.5 ? y : x;
  if (up.dot(side) < -0.05) up = -up;
  const Eigen::Vector3d right = up.cross(side).normalized();
  return {{-side, up, "from the side that was seen"},
          {-(side + 0.7 * right + 0.3 * up), up, "from the right"},
          {-(side - 0.7 * right + 0.3 * up), up, "from the left"}};
}

Eigen::Vector2d projected_size(const Eigen::AlignedBox3d& box, const View& view) {
  if (box.isEmpty()) return {0, 0};
  // Half the extent of a turned box is the sum of its half sides' shares.
  return (frame(view).cwiseAbs() * box.sizes()).head<2>();
}

void project(const Scene& scene, const View& view, const Eigen::AlignedBox3d& box, double scale,
             Panel& panel) {
  const Placing place{frame(view),
                      box.isEmpty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(box.center()),
                      {panel.left + panel.width / 2, panel.top + panel.height / 2, 0},
                      scale};
  for (const io::LiftedPolygon& polygon : scene.polygons) {
    Patch& patch = panel.patches.emplace_back();
    patch.normal = place.axes * polygon.normal;
    patch.fill = shade(io::segment_color(polygon.id), patch.normal);
    if (!scene.way.empty()) patch.fill = paler(patch.fill);
    patch.triangles = triangles_of(polygon);
    for (const io::LiftedCycle& cycle : polygon.cycles) {
      Outline& outline = patch.outlines.emplace_back();
      for (const io::LiftedVertex& vertex : cycle) {
        outline.points.push_back(place(vertex.at));
        outline.edges.push_back(vertex.shared() ? kSharedEdge
                                                : open_edge_color(scene.refusal_of(vertex.edge)));
      }
    }
  }
  for (const Eigen::Vector3d& p : scene.loose) {
    const Eigen::Vector3d at = place(p);
    if (at.x() < panel.left || at.x() > panel.left + panel.width) continue;  // an outlier far away
    if (at.y() < panel.top || at.y() > panel.top + panel.height) continue;
    panel.loose.push_back(at);
  }
  choose_widths(panel);
  if (scene.robot) add_robot(*scene.robot, place, panel);
  std::vector<Eigen::Vector3d> way;
  for (const Eigen::Vector3d& p : scene.way) way.push_back(place(p));
  add_way(way, scene.whole_way, panel);
}

View view_from(const Eigen::Vector3d& from, const std::optional<Eigen::Vector3d>& up) {
  const auto is_along = [&](const Eigen::Vector3d& direction) {
    return !(direction.cross(from).norm() > 1e-6 * direction.norm() * from.norm());
  };
  if (!(from.norm() > 0)) throw std::invalid_argument("a view from no direction");
  if (up && is_along(*up)) throw std::invalid_argument("the direction that is to be up lies along the view");
  const Eigen::Vector3d usual =
      is_along(Eigen::Vector3d::UnitZ()) ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  return {
      -from, up.value_or(usual),
      "from " + io::short_text(from.x()) + ", " + io::short_text(from.y()) + ", " + io::short_text(from.z())};
}

}  // namespace limpet::drawing
