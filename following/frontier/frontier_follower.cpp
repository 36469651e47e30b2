// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/following/frontier/frontier_follower.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <limpet/following/space_hash_internal.hpp>
#include <limpet/following/transit/transit_internal.hpp>
#include "aims_internal.hpp"
#include "closing_watch_internal.hpp"
#include "empty_rays_internal.hpp"
#include "open_edge_map_internal.hpp"
#include "place_memory_internal.hpp"
#include "repositioning_internal.hpp"
#include "targets_internal.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;
using internal::Aim;
using internal::OpenPart;
using internal::PartState;
using internal::Ray;
using internal::Target;
using model::View;

struct Nothing {};

constexpr int kRetries = 2;  ///< of what was unreachable

class FrontierFollower : public Follower {
 public:
  FrontierFollower(const Parameters& p, std::unique_ptr<LinkMotion> links)
      : Follower(p, std::move(links)),
        open_(p.resolution),
        memory_(p.resolution),
        empty_(3 * p.resolution),
        finder_(p, memory_),
        closing_(open_, judge() != nullptr),
        repositioning_(parameters(), open_, memory_, finder_) {}

  Marks marks() const override {
    return {{}, open_.edges(PartState::unreachable), open_.edges(PartState::unclosable)};
  }
  Intent intent(const View&) const override;
  std::int64_t outcomes_asked() const override { return closing_.asked(); }

 protected:
  Motion choose(const Observation&) override;

 private:
  void begin(const Observation&);
  void look_at_what_was_read(const Observation&);
  void arrive(const Observation&);
  void look_around(const Observation&);
  void look_around_points(const View&, const Vector3d& here);
  bool has_arrived(const kinematics::Posture&) const;
  bool tells_of_nothing(const kinematics::Posture&) const;
  void close_aim(const kinematics::Posture&, bool has_moved);
  Motion go_on(const Observation&);
  void give_up_what_is_near(const Observation&);
  Motion travel(const Observation&, bool has_moved);
  void look_from_afar(const Observation&);
  bool begin_travel(const Observation&);
  bool begin_again(const Observation&);

  double lambda() const { return parameters().resolution; }
  /// Open edges this near can be aimed at.
  double aiming_reach() const { return 0.875 * parameters().sensing_range; }
  /// What is this near is looked at: outside edges just out of range there may be something to be met.
  double outlook_reach() const { return parameters().sensing_range + lambda(); }
  double step(const Observation& seen) const {
    return std::min(parameters().max_step, seen.posture.robot().ceilings.prismatic);
  }

  internal::OpenEdgeMap open_;
  internal::PlaceMemory memory_;
  internal::SpaceHash<Nothing> empty_;  ///< where rays met nothing on ground that was expected
  internal::TargetFinder finder_;
  internal::ClosingWatch closing_;
  internal::Repositioning repositioning_;
  std::unique_ptr<internal::Transit> transit_;  ///< from the first set on
  std::vector<OpenPart> parts_;
  std::vector<View::Nearest> points_;
  internal::Outlook outlook_;
  std::optional<internal::ExpectedPlanes> planes_;  ///< of the outlook
  std::optional<Aim> aim_;
  Vector3d before_ = Vector3d::Zero(), start_ = Vector3d::Zero();
  bool has_begun_again_ = false;
  long sets_ = 0;
  int retries_ = 0;
};

/// Remembers where surface was expected and rays met nothing.
void FrontierFollower::look_at_what_was_read(const Observation& seen) {
  if (!planes_) return;
  const std::vector<Ray> rays = internal::free_rays(seen, lambda());
  internal::note_empty(outlook_.targets, rays, lambda(), memory_);
  std::vector<Vector3d> places;
  for (const Ray& ray : rays) planes_->add_new_ground(ray, internal::kLeastThroughCosine, places);
  for (const Vector3d& place : places)
    if (!empty_.any_within(place, internal::kThrough * lambda(),
                           [](const Vector3d&, Nothing) { return true; }))
      empty_.put(place, {});
}

/// Where there are no other targets, finds some around points: one after the other, since on a curved surface
/// few become polygons. Beside edges that are known, single points that are alone are outliers, but for the
/// nearest.
void FrontierFollower::look_around_points(const View& view, const Vector3d& here) {
  constexpr double kTogether = 1.5;  // λ
  for (const View::Nearest& point : points_) {
    if (!outlook_.targets.empty() || point.distance >= parameters().sensing_range) return;
    const auto is_beside = [&](const View::Nearest& other) {
      return &other != &point && (other.at - point.at).norm() < kTogether * lambda();
    };
    if (&point == &points_.front() || parts_.empty() || view.segment(point.segment)->points > 1 ||
        std::any_of(points_.begin(), points_.end(), is_beside))
      finder_.add_around_point(view, point.at, here, outlook_.targets);
  }
}

