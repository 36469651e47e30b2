// Copyright the limpet authors. GPL-3.0-or-later.
#include "aims_internal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

#define KNOB(n,d) ([]{static const double v=getenv(#n)?atof(getenv(#n)):(d);return v;}())
namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

constexpr double kGrazing = 0.34;  ///< least cosine of incidence: 70°
constexpr double kNearPlane = 1;   ///< λ from a plane: what is felt there, or empty, tells of it
const double kMeets = KNOB(MEETS,0.5);     ///< λ between a reading and a target that it serves


}  // namespace

/// Where to look for places.
struct AimChooser::Search {
  std::size_t targets, candidates;  ///< the nearest so many
  double grazing;                   ///< least cosine of incidence
  std::span<const double> heights;  ///< δ over the expected surface
  std::span<const double> margins;  ///< δ − λ to be kept, from suspected places, too; 0: what is clear will do
};

namespace {

const double kFree[] = {KNOB(H1,0.8), KNOB(H2,1.1), KNOB(H3,1.5)}, kFreeMargins[] = {KNOB(MARG,1.35), 1};
/// Between walls that are less than 2 δ apart, places are low over one and look along it.
constexpr double kNarrow[] = {0.55, 0.7, 0.85, 1.1, 1.5}, kNarrowMargins[] = {1, 0};

}  // namespace

AimChooser::AimChooser(const Parameters& parameters, const kinematics::Posture& posture, double step)
    : lambda_(parameters.resolution),
      height_(parameters.follow_distance),
      step_(step),
      here_(posture.control_point()) {
  for (std::size_t i = 0; i < posture.robot().sensors.size(); ++i) {
    const auto sensor = posture.sensor(i);
    axes_.push_back({sensor.position - here_, sensor.axis, 0.95 * sensor.range});
  }
}

/// The plane through a place, with this normal.
AimChooser::Plane& AimChooser::plane_at(const Vector3d& place, const Vector3d& normal) {
  const double height = normal.dot(place);
  const auto same = [&](const Plane& plane) {
    return plane.normal.dot(normal) > 0.999 && std::abs(plane.normal.dot(place) - plane.height) < 0.2 * lambda_;
  };
  const auto plane = std::find_if(planes_.begin(), planes_.end(), same);
  if (plane != planes_.end()) return *plane;
  return planes_.emplace_back(Plane{normal, height, {}, NewGround(lambda_, place, normal)});
}

void AimChooser::sort_into_planes(const Outlook& outlook) {
  planes_.clear();
  for (std::size_t i = 0; i < outlook.targets.size(); ++i)
    plane_at(outlook.targets[i].at, outlook.targets[i].normal).targets.push_back(i);
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

void AimChooser::add_candidates(const Target& target, const Search& search) {
  for (const Axis& axis : axes_) {
    const double cosine = -axis.axis.dot(target.normal);
    if (cosine < search.grazing) continue;
    for (const double height : search.heights) {
      const double range = height * height_ / cosine;
      if (range <= axis.range)
        candidates_.push_back({target.at - range * axis.axis - axis.offset, target, 0});
    }
  }
}

void AimChooser::add_candidates(const std::vector<Target>& targets, const Search& search) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < targets.size(); ++i)
    order.emplace_back((targets[i].at - here_).norm() / targets[i].weight, i);
  std::sort(order.begin(), order.end());
  candidates_.clear();
  for (std::size_t i = 0; i < std::min(order.size(), search.targets); ++i)
    add_candidates(targets[order[i].second], search);
  const auto nearer = [&](const Aim& a, const Aim& b) {
    return (a.place - here_).squaredNorm() < (b.place - here_).squaredNorm();
  };
  std::stable_sort(candidates_.begin(), candidates_.end(), nearer);
  if (candidates_.size() > search.candidates) candidates_.resize(search.candidates);
}

/// What a reading in a plane is worth: the weight of the nearest target, less beside it, or that of new
/// ground.
double AimChooser::worth(const Plane& plane, const Vector3d& meets, const Outlook& outlook) {
  const double near2 = kMeets * kMeets * lambda_ * lambda_;
  double best = near2;
  std::size_t found = outlook.targets.size();
  for (const std::size_t i : plane.targets)
    if (const double d2 = (outlook.targets[i].at - meets).squaredNorm(); met_[i] != place_number_ && d2 < best)
      best = d2, found = i;
  if (found == outlook.targets.size()) return plane.ground.at(meets);
  met_[found] = place_number_;
  return outlook.targets[found].weight * (1 - best / near2);
}

/// What the readings of all axes are worth at a place.
double AimChooser::worth(const Vector3d& place, const Outlook& outlook, double grazing) {
  ++place_number_;
  double sum = 0;
  for (const Axis& axis : axes_) {
    double best = 0;
    for (const Plane& plane : planes_) {
      const double fall = -axis.axis.dot(plane.normal);
      if (fall < grazing) continue;
      const double range = (plane.normal.dot(place + axis.offset) - plane.height) / fall;
      if (range < 0 || range > axis.range) continue;
      best = std::max(best, worth(plane, place + axis.offset + range * axis.axis, outlook));
    }
    sum += best;
  }
  return sum;
}

std::vector<Vector3d> AimChooser::expected_along(std::size_t i, const Outlook& outlook, double range_limit) {
  if (planes_.empty()) sort_into_planes(outlook);
  std::vector<Vector3d> places;
  const Axis& axis = axes_[i];
  for (const Plane& plane : planes_) {
    const double fall = -axis.axis.dot(plane.normal);
    if (fall < kGrazing) continue;
    const double range = (plane.normal.dot(here_ + axis.offset) - plane.height) / fall;
    if (range < 0 || range > range_limit) continue;
    const Vector3d meets = here_ + axis.offset + range * axis.axis;
    if (plane.ground.at(meets) > 0) places.push_back(meets);
  }
  return places;
}

bool AimChooser::is_good(const model::View& view, const Clearance& clearance, const Aim& aim,
                         double margin) const {
  if (margin > 0 ? !clearance.is_safe(view, here_, aim.place, margin * clearance.least())
                 : !clearance.is_clear(view, here_, aim.place))
    return false;
  const Vector3d way = aim.target.at - aim.place;
  const auto hit = view.first_hit(aim.place, way, way.norm() - lambda_ / 2);
  return !hit;
}

std::optional<Aim> AimChooser::choose(const model::View& view, const Clearance& clearance,
                                      const Outlook& outlook) {
  sort_into_planes(outlook);
  met_.assign(outlook.targets.size(), 0);
  place_number_ = 0;
  const auto found = choose(view, clearance, outlook, {(size_t)KNOB(NT,10), (size_t)KNOB(NC,150), kGrazing, kFree, kFreeMargins});
  return found ? found : choose(view, clearance, outlook, {24, 240, kGrazing / 2, kNarrow, kNarrowMargins});
}

std::optional<Aim> AimChooser::choose(const model::View& view, const Clearance& clearance,
                                      const Outlook& outlook, const Search& search) {
  add_candidates(outlook.targets, search);
  for (Aim& aim : candidates_) {
    const double steps = std::max(1.0, std::ceil((aim.place - here_).norm() / step_ - 0.05));
    aim.value = worth(aim.place, outlook, search.grazing) / std::pow(steps,KNOB(SE,0.5));
  }
  std::stable_sort(candidates_.begin(), candidates_.end(),
                   [](const Aim& a, const Aim& b) { return a.value > b.value; });
  for (const double margin : search.margins)
    for (const Aim& aim : candidates_)
      if (is_good(view, clearance, aim, margin)) return aim;
  return std::nullopt;
}

}  // namespace limpet::following::internal
