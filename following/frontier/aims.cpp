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
  double share;                     ///< of the range, to be used
  std::span<const double> heights;  ///< δ over the expected surface
  /// Times δ − λ, to be kept off suspected places, too; the first for which there is an aim. 0: what is clear
  /// will do.
  std::span<const double> margins;
};

namespace {

constexpr double kSure = 0.95;            ///< of the range: what is farther may just be missed
constexpr double kTellsOfNothing = 0.88;  ///< of that: where a ray reaches well beyond what it aims at
constexpr double kFree[] = {0.8, 1.1, 1.5}, kFreeMargins[] = {1.35, 1.1};
/// Between walls that are less than 2 δ apart, places are low over one and look along it.
constexpr double kNarrow[] = {0.38, 0.55, 0.7, 0.85, 1.1, 1.5}, kNarrowMargins[] = {1.05, 0};

}  // namespace

AimChooser::AimChooser(const Parameters& parameters, const kinematics::Posture& posture, double step,
                       Reaching reaching)
    : lambda_(parameters.resolution),
      height_(parameters.follow_distance),
      step_(step),
      here_(posture.control_point()),
      reaching_(std::move(reaching)) {
  constexpr double kAtControlPoint = 2;  // λ: the others' axes turn too much on the way
  for (std::size_t i = 0; i < posture.robot().sensors.size(); ++i) {
    const auto sensor = posture.sensor(i);
    if (reaching_ && (sensor.position - here_).norm() > kAtControlPoint * lambda_) continue;
    axes_.push_back({sensor.position - here_, sensor.axis, kSure * sensor.range});
    sensors_.push_back(i);
  }
}

void AimChooser::add_candidates(const Target& target, const Search& search) {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const Ray& axis = axes_[i];
    const double cosine = -axis.axis.dot(target.normal);
    if (cosine < search.least_cosine) continue;
    for (const double height : search.heights) {
      const double range = height * height_ / cosine;
      if (range <= search.share * axis.range)
        candidates_.push_back({target.at - range * axis.axis - axis.from, axis.from, sensors_[i], target, 0});
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

/// The aim, its place moved until the axis meets the target in the posture in which the robot comes there:
/// an arm turns on its way, and its axes with it. What is near a place out of reach is taken to be so, too.
std::optional<Aim> AimChooser::reached(const Aim& wanted, const Search& search,
                                       const std::function<bool(const Aim&)>& is_good) {
  constexpr double kNear = 0.7, kMet = 0.3;  // λ
  constexpr int kMostAsked = 12, kCorrections = 2;
  if (!reaching_) return wanted;
  const auto is_near = [&](const Vector3d& other) { return (other - wanted.place).norm() < kNear * lambda_; };
  if (std::any_of(out_of_reach_.begin(), out_of_reach_.end(), is_near)) return std::nullopt;
  const double range = (wanted.target.at - wanted.place - wanted.sensor).norm();
  Aim aim = wanted;
  for (int i = 0; i <= kCorrections && asked_ < kMostAsked; ++i) {
    ++asked_;
    const auto posture = reaching_(aim.place);
    if (!posture) break;
    const auto sensor = posture->sensor(aim.axis);
    const Vector3d way = aim.target.at - sensor.position;
    const Vector3d along = way.dot(sensor.axis) * sensor.axis;
    if (-sensor.axis.dot(aim.target.normal) < search.least_cosine) return std::nullopt;
    if ((way - along).norm() < kMet * lambda_ && way.dot(sensor.axis) > 0) return aim;
    aim.sensor = sensor.position - posture->control_point();
    aim.place = aim.target.at - range * sensor.axis - aim.sensor;
    if (!is_good(aim)) return std::nullopt;
  }
  out_of_reach_.push_back(wanted.place);
  return std::nullopt;
}

std::optional<Aim> AimChooser::choose(const model::View& view, const Clearance& clearance,
                                      const std::vector<Target>& targets, ExpectedPlanes& planes) {
  constexpr double kLeastCosine = 0.34;  // 70°
  // An arm comes to a place less exactly, and has fewer to choose from: it is often at the end of its range,
  // where a ray that meets nothing does not tell that there is nothing.
  const double share = reaching_ ? kTellsOfNothing : 1;
  auto found = choose(view, clearance, targets, planes, {10, 100, kLeastCosine, share, kFree, kFreeMargins});
  if (found) return found;
  return choose(view, clearance, targets, planes, {24, 240, kLeastCosine / 2, 1, kNarrow, kNarrowMargins});
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
    for (const Aim& aim : candidates_) {
      const auto good = [&](const Aim& a) { return is_good(view, clearance, planes, a, margin); };
      if (!good(aim)) continue;
      if (auto found = reached(aim, search, good)) return found;
    }
  return std::nullopt;
}

}  // namespace limpet::following::internal
