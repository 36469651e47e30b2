// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limits>
#include <limpet/drawing/way.hpp>

namespace limpet::drawing {
namespace {

using Eigen::Vector3d;

constexpr double kLongestPiece = 4;  // pixels: where a face begins to hide a way is drawn to within this
constexpr double kBefore = 0.5;      // pixels before a place that a face must be to hide it

/// The colour after this part of the way: in steps, so that neighbouring pieces are drawn as one stroke.
io::Color color_at(double part) {
  constexpr double kSteps = 48;
  part = std::round(part * kSteps) / kSteps;
  io::Color color;
  for (std::size_t i = 0; i < color.size(); ++i)
    color[i] = static_cast<std::uint8_t>(std::lround((1 - part) * kWayBegins[i] + part * kWayEnds[i]));
  return color;
}

double cross(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Is the triangle before this place, as the viewer sees it?
bool covers(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& p) {
  const double twice = cross(a, b, c);
  if (twice == 0) return false;
  const double u = cross(p, b, c) / twice, v = cross(p, c, a) / twice, w = cross(p, a, b) / twice;
  return u >= 0 && v >= 0 && w >= 0 && u * a.z() + v * b.z() + w * c.z() < p.z() - kBefore;
}

}  // namespace

void add_line(const Vector3d& from, const Vector3d& to, double width, const io::Color& color, Panel& panel) {
  const Vector3d step = to - from;
  const double pieces = std::ceil(std::max(1.0, step.head<2>().norm() / kLongestPiece));
  for (double k = 0; k < pieces; ++k)
    panel.lines.push_back({from + k / pieces * step, from + (k + 1) / pieces * step, width, color});
}

void add_way(const std::vector<Vector3d>& places, std::size_t whole, Panel& panel) {
  const double last = std::max(1.0, static_cast<double>(std::max(whole, places.size())) - 1);
  const auto color = [&](std::size_t i) { return color_at(static_cast<double>(i) / last); };
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    add_line(places[i], places[i + 1], panel.way_width, color(i), panel);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == places.size();
    panel.lines.push_back({places[i], places[i], (is_end ? 4 : 1.8) * panel.way_width, color(i)});
  }
}

Hiding::Hiding(const Panel& panel) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  for (const Patch& patch : panel.patches) {
    Cover& cover =
        covers_.emplace_back(Cover{Vector3d::Constant(kFar), Vector3d::Constant(-kFar), &patch, {}});
    for (const Outline& outline : patch.outlines)
      cover.points.insert(cover.points.end(), outline.points.begin(), outline.points.end());
    for (const Vector3d& p : cover.points) {
      cover.low = cover.low.cwiseMin(p);
      cover.high = cover.high.cwiseMax(p);
    }
  }
}

bool Hiding::hides(const Vector3d& place) const {
  return std::any_of(covers_.begin(), covers_.end(), [&](const Cover& cover) {
    if (place.x() < cover.low.x() || place.x() > cover.high.x() || place.y() < cover.low.y() ||
        place.y() > cover.high.y() || place.z() < cover.low.z())
      return false;
    return std::any_of(cover.patch->triangles.begin(), cover.patch->triangles.end(), [&](const auto& t) {
      return covers(cover.points[static_cast<std::size_t>(t[0])],
                    cover.points[static_cast<std::size_t>(t[1])],
                    cover.points[static_cast<std::size_t>(t[2])], place);
    });
  });
}

}  // namespace limpet::drawing
