// Copyright the limpet authors. GPL-3.0-or-later.
#include "aims_internal.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

constexpr double kGrazing = 0.34;  ///< least cosine of incidence: 70°
constexpr double kMeets = 0.5;     ///< λ between a reading and a target that it serves


}  // namespace

/// Where to look for places.
struct AimChooser::Search {
  std::size_t targets, candidates;  ///< the nearest so many
  double grazing;                   ///< least cosine of incidence
  std::span<const double> heights;  ///< δ over the expected surface
  std::span<const double> margins;  ///< δ − λ to be kept, from suspected places, too; 0: what is clear will do
};

namespace {

constexpr double kFree[] = {0.8, 1.1, 1.5}, kFreeMargins[] = {1.35, 1};
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

void AimChooser::sort_into_planes(const std::vector<Target>& targets) {
  planes_.clear();
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Target& target = targets[i];
    const double height = target.normal.dot(target.at);
    const auto same = [&](const Plane& plane) {
      return plane.normal.dot(target.normal) > 0.999 &&
             std::abs(plane.normal.dot(target.at) - plane.height) < 0.2 * lambda_;
    };
    auto plane = std::find_if(planes_.begin(), planes_.end(), same);
    if (plane == planes_.end()) plane = planes_.insert(planes_.end(), {target.normal, height, {}});
    plane->targets.push_back(i);
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

/// The weights of the targets met from a place, less where an axis passes beside them.
double AimChooser::worth(const Vector3d& place, const std::vector<Target>& targets, double grazing) {
  ++place_number_;
  double sum = 0;
  for (const Axis& axis : axes_)
    for (const Plane& plane : planes_) {
      const double fall = -axis.axis.dot(plane.normal);
      if (fall < grazing) continue;
      const double range = (plane.normal.dot(place + axis.offset) - plane.height) / fall;
      if (range < 0 || range > axis.range) continue;
      const Vector3d meets = place + axis.offset + range * axis.axis;
      double best = kMeets * kMeets * lambda_ * lambda_;
      std::size_t found = targets.size();
      for (const std::size_t i : plane.targets)
        if (const double d2 = (targets[i].at - meets).squaredNorm(); met_[i] != place_number_ && d2 < best)
          best = d2, found = i;
      if (found == targets.size()) continue;
      met_[found] = place_number_;
      sum += targets[found].weight * (1 - best / (kMeets * kMeets * lambda_ * lambda_));
    }
  return sum;
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
                                      const std::vector<Target>& targets) {
  sort_into_planes(targets);
  met_.assign(targets.size(), 0);
  place_number_ = 0;
  const auto found = choose(view, clearance, targets, {10, 48, kGrazing, kFree, kFreeMargins});
  return found ? found : choose(view, clearance, targets, {24, 240, kGrazing / 2, kNarrow, kNarrowMargins});
}

std::optional<Aim> AimChooser::choose(const model::View& view, const Clearance& clearance,
                                      const std::vector<Target>& targets, const Search& search) {
  add_candidates(targets, search);
  for (Aim& aim : candidates_) {
    const double steps = std::max(1.0, std::ceil((aim.place - here_).norm() / step_ - 0.05));
    aim.value = worth(aim.place, targets, search.grazing) / std::sqrt(steps);
  }
  std::stable_sort(candidates_.begin(), candidates_.end(),
                   [](const Aim& a, const Aim& b) { return a.value > b.value; });
  for (const double margin : search.margins)
    for (const Aim& aim : candidates_)
      if (is_good(view, clearance, aim, margin)) return aim;
  return std::nullopt;
}

}  // namespace limpet::following::internal
