// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <array>
#include <limits>
#include <limpet/following/thesis/control_point_motion.hpp>
#include <limpet/following/thesis/thesis_follower.hpp>
#include <limpet/following/transit/transit_internal.hpp>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "changes_internal.hpp"
#include "current_edge_internal.hpp"
#include "current_segment_internal.hpp"
#include "current_surface_internal.hpp"
#include "gap_following_internal.hpp"
#include "point_following_internal.hpp"
#include "pursuit_internal.hpp"
#include "situation_internal.hpp"

namespace limpet::following {
namespace {

using namespace internal;
using Eigen::Vector3d;

Situation situation(const Parameters& parameters, const Observation& seen) {
  const Vector3d at = seen.posture.control_point();
  const model::View view = seen.model.view();
  return {parameters,
          seen.model,
          view,
          seen.posture,
          seen.readings,
          at,
          view.nearest(at, std::numeric_limits<double>::infinity())};
}

/// From the closest surface model point; where the control point lies on it, along the segment's normal.
ClosestPoint closest_point(const Situation& now) {
  const double distance = now.closest->distance;
  if (distance > 0) return {distance, (now.at - now.closest->at) / distance};
  return {0, now.view.segment(now.closest->segment)->plane.normal};
}

/// The two sides of the current slice, as far as 2 λ to either side of the current point.
std::array<std::array<Vector3d, 2>, 2> sides_of(const Slices& slices, const model::View::Edge& edge,
                                                const Vector3d& normal, double resolution) {
  const Vector3d point = slices.current_point(edge), along = slices.vector() * (resolution / 4);
  const Vector3d across = slices.vector().cross(normal).normalized() * (2 * resolution);
  const auto side = [&](const Vector3d& at) {
    return std::array{Vector3d(at - across), Vector3d(at + across)};
  };
  return {side(point - along), side(point + along)};
}

/// At δ over what a mark is about: an edge's middle, or the point of a segment nearest to the control point.
std::optional<Vector3d> place_over(const Situation& now, const Completeness::NewMark& mark) {
  const auto edge = now.view.edge(mark.edge);
  const auto segment = now.view.segment(mark.edge && edge ? edge->segment : mark.segment);
  if (!segment) return std::nullopt;
  const double distance = now.parameters.follow_distance;
  if (mark.edge) return (edge->from + edge->to) / 2 + distance * segment->plane.normal;
  const auto nearest =
      now.view.nearest(now.at, std::numeric_limits<double>::infinity(), {.only = segment->id});
  return nearest->at + distance * segment->plane.normal;
}

class ThesisFollower final : public Follower {
 public:
  ThesisFollower(const Parameters& p, std::unique_ptr<LinkMotion> links)
      : Follower(p, std::move(links)), pursuit_(p), surface_(p) {}

  Marks marks() const override { return pursuit_.completeness.marks(); }
  Intent intent(const model::View&) const override;
  std::int64_t outcomes_asked() const override { return pursuit_.completeness.outcomes_asked(); }

 protected:
  Motion choose(const Observation& seen) override {
    const Changes changes(seen.model, seen.changes);
    const Situation now = situation(parameters(), seen);
    pursuit_.take(changes);
    pursuit_.progress.step(seen.posture);
    if (now.closest) pursuit_.completeness.came_closest(*now.closest);
    if (LinkMotion* links = judge(); links && !transit_) transit_ = internal::make_joint_transit(*links);
    if (transit_) transit_->arrive(seen);
    if (const auto on_the_way = go_on_repositioning(seen)) return *on_the_way;
    if (transit_ && pursuit_.progress.stands_still(2) && begin_elsewhere(now)) return transit_->next(seen);
    if (pursuit_.progress.stands_still(10)) return {Vector3d::Zero(), {}, mode_, End::stopped};
    for (;;) {
      const Decision decision = decide(now);
      if (begin_repositioning(now)) return transit_->next(seen);
      if (const auto* direction = std::get_if<Direction>(&decision)) return motion(now, *direction);
      if (const auto* end = std::get_if<End>(&decision)) return {Vector3d::Zero(), {}, mode_, reason(*end)};
      enter(std::get<Mode>(decision), now);
    }
  }

 private:
  std::optional<Motion> go_on_repositioning(const Observation&);
  bool begin_repositioning(const Situation&);
  bool begin_elsewhere(const Situation&);

  /// The motion modes, each of which decides on a direction or on a switch of mode (Figure 38).
  Decision decide(const Situation& now) {
    switch (mode_) {
      case Mode::current_segment:
        return segment_.follow(now, pursuit_);
      case Mode::current_edge:
        return edge_.follow(now, pursuit_);
      case Mode::point:
        return point_.follow(now, pursuit_);
      case Mode::gap:
        return gap_.follow(now, pursuit_);
      default:
        return surface_.follow(now, pursuit_);
    }
  }

