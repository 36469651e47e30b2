// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limpet/following/links/goal_postures.hpp>
#include <limpet/following/links/joint_plan.hpp>
#include <limpet/following/links/roadmap.hpp>

#include "transit_internal.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;
using kinematics::Configuration;

class JointTransit final : public Transit {
 public:
  explicit JointTransit(LinkMotion& links);

  void arrive(const Observation&) override;
  bool begin(const Wanted&) override;
  bool begin_to(const Vector3d& place) override {
    return begin_to_one_of(goal_postures(links_, roadmap_, place));
  }
  bool begin_to_see(const Suspicion&) override;
  void stop() override { way_.clear(); }
  void arrived() override { way_.clear(), stops_ = 0; }
  bool is_under_way() const override { return !way_.empty(); }
  Vector3d goal() const override { return node(way_.front()).place; }
  std::vector<Vector3d> way() const override;
  Travel::Progress look(const Observation&, bool has_moved) override;
  Motion next(const Observation&) override;

 private:
  static constexpr double kThere = 0.05;  ///< steps from a configuration: there

  const Roadmap::Node& node(std::size_t i) const { return roadmap_.nodes()[i]; }
  bool begin_to_one_of(const std::vector<Configuration>& goals);
  void set_way(std::vector<std::size_t> way, Mode);
  bool go_round(const Observation&, bool turns_back);
  bool is_stopped(const Configuration& here);
  bool has_come_upon_something() const;
  std::vector<std::size_t> shortened(std::vector<std::size_t> way) const;
  void leave_out_what_is_passed(const Configuration& here);

  LinkMotion& links_;
  Roadmap roadmap_;
  std::vector<std::size_t> at_control_point_, elsewhere_;  ///< sensors
  Mode mode_ = Mode::travel;
  std::vector<std::size_t> way_;  ///< nodes, the next one last
  long steps_left_ = 0;           ///< until the goal is given up
  int stops_ = 0;                 ///< since the last way that arrived
  std::size_t leg_ = 0;           ///< the next node, at the last look
  double left_ = 0;               ///< steps to it then
};

JointTransit::JointTransit(LinkMotion& links) : links_(links), roadmap_(links.guard()) {
  constexpr double kNear = 2;  // λ
  const kinematics::Robot& robot = links.guard().robot();
  for (std::size_t i = 0; i < robot.sensors.size(); ++i) {
    const auto& sensor = robot.sensors[i];
    const bool is_near =
        sensor.link == robot.control_point.link &&
        (sensor.position - robot.control_point.position).norm() <= kNear * links.parameters().resolution;
    (is_near ? at_control_point_ : elsewhere_).push_back(i);
  }
}

void JointTransit::arrive(const Observation& seen) {
  roadmap_.arrive(seen.posture, links_.obstacles());
  if (is_under_way() && roadmap_.steps(node(way_.front()).at, seen.posture.configuration()) < kThere)
    way_.clear(), stops_ = 0;
}

bool JointTransit::begin(const Wanted& wanted) {
  const std::size_t here = roadmap_.present();
  set_way(roadmap_.way_to([&](std::size_t i) { return i != here && wanted(node(i).place); }), Mode::travel);
  return is_under_way();
}

bool JointTransit::begin_to_one_of(const std::vector<Configuration>& goals) {
  const auto plan = plan_to(goals, links_, roadmap_);
  if (!plan) return false;
  const std::size_t goal = roadmap_.add_way(plan->from, plan->after);
  set_way(roadmap_.way_to([&](std::size_t i) { return i == goal; }), Mode::reposition);
  return is_under_way();
}

/// From where a sensor at the control point sees something, the strategy goes on by itself.
bool JointTransit::begin_to_see(const Suspicion& suspicion) {
  for (const Sight sight : {Sight::sure, Sight::faint})
    for (const auto* sensors : {&at_control_point_, &elsewhere_})
      if (begin_to_one_of(sighting_postures(links_, roadmap_, suspicion, sight, *sensors))) return true;
  return false;
}

/// Without what can be left out: from each node straight to the farthest that can be gone to, of those that
/// halve what is left again and again.
std::vector<std::size_t> JointTransit::shortened(std::vector<std::size_t> way) const {
  for (std::size_t i = 0; i + 2 < way.size(); ++i)
    for (std::size_t ahead = way.size() - 1 - i; ahead > 1; ahead /= 2)
      if (links_.guard().connects(node(way[i]).at, node(way[i + ahead]).at, links_.obstacles())) {
        const auto first = way.begin() + static_cast<std::ptrdiff_t>(i) + 1;
        way.erase(first, first + static_cast<std::ptrdiff_t>(ahead) - 1);
        break;
      }
  return way;
}

