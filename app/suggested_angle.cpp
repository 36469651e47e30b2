// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/suggested_angle.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <vector>

namespace limpet::app {
namespace {

constexpr double kLeastDeg = 1.2;  ///< above what model/ finds a common line for
constexpr double kBelow = 0.85;    ///< of the least bend: the planes move a little when others are told apart

/// Of each open edge that μ keeps open: the angle to the plane it was not shared with, in degrees.
std::vector<double> bends_of(std::span<const io::LiftedPolygon> polygons,
                             std::span<const model::OpenEdge> open_edges) {
  std::unordered_map<std::uint64_t, Eigen::Vector3d> normals;
  for (const io::LiftedPolygon& polygon : polygons) normals[polygon.id] = polygon.normal;
  std::vector<double> bends;
  for (const model::OpenEdge& open : open_edges) {
    if (open.refusal != model::Refusal::angle) continue;
    const Eigen::Vector3d &a = normals.at(open.segment.value), &b = normals.at(open.other.value);
    bends.push_back(std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi);
  }
  return bends;
}

/// Two digits, never up.
double rounded_down(double number) {
  return number >= 10 ? std::floor(number) : std::floor(10 * number) / 10;
}

}  // namespace

std::optional<SuggestedAngle> suggested_angle(std::span<const io::LiftedPolygon> polygons,
                                              std::span<const model::OpenEdge> open_edges) {
  std::vector<double> bends = bends_of(polygons, open_edges);
  std::erase_if(bends, [](double bend) { return kBelow * bend < kLeastDeg; });
  if (bends.empty() || 2 * bends.size() < open_edges.size()) return std::nullopt;
  const auto tenth = bends.begin() + static_cast<std::ptrdiff_t>(bends.size() / 10);
  std::nth_element(bends.begin(), tenth, bends.end());
  return SuggestedAngle{*tenth, rounded_down(kBelow * *tenth)};
}

}  // namespace limpet::app
