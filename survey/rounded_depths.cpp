// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <limpet/survey/rounded_depths.hpp>

namespace limpet::survey {
namespace {

/// Radians: so well do the normals of neighbourhoods agree that are flat to the last digit.
constexpr double kSameAxis = 1e-4;
/// Cosine between sensing axis and depths; no camera sees farther to the side, and the coordinate that is
/// nearest to an axis is never farther off.
constexpr double kLeastSlant = 0.5;
/// So many readings at one depth are no chance.
constexpr std::ptrdiff_t kSharing = 3;

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.cross(b).norm(); }

struct Steps {
  std::size_t distinct = 1;                                ///< depths
  std::size_t shared = 0;                                  ///< of these, those of kSharing readings or more
  double least = std::numeric_limits<double>::infinity();  ///< between two of them
};

Steps steps_along(const Eigen::Vector3d& axis, const std::vector<model::SensorPoint>& points, double within) {
  std::vector<double> depths;
  for (const auto& p : points) depths.push_back(axis.dot(p.position));
  std::sort(depths.begin(), depths.end());
  Steps found;
  for (auto first = depths.begin(); first != depths.end();) {
    auto last = first + 1;  // behind the readings of one depth
    while (last != depths.end() && *last - *(last - 1) <= within) ++last;
    found.shared += last - first >= kSharing;
    if (last != depths.end()) {
      ++found.distinct;
      found.least = std::min(found.least, *last - *(last - 1));
    }
    first = last;
  }
  return found;
}

}  // namespace

std::optional<RoundedDepths> rounded_depths(const std::vector<Eigen::Vector3d>& normals, std::size_t count,
                                            double within) {
  std::size_t most = 0;
  Eigen::Vector3d common = Eigen::Vector3d::Zero();
  for (const auto& candidate : normals) {
    std::size_t agreeing = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& other : normals) {
      if (angle_between(candidate, other) > kSameAxis) continue;
      ++agreeing;
      sum += candidate.dot(other) < 0 ? -other : other;
    }
    if (agreeing > most) most = agreeing, common = sum.normalized();
  }
  if (most == 0 || 50 * most < count) return std::nullopt;
  for (int k = 0; k < 3; ++k) {
    if (angle_between(common, Eigen::Vector3d::Unit(k)) < kSameAxis) return std::nullopt;
  }
  return RoundedDepths{common, within};
}

DepthNoise noise_of(const std::vector<model::SensorPoint>& points, const Eigen::Vector3d& axis,
                    double apparent, const RoundedDepths& rounded) {
  using Kind = DepthNoise::Kind;
  Eigen::Index depth = 0;  // the coordinate that looks along the axis, as in the sensor's own frame
  axis.cwiseAbs().maxCoeff(&depth);
  const Eigen::Vector3d along = rounded.axis.isZero() ? Eigen::Vector3d::Unit(depth) : rounded.axis;
  const double slant = std::abs(axis.dot(along));
  if (slant < kLeastSlant)  // rows of readings across the view are no steps of depth
    return {Kind::scatter, apparent};
  const Steps steps = steps_along(along, points, rounded.within);
  if (3 * steps.distinct > points.size()) return {Kind::scatter, apparent};
  if (steps.distinct == 1) return {Kind::single_depth, apparent};
  // A face of one depth, and some readings of the next one, are no rounding.
  if (steps.shared < 2) return {Kind::scatter, apparent};
  return {Kind::few_depths, std::max(apparent, steps.least / slant / std::sqrt(12.0))};
}

}  // namespace limpet::survey