/// Finds what is known near the control point, and expected.
void FrontierFollower::look_around(const Observation& seen) {
  const View view = seen.model.view();
  const Vector3d here = seen.posture.control_point();
  outlook_.clear();
  open_.near(here, outlook_reach(), view, parts_);
  for (const OpenPart& part : parts_)
    if (const PartState state = finder_.add(view, part, outlook_); !part.closes) open_.set(part, state);
  view.nearest(here, outlook_reach(), points_, {.polygons = false, .initial = false});
  for (const View::Nearest& point : points_) outlook_.points.push_back(point.at);
  empty_.for_each_within(here, outlook_reach(),
                         [&](const Vector3d& place, Nothing) { outlook_.empty.push_back(place); });
  look_around_points(view, here);
  planes_.emplace(lambda(), outlook_);
}

/// Is the control point where it was to be, and does the axis go through the target from there? A point robot
/// does not turn.
bool FrontierFollower::has_arrived(const kinematics::Posture& posture) const {
  constexpr double kThere = 0.05, kTurnedThere = 0.15, kMet = 0.4;  // λ
  const double off = (posture.control_point() - aim_->place).norm();
  if (!links()) return off < kThere * lambda();
  const auto sensor = posture.sensor(aim_->axis);
  const Vector3d way = aim_->target.at - sensor.position;
  return off < kTurnedThere * lambda() && (way - way.dot(sensor.axis) * sensor.axis).norm() < kMet * lambda();
}

/// Does the ray reach so far beyond the target that something would have been met if it were there? Of an
/// arm, at the end of its range, it may not, and where the arm comes to is not where it was to come to.
bool FrontierFollower::tells_of_nothing(const kinematics::Posture& posture) const {
  constexpr double kBeyond = 0.6;  // λ
  if (!links()) return true;
  const auto sensor = posture.sensor(aim_->axis);
  return (aim_->target.at - sensor.position).norm() < sensor.range - kBeyond * lambda();
}

/// Drops an aim that has been reached, or that cannot be.
void FrontierFollower::close_aim(const kinematics::Posture& posture, bool has_moved) {
  if (!aim_) return;
  const Target aimed = aim_->target;
  const bool has_arrived = this->has_arrived(posture), tells = has_arrived && tells_of_nothing(posture);
  const bool still = std::any_of(outlook_.targets.begin(), outlook_.targets.end(), [&](const Target& t) {
    return (t.at - aimed.at).norm() < 0.3 * lambda() && t.normal.dot(aimed.normal) > 0.9;
  });
  if (still && tells)
    memory_.note_failed(aimed.at, aimed.normal);
  else if (still && (has_arrived || !has_moved))
    memory_.note_blocked(aimed.at, aimed.normal);
  aim_.reset();
}

/// The next step to the best aim near by.
Motion FrontierFollower::go_on(const Observation& seen) {
  internal::AimChooser::Reaching reaching;
  if (LinkMotion* links = judge())
    reaching = [links](const Vector3d& place) { return links->reaching(place); };
  internal::AimChooser chooser(parameters(), seen.posture, step(seen), reaching);
  aim_ = chooser.choose(seen.model.view(), clearance(), outlook_.targets, *planes_);
  if (!aim_) return {};
  memory_.note_aimed(aim_->target.at, aim_->target.normal);
  return {aim_->place - seen.posture.control_point(), {}, Mode::extend};
}

/// From here nothing can be aimed at: all targets near are blocked, for now. Where that was judged and not
/// tried, to try it again would tell nothing new.
void FrontierFollower::give_up_what_is_near(const Observation& seen) {
  for (const Target& target : outlook_.targets)
    if (judge())
      memory_.note_out_of_reach(target.at, target.normal);
    else
      memory_.note_blocked(target.at, target.normal);
  if (judge()) look_around(seen);
}

/// What is known or given up by now need not be gone to.
void FrontierFollower::look_from_afar(const Observation& seen) {
  const View view = seen.model.view();
  internal::Outlook there;
  for (const OpenPart& part : open_.left(seen.posture.control_point(), view))
    if (part.state == PartState::wanted) open_.set(part, finder_.add(view, part, there));
}

