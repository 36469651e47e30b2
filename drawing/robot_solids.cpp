// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limpet/drawing/facets.hpp>
#include <limpet/drawing/robot_solids.hpp>
#include <limpet/drawing/way.hpp>
#include <optional>

namespace limpet::drawing {
namespace {

using Eigen::Vector3d;

/// Darker towards the rim, so that links stand out before each other.
io::Color shade_of_robot(const Vector3d& normal) {
  const double light = 0.4 - 0.35 * normal.z() + 0.5 * std::max(0.0, normal.dot(light_from()));
  io::Color shaded;
  for (std::size_t i = 0; i < shaded.size(); ++i)
    shaded[i] = static_cast<std::uint8_t>(std::min(255.0, kRobot[i] * light + 0.5));
  return shaded;
}

/// The facets that the viewer may see.
void add_solid(const model::Capsule& part, const Placing& place, Panel& panel) {
  for (const Facet& facet : facets_of(part)) {
    const Vector3d normal = place.axes * facet.normal;
    if (!(normal.z() < 0)) continue;
    Patch& patch = panel.patches.emplace_back();
    patch.normal = normal;
    patch.fill = shade_of_robot(normal);
    patch.round = true;
    Outline& outline = patch.outlines.emplace_back();
    for (const Vector3d& corner : facet.corners) outline.points.push_back(place(corner));
    for (int k = 2; k < static_cast<int>(facet.corners.size()); ++k) patch.triangles.push_back({0, k - 1, k});
  }
}

/// What of a line is in the panel, but for what is much farther out than its width; none: nothing. Rays may
/// be longer than any picture.
std::optional<RobotFigure::Line> within(const Panel& panel, const Vector3d& from, const Vector3d& to,
                                        double width) {
  const Eigen::Vector2d low(panel.left - width, panel.top - width);
  const Eigen::Vector2d high(panel.left + panel.width + width, panel.top + panel.height + width);
  const Vector3d step = to - from;
  if (!from.allFinite() || !step.allFinite()) return std::nullopt;
  double begin = 0, end = 1;
  for (int i = 0; i < 2; ++i) {
    if (step[i] == 0 && (from[i] < low[i] || from[i] > high[i])) return std::nullopt;
    if (step[i] == 0) continue;
    const double a = (low[i] - from[i]) / step[i], b = (high[i] - from[i]) / step[i];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  if (begin > end) return std::nullopt;
  return RobotFigure::Line{from + begin * step, from + end * step};
}

}  // namespace

void extend(Eigen::AlignedBox3d& box, const RobotFigure& robot) {
  for (const model::Capsule& part : robot.body)
    for (const Vector3d& end : {part.a, part.b}) {
      box.extend(Vector3d(end.array() - part.radius));
      box.extend(Vector3d(end.array() + part.radius));
    }
  for (const RobotFigure::Line& bone : robot.bones) box.extend(bone.from).extend(bone.to);
}

void add_robot(const RobotFigure& robot, const Placing& place, Panel& panel) {
  const double width = panel.way_width;
  const auto add_lines = [&](const std::vector<RobotFigure::Line>& lines, double wide,
                             const io::Color& color) {
    for (const auto& [from, to] : lines)
      if (const auto part = within(panel, place(from), place(to), wide))
        add_line(part->from, part->to, wide, color, panel);
  };
  const auto add_dot = [&](const Vector3d& at, double wide, const io::Color& color) {
    if (within(panel, at, at, wide)) add_line(at, at, wide, color, panel);
  };
  const auto add_dot_on_link = [&](const Vector3d& at, double wide, const io::Color& color) {
    add_dot(place(at) - wide * Vector3d::UnitZ(), wide, color);  // what is round hides none of it
  };
  for (const model::Capsule& part : robot.body) add_solid(part, place, panel);
  add_lines(robot.bones, 2.5 * width, kRobot);
  add_lines(robot.misses, 0.6 * width, kMiss);
  add_lines(robot.rays, 0.9 * width, kRay);
  for (const auto& [sensor, met] : robot.rays)  // this side of the face, which hides it from the other
    add_dot(place(met) + 3 * (place(sensor) - place(met)).stableNormalized(), 3 * width, kRay);
  for (const Vector3d& at : robot.quiet) add_dot_on_link(at, 1.8 * width, kMiss);
  add_lines(robot.fields, 2.2 * width, kSeeing);
  for (const RobotFigure::Line& field : robot.fields) add_dot_on_link(field.from, 4.5 * width, kSeeing);
}

}  // namespace limpet::drawing
