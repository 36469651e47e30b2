// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/kinematics/enclosing_capsule.hpp>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

namespace limpet::kinematics {
namespace {

using Eigen::Vector3d;
using model::Capsule;
using Points = std::vector<Vector3d>;

constexpr double kMargin = 1e-9;   // of the size: what a capsule is thicker for, so that it holds its points
constexpr int kCircleSteps = 100;  // towards the smallest circle
constexpr int kRadii = 24;         // tried for each direction
constexpr double kMuchSmaller = 0.75;  // of the volume: then one part more is worth it
constexpr std::size_t kEnough = 200;   // points to choose a direction by

double cubed(double x) { return x * x * x; }

/// Two unit vectors orthogonal to a unit vector and to each other.
std::pair<Vector3d, Vector3d> across(const Vector3d& axis) {
  Eigen::Index least = 0;
  axis.cwiseAbs().minCoeff(&least);
  const Vector3d u = axis.cross(Vector3d::Unit(least)).normalized();
  return {u, axis.cross(u)};
}

/// Centre of nearly the smallest circle around points of a plane (Bădoiu and Clarkson 2003): each step goes a
/// smaller part of the way to the farthest point.
Eigen::Vector2d circle_centre(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Vector2d low = points[0], high = points[0];
  for (const auto& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  Eigen::Vector2d centre = (low + high) / 2, best = centre;
  double smallest = std::numeric_limits<double>::infinity();
  for (int step = 1; step <= kCircleSteps; ++step) {
    const auto farthest = std::max_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
      return (a - centre).squaredNorm() < (b - centre).squaredNorm();
    });
    const double radius2 = (*farthest - centre).squaredNorm();
    if (radius2 < smallest) smallest = radius2, best = centre;
    centre += (*farthest - centre) / (step + 1.0);
  }
  return best;
}

/// Points seen along a line: how far along it and, squared, how far from it.
struct Seen {
  double along = 0, from2 = 0;
};

/// The shortest capsule of this radius on the line; ends are distances along it.
struct Span {
  double a = 0, b = 0, radius = 0;
  double volume() const { return std::numbers::pi * (radius * radius * (b - a) + 4.0 / 3 * cubed(radius)); }
};

Span span_of(const std::vector<Seen>& points, double radius) {
  double a = std::numeric_limits<double>::infinity(), b = -a;
  for (const Seen& point : points) {
    const double cap = std::sqrt(std::max(0.0, radius * radius - point.from2));
    a = std::min(a, point.along + cap);
    b = std::max(b, point.along - cap);
  }
  if (a > b) a = b = (a + b) / 2;  // a ball: both ends may be anywhere between
  return {a, b, radius};
}

Capsule capsule_along(const Points& points, const Vector3d& axis) {
  const auto [u, v] = across(axis);
  std::vector<Eigen::Vector2d> flat;
  for (const Vector3d& p : points) flat.emplace_back(u.dot(p), v.dot(p));
  const Eigen::Vector2d centre = circle_centre(flat);
  std::vector<Seen> seen;
  double thin2 = 0, low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < points.size(); ++i) {
    seen.push_back({axis.dot(points[i]), (flat[i] - centre).squaredNorm()});
    thin2 = std::max(thin2, seen.back().from2);
    low = std::min(low, seen.back().along), high = std::max(high, seen.back().along);
  }
  // From a thin one as long as the points are to a ball: a little thicker is often much shorter.
  const double thin = std::sqrt(thin2), thick = std::hypot(thin, (high - low) / 2);
  Span best = span_of(seen, thin);
  for (int i = 1; i <= kRadii; ++i) {
    const double share = static_cast<double>(i) / kRadii;
    const Span other = span_of(seen, thin + share * share * (thick - thin));
    if (other.volume() < best.volume()) best = other;
  }
  const Vector3d foot = centre.x() * u + centre.y() * v;
  const double size = best.radius + (high - low) + foot.norm() + std::max(std::abs(low), std::abs(high));
  return {foot + best.a * axis, foot + best.b * axis, best.radius + kMargin * size};
}

/// Directions to begin with: those of the coordinates, and those in which the points spread most and least.
Points first_directions(const Points& points) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& p : points) spread += (p - mean) * (p - mean).transpose();
  const Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
  Points directions;
  for (int i = 0; i < 3; ++i) directions.push_back(Vector3d::Unit(i));
  for (int i = 0; i < 3; ++i) directions.push_back(axes.col(i).normalized());
  return directions;
}

std::pair<double, Vector3d> best_of(const Points& points, const Points& directions) {
  std::pair<double, Vector3d> best{std::numeric_limits<double>::infinity(), directions.front()};
  for (const Vector3d& direction : directions) {
    const double size = volume(capsule_along(points, direction));
    if (size < best.first) best = {size, direction};
  }
  return best;
}

