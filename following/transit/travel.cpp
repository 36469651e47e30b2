// Copyright the limpet authors. GPL-3.0-or-later.
#include "travel_internal.hpp"

#include "detour_internal.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limpet::following::internal {

using Eigen::Vector3d;

namespace {

constexpr double kThere = 0.1;  ///< λ from a place: near enough

}  // namespace

void Travel::arrive(const model::View& view, const Clearance& clearance, const Vector3d& here) {
  visited_.arrive(view, clearance, here);
  here_ = here;
  if (is_under_way() && (goal() - here).norm() < kThere * lambda_) way_.clear();
}

bool Travel::begin(const std::function<bool(const Vector3d&)>& wanted) {
  set_way(visited_.way_to(wanted));
  return is_under_way();
}

void Travel::begin(const Vector3d& to) { set_way({to}); }

/// The number of steps that a way from here may take.
long Travel::steps_for(const std::vector<Vector3d>& way) const {
  constexpr double kDetour = 3;  // times the way's length
  double length = 0;
  Vector3d before = here_;
  for (const Vector3d& place : way) length += (place - std::exchange(before, place)).norm();
  return std::lround(kDetour * length / step_);
}

void Travel::set_way(std::vector<Vector3d> way) {
  constexpr long kSteps = 12;  // beside those for its length
  steps_left_ = kSteps + steps_for(way);
  way_ = std::move(way);
  std::reverse(way_.begin(), way_.end());
  planned_ = way_.size();
}

bool Travel::go_round(const model::View& view, const Clearance& clearance) {
  constexpr double kSpacing = 0.5;  // λ
  constexpr int kPlacesAhead = 4;   // the next one may be one that is not clear any more
  if (is_on_detour()) return false;
  for (int looked = 0; looked < kPlacesAhead && !way_.empty(); ++looked, way_.pop_back()) {
    const std::vector<Vector3d> round = detour(view, clearance, here_, way_.back(), kSpacing * lambda_);
    if (round.empty()) continue;
    if (round.back() == way_.back()) way_.pop_back();
    planned_ = way_.size();
    way_.insert(way_.end(), round.rbegin(), round.rend());
    steps_left_ += steps_for(round);
    idle_ = 0, nearest_ = kFar;
    return true;
  }
  return false;
}

Travel::Progress Travel::look(const Vector3d& here, bool has_moved) {
  constexpr int kStops = 12;
  const bool is_stopped = comes_no_nearer(here) || !has_moved;
  if (is_stopped) visited_.block(way_.back()), ++stops_;
  const bool is_hopeless = stops_ >= kStops || --steps_left_ <= 0;
  if (is_hopeless) begin_anew();
  return is_hopeless ? Progress::hopeless : is_stopped ? Progress::stopped : Progress::good;
}

/// What bends a motion off the surface can lead it back and forth.
bool Travel::comes_no_nearer(const Vector3d& here) {
  constexpr int kPatience = 4;  // steps
  const double distance = (way_.back() - here).norm();
  if (leg_ != way_.back() || distance < nearest_ - 0.1 * lambda_)
    nearest_ = distance, idle_ = 0;
  else
    ++idle_;
  leg_ = way_.back();
  return idle_ >= kPatience;
}

Vector3d Travel::next(const Steering& steering, const Vector3d& here) {
  if (way_.size() > 1 && (way_.back() - here).norm() < kThere * lambda_) way_.pop_back();
  // Straight to the farthest place of the way that is in sight.
  constexpr int kPlacesAhead = 4;
  for (int looked = 0; looked < kPlacesAhead && way_.size() > 1; ++looked) {
    const Vector3d& next = way_[way_.size() - 2];
    if (is_on_detour() ? !steering.is_clear(next) : !steering.is_safe(next)) break;
    way_.pop_back();
  }
  const Vector3d there = way_.back();
  const bool is_straight = is_on_detour();
  if (way_.size() > 1 && (there - here).norm() < step_ + 1e-6 * lambda_) way_.pop_back();
  return is_straight ? steering.straight(there) : steering.towards(there);
}

}  // namespace limpet::following::internal
