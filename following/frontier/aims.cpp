// Copyright the limpet authors. GPL-3.0-or-later.
#include "aims_internal.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace limpet::following::internal {

using Eigen::Vector3d;

/// Where to look for places.
struct AimChooser::Search {
  std::size_t targets, candidates;  ///< the nearest so many
  double least_cosine;              ///< of incidence
  std::span<const double> heights;  ///< δ over the expected surface
  /// Times δ − λ, to be kept off suspected places, too; the first for which there is an aim. 0: what is clear
  /// will do.
  std::span<const double> margins;
};

namespace {

constexpr double kFree[] = {0.8, 1.1, 1.5}, kFreeMargins[] = {1.35, 1.1};
/// Between walls that are less than 2 δ apart, places are low over one and look along it.
constexpr double kNarrow[] = {0.38, 0.55, 0.7, 0.85, 1.1, 1.5}, kNarrowMargins[] = {1.05, 0};

}  // namespace

AimChooser::AimChooser(const Parameters& parameters, const kinematics::Posture& posture, double step,
                       Reaches reaches)
    : lambda_(parameters.resolution),
      height_(parameters.follow_distance),
      step_(step),
      here_(posture.control_point()),
      reaches_(std::move(reaches)) {
  constexpr double kSure = 0.95;  // of the range: what is farther may just be missed
  for (std::size_t i = 0; i < posture.robot().sensors.size(); ++i) {
    const auto sensor = posture.sensor(i);
    axes_.push_back({sensor.position - here_, sensor.axis, kSure * sensor.range});
  }
}

void AimChooser::add_candidates(const Target& target, const Search& search) {
  for (const Ray& axis : axes_) {
    const double cosine = -axis.axis.dot(target.normal);
    if (cosine < search.least_cosine) continue;
    for (const double height : search.heights) {
      const double range = height * height_ / cosine;
      if (range <= axis.range)
        candidates_.push_back({target.at - range * axis.axis - axis.from, axis.from, target, 0});
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

bool AimChooser::is_good(const model::View& view, const Clearance& clearance, const ExpectedPlanes& planes,
                         const Aim& aim, double margin) const {
  const double distance = margin * clearance.least();
  if (margin > 0 && planes.is_low_over_new_ground(aim.place, distance)) return false;
  if (margin > 0 ? !clearance.is_safe(view, here_, aim.place, distance)
                 : !clearance.is_clear(view, here_, aim.place))
    return false;
  const Vector3d from = aim.place + aim.sensor, way = aim.target.at - from;
  const auto hit = view.first_hit(from, way, way.norm() - lambda_ / 2);
  return !hit;
}

/// What is near a place that is out of reach is taken to be so, too.
bool AimChooser::is_reached(const Vector3d& place) {
  constexpr double kNear = 0.7;  // λ
  constexpr std::size_t kMostAsked = 10;
  if (!reaches_) return true;
  if (out_of_reach_.size() == kMostAsked) return false;
  const auto is_near = [&](const Vector3d& other) { return (other - place).norm() < kNear * lambda_; };
  if (std::any_of(out_of_reach_.begin(), out_of_reach_.end(), is_near)) return false;
  if (reaches_(place)) return true;
  out_of_reach_.push_back(place);
  return false;
}

std::optional<Aim> AimChooser::choose(const model::View& view, const Clearance& clearance,
                                      const std::vector<Target>& targets, ExpectedPlanes& planes) {
  constexpr double kLeastCosine = 0.34;  // 70°
  auto found = choose(view, clearance, targets, planes, {10, 100, kLeastCosine, kFree, kFreeMargins});
  if (found) return found;
  return choose(view, clearance, targets, planes, {24, 240, kLeastCosine / 2, kNarrow, kNarrowMargins});
}

std::optional<Aim> AimChooser::choose(const model::View& view, const Clearance& clearance,
                                      const std::vector<Target>& targets, ExpectedPlanes& planes,
                                      const Search& search) {
  add_candidates(targets, search);
  planes.look_along(axes_, search.least_cosine);
  for (Aim& aim : candidates_) {
    const double steps = std::max(1.0, std::ceil((aim.place - here_).norm() / step_ - 0.05));
    aim.value = planes.worth(aim.place) / std::sqrt(steps);
  }
  std::stable_sort(candidates_.begin(), candidates_.end(),
                   [](const Aim& a, const Aim& b) { return a.value > b.value; });
  for (const double margin : search.margins)
    for (const Aim& aim : candidates_)
      if (is_good(view, clearance, planes, aim, margin) && is_reached(aim.place)) return aim;
  return std::nullopt;
}

}  // namespace limpet::following::internal
