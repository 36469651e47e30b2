// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/frontier/frontier_follower.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include "aims_internal.hpp"
#include "open_edge_map_internal.hpp"
#include "place_memory_internal.hpp"
#include "targets_internal.hpp"
#include "visited_internal.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using internal::Aim;
using internal::OpenPart;
using internal::Target;
using model::View;

constexpr double kWithinReach = 3.5;   ///< λ: open edges this near can be aimed at
constexpr double kTravelMargin = 1.2;  ///< δ − λ
constexpr int kStuck = 12;
constexpr long kOutcomePeriod = 20;  ///< sets

class FrontierFollower : public Follower {
 public:
  explicit FrontierFollower(const Parameters& p)
      : Follower(p),
        open_(p.resolution),
        memory_(p.resolution),
        finder_(p, memory_),
        visited_(p.resolution) {}

  Marks marks() const override {
    return {{}, open_.edges(internal::PartState::unreachable), open_.edges(internal::PartState::unclosable)};
  }
  std::int64_t outcomes_asked() const override { return outcomes_asked_; }

 protected:
  Motion choose(const Observation&) override;

 private:
  void look_at_what_was_read(const Observation&);
  void find_targets(const Observation&);
  void suspect_targets();
  void close_aim(const Vector3d& here);
  Motion go_on(const Observation&);
  Motion travel(const Observation&);
  std::vector<Vector3d> way_to_what_is_wanted() const;
  std::vector<Vector3d> way_to_what_was_given(const Observation&);
  Vector3d bent_off(const View&, const Vector3d& here, const Vector3d& motion) const;
  Vector3d kept_off(const Observation&, const Vector3d& motion) const;
  Vector3d way_out(const Observation&) const;
  void give_up_what_is_near();
  void leave_what_would_close(const Observation&);

  double lambda() const { return parameters().resolution; }
  double step(const Observation& seen) const {
    return std::min(parameters().max_step, seen.posture.robot().ceilings.prismatic);
  }

  internal::OpenEdgeMap open_;
  internal::PlaceMemory memory_;
  internal::TargetFinder finder_;
  internal::Visited visited_;
  std::vector<OpenPart> parts_;
  std::vector<Target> targets_;
  std::optional<Aim> aim_;
  std::vector<Vector3d> way_;  ///< of a travel, the next place last
  Vector3d before_ = Vector3d::Zero();
  long sets_ = 0, asked_ = -1;  ///< sets so far, and when it was last asked what would close
  int off_way_ = 0;             ///< steps left to where no visited way leads; 0: on a visited way
  std::int64_t outcomes_asked_ = 0;
  int stuck_ = 0;  ///< how often travels have been stopped since the last one that arrived
  bool travels_ = false, has_not_moved_ = false;
};

/// The distance up to which the ray of a sensor is known to be free.
double free_range(const kinematics::Posture::Sensor& sensor, std::span<const model::SensorPoint> readings) {
  constexpr double kSame = 1e-9;
  for (const model::SensorPoint& reading : readings)
    if ((reading.axis - sensor.axis).squaredNorm() < kSame &&
        (reading.position - (sensor.position + reading.range * sensor.axis)).norm() <
            kSame * (1 + reading.range))
      return reading.range;
  return sensor.range;
}

/// Remembers the targets that rays have gone through without meeting anything.
void FrontierFollower::look_at_what_was_read(const Observation& seen) {
  constexpr double kNear = 0.4, kBeyond = 0.6, kGrazing = 0.25;
  std::vector<bool> empty(targets_.size());
  for (std::size_t i = 0; i < seen.posture.robot().sensors.size(); ++i) {
    const auto sensor = seen.posture.sensor(i);
    const double free = free_range(sensor, seen.readings);
    for (std::size_t k = 0; k < targets_.size(); ++k) {
      const Target& target = targets_[k];
      const double fall = -sensor.axis.dot(target.normal);
      if (empty[k] || fall < kGrazing) continue;
      const double crosses = (sensor.position - target.at).dot(target.normal) / fall;
      if (crosses < 0 || crosses + kBeyond * lambda() > free) continue;
      const Vector3d off = sensor.position + crosses * sensor.axis - target.at;
      if (off.squaredNorm() < kNear * kNear * lambda() * lambda()) empty[k] = true;
    }
  }
  for (std::size_t k = 0; k < targets_.size(); ++k)
    if (empty[k]) memory_.note_empty(targets_[k].at, targets_[k].normal);
}