  /// That nothing is left is no success where the last goals were given up because the robot cannot move.
  End reason(End end) const {
    return end == End::complete && pursuit_.progress.stands_still(1) ? End::stopped : end;
  }

  void enter(Mode mode, const Situation& now) {
    const Mode before = std::exchange(mode_, mode);
    switch (mode) {
      case Mode::current_surface:
        surface_.begin();
        break;
      case Mode::gap:
        gap_.begin(now, pursuit_, current_point(now, before), before);
        break;
      case Mode::point:
        if (before == Mode::gap)
          point_.gap_is_over(gap_.has_moved(), pursuit_);
        else
          point_.begin(now, pursuit_);
        break;
      case Mode::current_edge:
        if (before == Mode::gap) {  // it could not be closed
          pursuit_.use_slice();
          pursuit_.follow = {};
          mode_ = Mode::current_segment;
        }
        break;
      default:
        break;
    }
  }

  Vector3d current_point(const Situation& now, Mode mode) const {
    if (mode == Mode::point) return now.view.segment(pursuit_.segment)->plane.point;
    return pursuit_.slices.current_point(*now.view.edge(pursuit_.edge));
  }

  Motion motion(const Situation& now, const Direction& direction) const {
    const double step = std::min(direction.step_limit, parameters().max_step);
    return {control_point_motion(closest_point(now), parameters().follow_distance, step, direction.along),
            {},
            mode_};
  }

  Mode mode_ = Mode::current_surface;
  Pursuit pursuit_;
  CurrentSurface surface_;
  CurrentSegment segment_;
  CurrentEdge edge_;
  PointFollowing point_;
  GapFollowing gap_;
  std::unique_ptr<Transit> transit_;  ///< none: motions are not judged
  bool is_repositioning_ = false;
  std::set<geometry::EdgeId> tried_edges_;
  std::set<model::SegmentId> tried_segments_;
};

/// Once for each, what cannot be reached by following is reached, if it can be, by another way (thesis
/// §3.4.7, §5.2).
bool ThesisFollower::begin_repositioning(const Situation& now) {
  const auto marks = pursuit_.completeness.take_new_marks();
  if (!transit_) return false;
  for (const Completeness::NewMark& mark : marks) {
    const bool is_edge = static_cast<bool>(mark.edge);
    if (!(is_edge ? tried_edges_.insert(mark.edge).second : tried_segments_.insert(mark.segment).second))
      continue;
    const auto place = place_over(now, mark);
    if (!place || !transit_->begin_to(*place)) continue;
    pursuit_.completeness.take_back(mark);
    return is_repositioning_ = true;
  }
  return false;
}

/// Where the robot cannot move: to the nearest edge that is incomplete and can be reached by another way.
bool ThesisFollower::begin_elsewhere(const Situation& now) {
  constexpr int kMostTried = 8;
  std::vector<model::View::Edge> edges;
  now.view.open_edges(edges);
  std::erase_if(edges, [&](const auto& edge) {
    return pursuit_.completeness.is_complete(edge) || tried_edges_.count(edge.id) > 0;
  });
  const auto distance = [&](const auto& edge) { return ((edge.from + edge.to) / 2 - now.at).norm(); };
  std::stable_sort(edges.begin(), edges.end(),
                   [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  for (std::size_t i = 0, tried = 0; i < edges.size() && tried < kMostTried; ++i, ++tried) {
    tried_edges_.insert(edges[i].id);
    const auto place = place_over(now, {edges[i].id, {}});
    if (place && transit_->begin_to(*place)) return is_repositioning_ = true;
  }
  return false;
}

/// Arrived, or stopped for good, following begins anew from there.
std::optional<Motion> ThesisFollower::go_on_repositioning(const Observation& seen) {
  if (!transit_ || !is_repositioning_) return std::nullopt;
  if (transit_->is_under_way() && transit_->look(seen, true) == Travel::Progress::good)
    return transit_->next(seen);
  transit_->stop();
  is_repositioning_ = false;
  mode_ = Mode::current_surface;
  surface_.begin();
  pursuit_.clear_edge();
  pursuit_.follow = {};
  pursuit_.progress.restart(0);
  return std::nullopt;
}

Intent ThesisFollower::intent(const model::View& view) const {
  Intent intent;
  intent.segment = pursuit_.segment;
  intent.edge = pursuit_.edge;
  if (mode_ == Mode::current_surface) intent.way = surface_.way();
  if (mode_ == Mode::gap) intent.targets = gap_.targets();
  const auto edge = view.edge(pursuit_.edge);
  if (edge && pursuit_.slices.has_current())
    intent.slice =
        sides_of(pursuit_.slices, *edge, view.segment(edge->segment)->plane.normal, parameters().resolution);
  return intent;
}

}  // namespace

std::unique_ptr<Follower> make_thesis_follower(const Parameters& parameters,
                                               std::unique_ptr<LinkMotion> links) {
  return std::make_unique<ThesisFollower>(parameters, std::move(links));
}

}  // namespace limpet::following