/// The direction of the smallest capsule: the best of the first ones, tilted as long as that helps.
Vector3d best_direction(const Points& points) {
  auto best = best_of(points, first_directions(points));
  for (double tilt = 0.4; tilt > 0.02;) {
    const auto [u, v] = across(best.second);
    Points tilted;
    for (const Vector3d& to : {u, v, Vector3d(-u), Vector3d(-v)})
      tilted.push_back((best.second + tilt * to).normalized());
    const auto better = best_of(points, tilted);
    if (better.first < best.first)
      best = better;
    else
      tilt /= 2;
  }
  return best.second;
}

Points without_repeats(Points points) {
  const auto key = [](const Vector3d& p) { return std::make_tuple(p.x(), p.y(), p.z()); };
  std::sort(points.begin(), points.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// Some of the points, in their order, that are much like all of them.
Points sample(const Points& points) {
  if (points.size() <= kEnough) return points;
  Points some;
  for (std::size_t i = 0; i < kEnough; ++i) some.push_back(points[i * points.size() / kEnough]);
  return some;
}

/// What is left of a polygon on one side of a plane: where sign · (axis · p − height) is 0 or more.
Points cut(const Points& polygon, const Vector3d& axis, double height, double sign) {
  Points left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double over_p = sign * (axis.dot(p) - height), over_q = sign * (axis.dot(q) - height);
    if (over_p >= 0) left.push_back(p);
    if ((over_p > 0 && over_q < 0) || (over_p < 0 && over_q > 0))
      left.push_back(p + over_p / (over_p - over_q) * (q - p));
  }
  return left;
}

/// Corners of the surface between two planes. The solid between them is in their hull: what bounds it there
/// is that surface, and pieces of the planes whose borders are on it.
Points slice(const Points& triangles, const Vector3d& axis, double low, double high) {
  Points corners;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const Points above = cut({triangles[i], triangles[i + 1], triangles[i + 2]}, axis, low, 1);
    const Points between = cut(above, axis, high, -1);
    corners.insert(corners.end(), between.begin(), between.end());
  }
  return corners;
}

std::vector<Capsule> in_slices(const Points& triangles, const Vector3d& axis, std::size_t count) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vector3d& p : triangles) low = std::min(low, axis.dot(p)), high = std::max(high, axis.dot(p));
  std::vector<Capsule> parts;
  for (std::size_t i = 0; i < count; ++i) {
    const auto height = [&](std::size_t k) {
      return low + (high - low) * static_cast<double>(k) / static_cast<double>(count);
    };
    const Points corners = slice(triangles, axis, height(i), i + 1 == count ? high : height(i + 1));
    if (!corners.empty()) parts.push_back(enclosing_capsule(corners));
  }
  return parts;
}

double sum_of_volumes(const std::vector<Capsule>& parts) {
  double sum = 0;
  for (const Capsule& part : parts) sum += volume(part);
  return sum;
}

double distance_to_axis(const Vector3d& p, const Capsule& capsule) {
  const Vector3d along = capsule.b - capsule.a;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0 ? std::clamp((p - capsule.a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - capsule.a - share * along).norm();
}

}  // namespace

Capsule enclosing_capsule(const Points& points) {
  const Points different = without_repeats(points);
  return capsule_along(different, best_direction(sample(different)));
}

Capsule enclosing_capsule(const Points& points, const Points& directions) {
  return capsule_along(points, best_of(points, directions).second);
}

std::vector<Capsule> enclosing_capsules(const Points& triangles, std::size_t most) {
  std::vector<Capsule> best = {enclosing_capsule(triangles)};
  const Vector3d along = best[0].b - best[0].a;
  if (along.norm() == 0) return best;
  for (std::size_t count = 2; count <= most; ++count) {
    const std::vector<Capsule> parts = in_slices(triangles, along.normalized(), count);
    if (sum_of_volumes(parts) < kMuchSmaller * sum_of_volumes(best)) best = parts;
  }
  return best;
}

double volume(const Capsule& capsule) {
  return Span{0, (capsule.b - capsule.a).norm(), capsule.radius}.volume();
}

bool covers(const Capsule& outer, const Capsule& inner) {
  const double room = outer.radius * (1 + kMargin) - inner.radius;
  return distance_to_axis(inner.a, outer) <= room && distance_to_axis(inner.b, outer) <= room;
}

std::vector<Capsule> without_covered(const std::vector<Capsule>& capsules) {
  std::vector<Capsule> left;
  for (std::size_t i = 0; i < capsules.size(); ++i) {
    const auto covered_by = [&](std::size_t k) {
      // Of two that cover each other the first is kept.
      return k != i && covers(capsules[k], capsules[i]) && (k < i || !covers(capsules[i], capsules[k]));
    };
    bool covered = false;
    for (std::size_t k = 0; k < capsules.size() && !covered; ++k) covered = covered_by(k);
    if (!covered) left.push_back(capsules[i]);
  }
  return left;
}

}  // namespace limpet::kinematics