void FrontierFollower::find_targets(const Observation& seen) {
  const View view = seen.model.view();
  const Vector3d here = seen.posture.control_point();
  targets_.clear();
  open_.near(here, 5 * lambda(), view, parts_);
  for (const OpenPart& part : parts_) open_.set(part, finder_.add(view, part, targets_));
  if (!targets_.empty()) return;
  const auto point = view.nearest(here, parameters().sensing_range, {.polygons = false, .initial = false});
  if (point) finder_.add_around_point(view, point->at, here, targets_);
}

/// The model stops short of edges that are not felt yet, and targets are where the surface may go on.
void FrontierFollower::suspect_targets() {
  std::vector<Vector3d> places;
  for (const Target& target : targets_)
    if (target.weight == 1) places.push_back(target.at);
  clearance().suspect(std::move(places));
}

/// Drops an aim that has been reached, or that cannot be.
void FrontierFollower::close_aim(const Vector3d& here) {
  if (!aim_) return;
  const Target aimed = aim_->target;
  const bool has_arrived = (here - aim_->place).norm() < 0.05 * lambda();
  const bool still = std::any_of(targets_.begin(), targets_.end(), [&](const Target& t) {
    return (t.at - aimed.at).norm() < 0.3 * lambda() && t.normal.dot(aimed.normal) > 0.9;
  });
  if (still && has_arrived)
    memory_.note_failed(aimed.at, aimed.normal);
  else if (still && has_not_moved_)
    memory_.note_blocked(aimed.at, aimed.normal);
  aim_.reset();
}

/// The next step to the best aim near by.
Motion FrontierFollower::go_on(const Observation& seen) {
  const Vector3d here = seen.posture.control_point();
  internal::AimChooser chooser(parameters(), seen.posture, step(seen));
  aim_ = chooser.choose(seen.model.view(), clearance(), targets_);
  if (!aim_) return {};
  return {aim_->place - here, Mode::extend};
}

/// From here nothing can be aimed at: all targets near are blocked, for now.
void FrontierFollower::give_up_what_is_near() {
  for (const Target& target : targets_) memory_.note_blocked(target.at, target.normal);
}

void FrontierFollower::leave_what_would_close(const Observation& seen) {
  open_.note(seen.model.would_finish());
  ++outcomes_asked_;
  asked_ = sets_;
}

/// A motion that goes straight, if that is safe, or else along the surface that is in the way, and off it;
/// where it is too narrow to be safe, one of the two that is clear; and else the way out.
Vector3d FrontierFollower::kept_off(const Observation& seen, const Vector3d& motion) const {
  const View view = seen.model.view();
  const Vector3d here = seen.posture.control_point();
  const Vector3d bent = bent_off(view, here, motion);
  for (const Vector3d& way : {motion, bent})
    if (clearance().is_safe(view, here, here + way, kTravelMargin * clearance().least())) return way;
  for (const Vector3d& way : {motion, bent})
    if (clearance().is_clear(view, here, here + way)) return way;
  return way_out(seen);
}

/// The clear step that leads farthest from what is near.
Vector3d FrontierFollower::way_out(const Observation& seen) const {
  const View view = seen.model.view();
  const Vector3d here = seen.posture.control_point();
  const double reach = 2 * clearance().least();
  Vector3d best = Vector3d::Zero();
  double farthest = clearance().at(view, here, reach);
  for (std::size_t i = 0; i < seen.posture.robot().sensors.size(); ++i)
    for (const double length : {step(seen), step(seen) / 4}) {
      const Vector3d way = length * seen.posture.sensor(i).axis;
      if (!clearance().is_clear(view, here, here + way)) continue;
      const double distance = clearance().at(view, here + way, reach);
      if (distance > farthest) best = way, farthest = distance;
    }
  return best;
}

/// Without what leads towards the nearest surface, and away from it where it is near.
Vector3d FrontierFollower::bent_off(const View& view, const Vector3d& here, const Vector3d& motion) const {
  const double wanted = 1.5 * clearance().least();
  const auto nearest = view.nearest(here, 2 * wanted);
  if (!nearest || nearest->distance == 0) return motion;
  const Vector3d away = (here - nearest->at) / nearest->distance;
  const Vector3d along = motion - std::min(0.0, motion.dot(away)) * away;
  return along + std::max(0.0, wanted - nearest->distance) * away;
}