/// The last resorts are an edge of an initial segment, which may be far from every visited place (what was
/// felt is always near one), what seems to be known, and what was in the way of something before.
bool FrontierFollower::begin_travel(const Observation& seen) {
  const auto wanted = [&](const Vector3d& place) { return open_.any_wanted(place, aiming_reach()); };
  if (judge()) look_from_afar(seen);
  closing_.look_before_leaving(seen);
  if (transit_->begin(wanted)) return true;
  if (closing_.look_now(seen) && transit_->begin(wanted)) return true;
  while (const auto given =
             open_.nearest_wanted_of_initial(seen.posture.control_point(), seen.model.view())) {
    if (transit_->begin_to(*given)) return true;
    open_.give_up(*given, aiming_reach());
  }
  if (open_.insist() && transit_->begin(wanted)) return true;
  if (judge()) return repositioning_.begin(seen, *transit_, outlook_.targets);
  if (retries_ == kRetries || !open_.retry()) return false;
  ++retries_;
  memory_.forget_blocked();
  return transit_->begin(wanted);
}

/// A sensor that said a distance wherever it was may have led the robot away until that was seen: where
/// nothing is modelled at the end, the surface that it began at is gone back to, once.
bool FrontierFollower::begin_again(const Observation& seen) {
  if (has_begun_again_ || seen.model.counts().polygons > 0) return false;
  has_begun_again_ = true;
  return transit_->begin([&](const Vector3d& place) { return (place - start_).norm() < 0.1 * lambda(); });
}

void FrontierFollower::arrive(const Observation& seen) {
  const bool was_under_way = transit_->is_under_way();
  transit_->arrive(seen);
  if (!repositioning_.is_under_way() || transit_->is_under_way()) return;
  if (was_under_way)
    repositioning_.arrived(seen);
  else
    repositioning_.stop();
}

Motion FrontierFollower::travel(const Observation& seen, bool has_moved) {
  if (transit_->is_under_way()) {
    const auto progress = transit_->look(seen, has_moved);
    if (progress == internal::Travel::Progress::hopeless) {
      open_.give_up(transit_->goal(), aiming_reach());
      give_up_what_is_near(seen);  // it is looked at at every step, and would be wanted again for ever
    }
    if (progress != internal::Travel::Progress::good) transit_->stop(), repositioning_.stop();
  }
  if (!transit_->is_under_way() && !begin_travel(seen) && !begin_again(seen))
    return {Vector3d::Zero(), {}, Mode::travel, End::complete};
  return transit_->next(seen);
}

Intent FrontierFollower::intent(const View&) const {
  Intent intent;
  for (const Target& target : outlook_.targets) intent.targets.push_back(target.at);
  if (aim_) intent.aim = {aim_->target.at, aim_->place};
  if (transit_ && transit_->is_under_way()) intent.way = transit_->way();
  return intent;
}

void FrontierFollower::begin(const Observation& seen) {
  open_.read(seen.model.view());
  if (LinkMotion* links = judge())
    transit_ = internal::make_joint_transit(*links);
  else
    transit_ = internal::make_place_transit(lambda(), step(seen), clearance());
  before_ = start_ = seen.posture.control_point();
}

Motion FrontierFollower::choose(const Observation& seen) {
  const View view = seen.model.view();
  const Vector3d here = seen.posture.control_point();
  if (sets_ == 0 && seen.readings.empty()) return {Vector3d::Zero(), {}, Mode::none, End::no_surface};
  if (sets_ == 0)
    begin(seen);
  else
    open_.apply(seen.changes, view);
  ++sets_;
  closing_.look(seen);
  const bool has_moved = (here - before_).norm() >= 1e-3 * lambda();
  before_ = here;
  arrive(seen);
  look_at_what_was_read(seen);
  look_around(seen);
  clearance().suspect(outlook_.suspected);
  close_aim(seen.posture, has_moved);
  if (!outlook_.targets.empty() && !repositioning_.is_under_way()) {
    if (const Motion motion = go_on(seen); motion.mode != Mode::none) {
      transit_->arrived();
      return motion;
    }
    if (!transit_->is_under_way()) give_up_what_is_near(seen);
  }
  return travel(seen, has_moved);
}

}  // namespace

std::unique_ptr<Follower> make_frontier_follower(const Parameters& parameters,
                                                 std::unique_ptr<LinkMotion> links) {
  return std::make_unique<FrontierFollower>(parameters, std::move(links));
}

}  // namespace limpet::following
