// Copyright the limpet authors. GPL-3.0-or-later.
#include "targets_internal.hpp"

#include <array>
#include <cmath>

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;
using model::View;

constexpr double kFirst = 0.85;  ///< λ outside an open edge

/// Rotations about an open edge, towards the inside.
struct Fold {
  double cosine, sine;
};
constexpr double kHalf = 0.70710678118654752;
constexpr std::array<Fold, 3> kFolds = {Fold{kHalf, kHalf}, Fold{0, 1}, Fold{-kHalf, kHalf}};

}  // namespace

bool TargetFinder::is_open(const Vector3d& at, const Vector3d& normal) const {
  const auto tries = memory_.at(at, normal);
  return !tries.is_empty() && !tries.is_given_up();
}

/// Is the place on the far side of another polygon's plane, or on a polygon? Where two planes meet, an edge
/// is to be shared, and what lies beyond the line is not of this surface.
bool TargetFinder::is_cut_off(const View& view, const OpenPart& part, const Vector3d& normal,
                              const Vector3d& place) const {
  constexpr double kKnown = 0.4, kSamePlane = 0.98;
  const Vector3d inside = part.middle();
  for (std::size_t i = 0; i < others_.size(); ++i) {
    const geometry::Plane& plane = planes_[i].plane;
    if (normal.dot(plane.normal) > kSamePlane) {
      if (view.nearest(place, kKnown * lambda_, {.only = others_[i].segment})) return true;
      continue;
    }
    const double here = plane.height_of(inside), there = plane.height_of(place);
    if (here * there <= 0 || std::abs(there) < 0.1 * lambda_) {
      if (view.nearest(place, 1.2 * lambda_, {.only = others_[i].segment})) return true;
    }
  }
  return false;
}

PartState TargetFinder::add_folded(const View& view, const OpenPart& part, const Border& border,
                                   Outlook& outlook) const {
  PartState state = PartState::unclosable;
  for (const Fold& fold : kFolds) {
    const Vector3d way = fold.cosine * border.outward - fold.sine * border.normal;
    const Vector3d at = part.middle() + kFirst * lambda_ * way;
    const Vector3d facing = fold.cosine * border.normal + fold.sine * border.outward;
    if (view.nearest(at, 0.5 * lambda_, {.but = part.segment, .points = false})) return PartState::done;
    const auto tries = memory_.at(at, facing);
    if (tries.is_blocked()) state = PartState::unreachable;
    if (tries.is_empty() || tries.is_given_up()) continue;
    outlook.targets.push_back({at, facing, 1});
    outlook.suspected.push_back(at);
    return PartState::wanted;
  }
  return state;
}

PartState TargetFinder::add(const View& view, const OpenPart& part, Outlook& outlook) {
  const auto segment = view.segment(part.segment);
  if (!segment) return PartState::done;
  const Vector3d normal = segment->plane.normal;
  const Vector3d outward = (part.to - part.from).cross(normal).normalized();
  if (!outward.allFinite() || outward.isZero()) return PartState::done;
  Border border{part.from, part.to, outward, normal, false};
  const PartState state = part.closes ? PartState::done : add_targets(view, part, border, outlook);
  outlook.borders.push_back(border);
  // A polygon stops short of the true edge.
  outlook.suspected.push_back(part.middle() + (border.goes_on ? kFirst : kFirst / 2) * lambda_ * outward);
  return state;
}

PartState TargetFinder::add_targets(const View& view, const OpenPart& part, Border& border,
                                    Outlook& outlook) {
  const Vector3d normal = border.normal;
  const Vector3d middle = part.middle(), first = middle + kFirst * lambda_ * border.outward;
  if (part.insist) return insist(part, border, outlook.targets);
  if (view.nearest(first, 0.4 * lambda_, {.only = part.segment}))
    return PartState::done;  // in a narrow inlet
  view.nearest(first, 1.5 * lambda_, others_, {.but = part.segment, .points = false});
  planes_.clear();
  for (const auto& other : others_) planes_.push_back(*view.segment(other.segment));
  if (is_cut_off(view, part, normal, first)) return PartState::done;

  const auto tries = memory_.at(first, normal);
  if (tries.is_empty()) return add_folded(view, part, border, outlook);
  if (tries.is_given_up()) return tries.is_blocked() ? PartState::unreachable : PartState::unclosable;
  border.goes_on = true;
  outlook.targets.push_back({first, normal, 1});
  return PartState::wanted;
}

/// Places on the edge and close outside it, whatever is known there.
PartState TargetFinder::insist(const OpenPart& part, const Border& border,
                               std::vector<Target>& targets) const {
  PartState state = PartState::unclosable;
  for (const double off : {0.4, 0.0, 0.85}) {
    const Vector3d at = part.middle() + off * lambda_ * border.outward;
    const auto tries = memory_.at(at, border.normal);
    if (tries.is_blocked()) state = PartState::unreachable;
    if (tries.is_empty() || tries.is_given_up()) continue;
    targets.push_back({at, border.normal, 0.9});
    return PartState::wanted;
  }
  return state;
}

void TargetFinder::add_around_point(const View& view, const Vector3d& point, const Vector3d& viewpoint,
                                    std::vector<Target>& targets) const {
  if (view.nearest(point, lambda_, {.points = false})) return;
  const Vector3d normal = (viewpoint - point).normalized();
  if (normal.isZero()) return;
  const Vector3d along = normal.unitOrthogonal(), across = normal.cross(along);
  for (const Vector3d& way : {along, across, Vector3d(-along), Vector3d(-across)}) {
    const Vector3d at = point + 0.5 * lambda_ * way;
    if (is_open(at, normal)) targets.push_back({at, normal, 0.5});
  }
}

}  // namespace limpet::following::internal