std::vector<Vector3d> FrontierFollower::way_to_what_is_wanted() const {
  return visited_.way_to(
      [&](const Vector3d& place) { return open_.any_wanted(place, kWithinReach * lambda()); });
}

/// Straight to the nearest wanted edge of an initial segment, which may be far from every visited place: what
/// was felt is always near one. Along surfaces that are in the way, so the steps are counted.
std::vector<Vector3d> FrontierFollower::way_to_what_was_given(const Observation& seen) {
  constexpr double kDetour = 3;
  const Vector3d here = seen.posture.control_point();
  const auto edge = open_.nearest_wanted_of_initial(here, seen.model.view());
  if (!edge) return {};
  off_way_ = kStuck + static_cast<int>(std::ceil(kDetour * (*edge - here).norm() / step(seen)));
  return {*edge};
}

Motion FrontierFollower::travel(const Observation& seen) {
  const Vector3d here = seen.posture.control_point();
  if (!way_.empty() && off_way_ > 0 && --off_way_ == 0) {
    open_.give_up(way_.front(), kWithinReach * lambda());
    way_.clear();
  }
  if (!way_.empty() && travels_ && has_not_moved_) {
    visited_.block(way_.back());
    if (++stuck_ >= kStuck) {
      open_.give_up(way_.front(), kWithinReach * lambda());
      stuck_ = 0;
    }
    way_.clear();
  }
  travels_ = true;
  if (way_.empty()) {
    if (sets_ - asked_ >= kOutcomePeriod / 2) leave_what_would_close(seen);
    way_ = way_to_what_is_wanted();
    if (way_.empty() && sets_ != asked_) leave_what_would_close(seen);
    if (way_.empty()) way_ = way_to_what_is_wanted();
    off_way_ = 0;
    if (way_.empty()) way_ = way_to_what_was_given(seen);
    if (way_.empty() && open_.insist()) way_ = way_to_what_is_wanted();
    if (way_.empty()) return {Vector3d::Zero(), Mode::travel, End::complete};
    std::reverse(way_.begin(), way_.end());
  }
  if (way_.size() > 1 && (way_.back() - here).norm() < 0.1 * lambda()) way_.pop_back();
  // Straight to the farthest place of the way that is in sight.
  const View view = seen.model.view();
  for (int looked = 0; looked < 4 && way_.size() > 1; ++looked) {
    if (!clearance().is_safe(view, here, way_[way_.size() - 2], kTravelMargin * clearance().least())) break;
    way_.pop_back();
  }
  const Vector3d motion = way_.back() - here;
  if (motion.norm() < step(seen) + 1e-6 * lambda()) way_.pop_back();
  return {kept_off(seen, motion.normalized() * std::min(motion.norm(), step(seen))), Mode::travel};
}

Motion FrontierFollower::choose(const Observation& seen) {
  const View view = seen.model.view();
  const Vector3d here = seen.posture.control_point();
  if (sets_ == 0 && seen.readings.empty()) return {Vector3d::Zero(), Mode::none, End::no_surface};
  if (sets_ == 0)
    open_.read(view);
  else
    open_.apply(seen.changes, view);
  if (++sets_ % kOutcomePeriod == 0) leave_what_would_close(seen);
  visited_.arrive(view, clearance(), here);
  look_at_what_was_read(seen);
  find_targets(seen);
  suspect_targets();
  has_not_moved_ = (here - before_).norm() < 1e-3 * lambda();
  before_ = here;
  close_aim(here);
  Motion motion;
  if (!targets_.empty()) {
    motion = go_on(seen);
    if (motion.mode == Mode::none && way_.empty()) give_up_what_is_near();
  }
  if (motion.mode != Mode::none) {
    way_.clear();
    stuck_ = 0;
    travels_ = false;
    return motion;
  }
  return travel(seen);
}

}  // namespace

std::unique_ptr<Follower> make_frontier_follower(const Parameters& parameters) {
  return std::make_unique<FrontierFollower>(parameters);
}

}  // namespace limpet::following
