// Copyright the limpet authors. GPL-3.0-or-later.
#include "expected_planes_internal.hpp"

#include <algorithm>
#include <cmath>

namespace limpet::following::internal {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kMeets = 0.5;    ///< λ between a reading and a target that it serves
constexpr double kNearPlane = 1;  ///< λ from a plane: what is felt there, or empty, tells of it

}  // namespace

ExpectedPlanes::ExpectedPlanes(double resolution, const Outlook& outlook)
    : lambda_(resolution), targets_(outlook.targets), met_(targets_.size(), 0) {
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const Vector3d& at = targets_[i].at;
    Plane& plane = plane_at(at, targets_[i].normal);
    const double lift = plane.normal.dot(at) - plane.height;
    plane.targets.push_back({i, plane.ground.flat(at), lift * lift});
  }
  for (const Border& border : outlook.borders)
    plane_at((border.from + border.to) / 2, border.normal).ground.add(border);
  for (Plane& plane : planes_) {
    const auto is_near = [&](const Vector3d& p) {
      return std::abs(plane.normal.dot(p) - plane.height) < kNearPlane * lambda_;
    };
    for (const Vector3d& point : outlook.points)
      if (is_near(point)) plane.ground.add_felt(point);
    for (const Vector3d& place : outlook.empty)
      if (is_near(place)) plane.ground.add_empty(place);
  }
}

/// The plane through a place, with this normal.
ExpectedPlanes::Plane& ExpectedPlanes::plane_at(const Vector3d& place, const Vector3d& normal) {
  constexpr double kSameWay = 0.999, kSameHeight = 0.2;
  const auto same = [&](const Plane& plane) {
    return plane.normal.dot(normal) > kSameWay &&
           std::abs(plane.normal.dot(place) - plane.height) < kSameHeight * lambda_;
  };
  const auto plane = std::find_if(planes_.begin(), planes_.end(), same);
  if (plane != planes_.end()) return *plane;
  return planes_.emplace_back(Plane{normal, normal.dot(place), {}, NewGround(lambda_, place, normal)});
}

/// The weight of the nearest target, less beside it, or that of new ground.
ExpectedPlanes::Worth ExpectedPlanes::worth(const Plane& plane, const Vector2d& meets) const {
  const double near2 = kMeets * kMeets * lambda_ * lambda_;
  double best = near2;
  std::optional<std::size_t> found;
  for (const PlaneTarget& target : plane.targets) {
    const double d2 = (target.flat - meets).squaredNorm() + target.lift2;
    if (met_[target.target] != place_number_ && d2 < best) best = d2, found = target.target;
  }
  if (!found) return {plane.ground.at_flat(meets), found};
  return {targets_[*found].weight * (1 - best / near2), found};
}

void ExpectedPlanes::look_along(const std::vector<Ray>& rays, double least_cosine) {
  ways_.clear();
  for (std::size_t i = 0; i < rays.size(); ++i)
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      const Plane& plane = planes_[k];
      const double fall = -rays[i].axis.dot(plane.normal);
      if (fall < least_cosine) continue;
      ways_.push_back({i, k, plane.normal.dot(rays[i].from), rays[i].range * fall,
                       plane.ground.flat_way(rays[i].from), plane.ground.flat_way(rays[i].axis) / fall});
    }
}

double ExpectedPlanes::worth(const Vector3d& place) {
  ++place_number_;
  over_.clear();
  for (const Plane& plane : planes_)
    over_.push_back({plane.normal.dot(place) - plane.height, plane.ground.flat(place)});
  double sum = 0;
  for (auto way = ways_.begin(); way != ways_.end();) {
    Worth best;
    for (const std::size_t ray = way->ray; way != ways_.end() && way->ray == ray; ++way) {
      const double height = over_[way->plane].height + way->from;
      if (height < 0 || height > way->reach || best.value >= 1) continue;
      const Vector2d meets = over_[way->plane].flat + way->off + height * way->slope;
      if (const Worth here = worth(planes_[way->plane], meets); here.value > best.value) best = here;
    }
    if (best.target) met_[*best.target] = place_number_;
    sum += best.value;
  }
  return sum;
}

bool ExpectedPlanes::is_low_over_new_ground(const Vector3d& place, double distance) const {
  return std::any_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
    const double height = plane.normal.dot(place) - plane.height;
    return std::abs(height) < distance && plane.ground.at(place - height * plane.normal) > 0;
  });
}

void ExpectedPlanes::add_new_ground(const Ray& ray, double least_cosine,
                                    std::vector<Vector3d>& places) const {
  for (const Plane& plane : planes_)
    if (const auto meets = crossing(ray, plane.normal, plane.height, least_cosine))
      if (plane.ground.at(*meets) > 0) places.push_back(*meets);
}

}  // namespace limpet::following::internal
