// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limits>

#include "current_surface_internal.hpp"
#include "edges_internal.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;
using model::SegmentId;
using model::View;

constexpr int kMostPaths = 3;  ///< to one segment, before it is unreachable
constexpr double kFar = std::numeric_limits<double>::infinity();

model::Which only_polygons() {
  return {.only = {}, .but = {}, .polygons = true, .points = false, .initial = true};
}
model::Which only_points() {
  return {.only = {}, .but = {}, .polygons = false, .points = true, .initial = false};
}

}  // namespace

Decision CurrentSurface::follow(const Situation& now, Pursuit& pursuit) {
  if (path_ && pursuit.progress.is_insufficient()) give_up(pursuit);
  if (!holds(now, pursuit))
    if (const auto decision = plan(now, pursuit)) return *decision;
  advance(now, pursuit);
  const bool is_last = follow_ + 1 == path_->legs.size();
  if (!is_last || distance_to(follow_, now) >= now.parameters.stray_limit) return along_follow_edge(now);
  pursuit.clear_edge();
  pursuit.follow = {};
  pursuit.any_edge = true;
  barred_.clear();
  failures_ = 0;
  return Mode::current_segment;
}

/// Is the path still as it was found, from the follow edge on, and does it lead to something to be done?
bool CurrentSurface::holds(const Situation& now, const Pursuit& pursuit) {
  if (!path_ || !pursuit.segment || pursuit.completeness.is_complete(now.view, pursuit.segment)) return false;
  for (std::size_t i = follow_; i < path_->legs.size(); ++i) {
    Path::Leg& leg = path_->legs[i];
    if (!leg.edge) continue;
    const auto edge = now.view.edge(leg.edge);
    if (!edge) return false;
    leg.from = leg.forwards ? edge->from : edge->to;
    leg.to = leg.forwards ? edge->to : edge->from;
  }
  return true;
}

void CurrentSurface::give_up(Pursuit& pursuit) {
  auto stuck = path_->legs.begin() + static_cast<std::ptrdiff_t>(follow_);
  stuck = std::find_if(stuck, path_->legs.end(), [](const Path::Leg& leg) { return bool(leg.edge); });
  barred_.insert(stuck->edge);  // the last leg is no hop
  if (++failures_ >= kMostPaths) {
    pursuit.completeness.mark_unreachable(pursuit.segment);
    barred_.clear();
    failures_ = 0;
  }
  path_.reset();
}

/// Finds a path; or decides what else to do if there is none to be found.
std::optional<Decision> CurrentSurface::plan(const Situation& now, Pursuit& pursuit) {
  path_.reset();
  follow_ = 0;
  for (const bool surely : {false, true}) {
    pursuit.completeness.ask_what_would_close(now.model, surely);
    if (!find_path(now, pursuit)) continue;
    pursuit.progress.restart(way_along_follow_edge(now));
    return std::nullopt;
  }
  pursuit.segment = stray_point(now);
  if (pursuit.segment) return Decision(Mode::point);
  return Decision(now.closest ? End::complete : End::no_surface);
}

bool CurrentSurface::find_path(const Situation& now, Pursuit& pursuit) {
  for (auto wanted = goals(now, pursuit); !wanted.empty(); wanted = goals(now, pursuit)) {
    path_ = shortest_path(now.view, now.at, wanted, barred_, 2 * now.parameters.resolution);
    if (!path_) {
      for (const SegmentId goal : wanted) pursuit.completeness.mark_unreachable(goal);
      continue;
    }
    if (path_->goal != pursuit.segment) failures_ = 0;
    pursuit.segment = path_->goal;
    const Path::Leg& last = path_->legs.back();
    if (pursuit.goal_places.visit((last.from + last.to) / 2)) return true;
    pursuit.completeness.mark_unreachable(path_->goal);
  }
  return false;
}

/// The incomplete polygons of the current surface; if there are none, those of all surfaces. Ascending.
std::vector<SegmentId> CurrentSurface::goals(const Situation& now, const Pursuit& pursuit) const {
  std::vector<SegmentId> all, here;
  now.view.segments(all, only_polygons());
  std::erase_if(all, [&](SegmentId id) { return pursuit.completeness.is_complete(now.view, id); });
  const SegmentId member = pursuit.segment ? pursuit.segment
                           : now.closest   ? now.closest->segment
                                           : SegmentId{};
  std::copy_if(all.begin(), all.end(), std::back_inserter(here),
               [&](SegmentId id) { return now.view.same_surface(id, member); });
  return here.empty() ? all : here;
}

/// The nearest point segment that has not been tried, and is not beside a polygon, of which its points would
/// become part when more is known.
SegmentId CurrentSurface::stray_point(const Situation& now) {
  std::vector<SegmentId> points;
  now.view.segments(points, only_points());
  SegmentId best;
  Vector3d place = Vector3d::Zero();
  double least = kFar;
  for (const SegmentId id : points) {
    const Vector3d at = now.view.segment(id)->plane.point;
    const double d = (at - now.at).norm();
    if (d >= least || point_places_.is_worn(at)) continue;
    if (now.view.nearest(at, now.parameters.resolution, only_polygons())) continue;
    best = id, place = at, least = d;
  }
  if (best) point_places_.visit(place);
  return best;
}

double CurrentSurface::distance_to(std::size_t i, const Situation& now) const {
  const Path::Leg& leg = path_->legs[i];
  return (nearest_on(leg.from, leg.to, now.at) - now.at).norm();
}

/// To the follow edge and along it.
double CurrentSurface::way_along_follow_edge(const Situation& now) const {
  const Path::Leg& leg = path_->legs[follow_];
  return distance_to(follow_, now) + (leg.to - leg.from).norm();
}

std::vector<Vector3d> CurrentSurface::way() const {
  std::vector<Vector3d> places;
  for (std::size_t i = follow_; path_ && i < path_->legs.size(); ++i) {
    if (places.empty() || places.back() != path_->legs[i].from) places.push_back(path_->legs[i].from);
    places.push_back(path_->legs[i].to);
  }
  return places;
}

/// The follow edge becomes the one farthest along the path that is within ρ.
void CurrentSurface::advance(const Situation& now, Pursuit& pursuit) {
  for (std::size_t i = path_->legs.size(); i-- > follow_ + 1;) {
    if (distance_to(i, now) >= now.parameters.stray_limit) continue;
    follow_ = i;
    pursuit.progress.restart(way_along_follow_edge(now));
    return;
  }
}

Direction CurrentSurface::along_follow_edge(const Situation& now) const {
  const Path::Leg& leg = path_->legs[follow_];
  if (const auto edge = now.view.edge(leg.edge)) {
    const auto partner = now.view.edge(edge->partner);
    for (const SegmentId id : {edge->segment, partner ? partner->segment : SegmentId{}})
      if (const auto out = towards_outside(now.view, id, now.at)) return {*out};
  }
  return {towards_and_along(leg.from, leg.to, now.at, now.parameters)};
}

}  // namespace limpet::following::internal