void JointTransit::set_way(std::vector<std::size_t> way, Mode mode) {
  constexpr long kMoreSteps = 12, kDetour = 3;
  way = shortened(std::move(way));
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += roadmap_.steps(node(way[i - 1]).at, node(way[i]).at);
  steps_left_ = kMoreSteps + kDetour * std::lround(length);
  std::reverse(way.begin(), way.end());
  way_ = std::move(way);
  mode_ = mode;
}

std::vector<Vector3d> JointTransit::way() const {
  std::vector<Vector3d> places;
  for (auto i = way_.rbegin(); i != way_.rend(); ++i) places.push_back(node(*i).place);
  return places;
}

/// Has the last motion not brought it nearer to the next node?
bool JointTransit::is_stopped(const Configuration& here) {
  constexpr double kLeast = 0.1;  // steps
  const double left = roadmap_.steps(node(way_.back()).at, here);
  const bool is_stopped = leg_ == way_.back() && left > left_ - kLeast;
  leg_ = way_.back(), left_ = left;
  return is_stopped;
}

/// On a way through what none has seen, is something nearer than links are to come? More of it may be nearer.
bool JointTransit::has_come_upon_something() const {
  constexpr double kTooNear = 0.9;  // d_s
  return mode_ == Mode::reposition && links_.clearance() < kTooNear * links_.parameters().least_distance;
}

/// A new way to the goal or to a node on the way there: from here, or where this is no place to go on from,
/// from where the robot has been before.
bool JointTransit::go_round(const Observation& seen, bool turns_back) {
  roadmap_.arrive_exactly(seen.posture);
  std::vector<Configuration> ends;
  for (const std::size_t i : {std::size_t{0}, way_.size() / 2, way_.size() - 1})
    if (ends.empty() || ends.back() != node(way_[i]).at) ends.push_back(node(way_[i]).at);
  std::erase_if(ends, [&](const Configuration& end) {
    return !links_.guard().is_clear(kinematics::Posture(links_.guard().robot(), end), links_.obstacles());
  });
  const auto plan = turns_back ? plan_to_but_from(roadmap_.present(), ends, links_, roadmap_)
                               : plan_from(roadmap_.present(), ends, links_, roadmap_);
  if (!plan) return false;
  const std::size_t goal = way_.front();
  roadmap_.add_way(plan->from, plan->after);
  set_way(roadmap_.way_to([&](std::size_t i) { return i == goal; }), mode_);
  return is_under_way();
}

Travel::Progress JointTransit::look(const Observation& seen, bool) {
  constexpr int kStops = 6;
  const bool turns_back = has_come_upon_something();
  const bool stopped = is_stopped(seen.posture.configuration()) || turns_back;
  if (stopped) roadmap_.block(way_.back()), ++stops_;
  const bool is_hopeless = stops_ >= kStops || --steps_left_ <= 0;
  if (is_hopeless) stops_ = 0;
  if (is_hopeless) return Travel::Progress::hopeless;
  return stopped && !go_round(seen, turns_back) ? Travel::Progress::stopped : Travel::Progress::good;
}

/// Straight to the farthest node of the way, of the next few, that can be gone to.
void JointTransit::leave_out_what_is_passed(const Configuration& here) {
  constexpr int kAhead = 3;
  for (int i = 0; i < kAhead && way_.size() > 1; ++i) {
    const Configuration& next = node(way_[way_.size() - 2]).at;
    const bool is_there = roadmap_.steps(node(way_.back()).at, here) < kThere;
    if (!is_there && !links_.guard().connects(here, next, links_.obstacles())) return;
    way_.pop_back();
  }
}

Motion JointTransit::next(const Observation& seen) {
  leave_out_what_is_passed(seen.posture.configuration());
  return {Vector3d::Zero(), links_.towards(node(way_.back()).at), mode_};
}

}  // namespace

std::unique_ptr<Transit> make_joint_transit(LinkMotion& links) {
  return std::make_unique<JointTransit>(links);
}

}  // namespace limpet::following::internal
