// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/links/obstacles.hpp>
#include <limpet/following/nearest_on_internal.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using kinematics::BodyPart;
using kinematics::Posture;
using kinematics::Proximity;
using model::Capsule;

/// The pair of nearest points of a capsule and a ball; none where the ball's centre is on the axis.
std::optional<Proximity> proximity_to(std::size_t link, const Capsule& capsule, const Vector3d& centre,
                                      double radius) {
  const Vector3d on_axis = internal::nearest_on(capsule.a, capsule.b, centre);
  const double distance = (on_axis - centre).norm();
  if (!(distance > 0)) return std::nullopt;
  const Vector3d away = (on_axis - centre) / distance;
  return Proximity{link, on_axis - capsule.radius * away, centre + radius * away, away,
                   distance - capsule.radius - radius};
}

Proximity proximity_to(std::size_t link, const Capsule& capsule, const model::View::LinkNearest& near) {
  return {link, near.on_surface(capsule.radius), near.at, near.away, near.distance};
}

double distance_from_axis(const Capsule& capsule, const Vector3d& place) {
  return (internal::nearest_on(capsule.a, capsule.b, place) - place).norm();
}

/// Which of the 26 directions around a part an obstacle lies in: three signs.
int sector_of(const Vector3d& away) {
  const auto sign = [](double x) { return x < -0.38 ? 0 : x > 0.38 ? 2 : 1; };
  return sign(away.x()) + 3 * sign(away.y()) + 9 * sign(away.z());
}

}  // namespace

double Obstacles::distance(const Capsule& capsule, double reach, double reading_radius) const {
  double least = reach;
  for (const Vector3d& p : readings_)
    least = std::min(least, distance_from_axis(capsule, p) - capsule.radius - reading_radius);
  const auto found = view_.nearest(capsule, std::max(least, 0.0));
  return found ? std::min(found->distance, least) : least;
}

double Obstacles::distance(const Capsule& capsule, double reach) const {
  return distance(capsule, reach, radius_);
}

double Obstacles::clearance(const Posture& posture, std::span<const BodyPart> body, double reach) const {
  double least = reach;
  for (const BodyPart& part : body) least = distance(kinematics::in_world(part, posture), least, 0);
  return least < reach ? least : std::numeric_limits<double>::infinity();
}

void Obstacles::nearest_of_links(const Posture& posture, std::span<const BodyPart> body, double reach,
                                 std::vector<Proximity>& result) const {
  result.clear();
  const auto take = [&](const Proximity& found) {
    if (found.distance > reach) return;
    if (!result.empty() && result.back().link == found.link) {
      if (found.distance < result.back().distance) result.back() = found;
    } else {
      result.push_back(found);
    }
  };
  for (const BodyPart& part : body) {
    const Capsule capsule = kinematics::in_world(part, posture);
    if (const auto near = view_.nearest(capsule, reach)) take(proximity_to(part.link, capsule, *near));
  }
}

void Obstacles::near(const Posture& posture, std::span<const BodyPart> body, double reach,
                     std::vector<Proximity>& result) const {
  constexpr std::size_t kSectors = 27;
  result.clear();
  std::vector<model::View::LinkNearest> segments;
  for (const BodyPart& part : body) {
    const Capsule capsule = kinematics::in_world(part, posture);
    view_.nearest(capsule, reach, segments);
    for (const auto& near : segments) result.push_back(proximity_to(part.link, capsule, near));
    std::vector<std::optional<Proximity>> nearest(kSectors);
    for (const Vector3d& p : readings_) {
      const auto found = proximity_to(part.link, capsule, p, radius_);
      if (!found || found->distance > reach) continue;
      auto& best = nearest[static_cast<std::size_t>(sector_of(found->away))];
      if (!best || found->distance < best->distance) best = found;
    }
    for (const auto& found : nearest)
      if (found) result.push_back(*found);
  }
}

}  // namespace limpet::following
