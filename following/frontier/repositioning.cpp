// Copyright the limpet authors. GPL-3.0-or-later.
#include "repositioning_internal.hpp"

#include <algorithm>

#include "empty_rays_internal.hpp"

namespace limpet::following::internal {

using Eigen::Vector3d;

bool Repositioning::begin(const Observation& seen, Transit& transit, const std::vector<Target>& near) {
  const model::View view = seen.model.view();
  for (const OpenPart& part : open_.left(seen.posture.control_point(), view)) {
    memory_.forget_blocked(part.middle(), parameters_.resolution);
    Outlook there;
    const PartState state = finder_.add(view, part, there);
    if (state == PartState::wanted && begin_to_see(there.targets.back(), transit)) return true;
    open_.set(part, state == PartState::wanted ? PartState::unreachable : state);
  }
  return std::any_of(near.begin(), near.end(), [&](const Target& t) { return begin_to_see(t, transit); });
}

bool Repositioning::was_tried(const Target& target) const {
  constexpr int kTries = 3;
  constexpr double kTogether = 0.6, kSameWay = 0.9;  // λ; cosine
  int tries = 0;
  tried_.for_each_within(target.at, kTogether * parameters_.resolution,
                         [&](const Vector3d&, const Vector3d& normal) {
                           if (normal.dot(target.normal) > kSameWay) ++tries;
                         });
  return tries >= kTries;
}

bool Repositioning::begin_to_see(const Target& target, Transit& transit) {
  const bool was_tried = this->was_tried(target);
  if (!was_tried) tried_.put(target.at, target.normal);
  if (was_tried || !transit.begin_to_see({target.at, target.normal})) {
    memory_.note_out_of_reach(target.at, target.normal);
    return false;
  }
  sought_ = target;
  return true;
}

void Repositioning::arrived(const Observation& seen) {
  const double lambda = parameters_.resolution;
  const model::View view = seen.model.view();
  note_empty({*sought_}, free_rays(seen, lambda), lambda, memory_);
  memory_.forget_blocked(seen.posture.control_point(), parameters_.sensing_range);
  open_.near(sought_->at, 2 * lambda, view, parts_);
  Outlook there;
  for (const OpenPart& part : parts_)
    if (const PartState state = finder_.add(view, part, there); !part.closes) open_.set(part, state);
  sought_.reset();
}

}  // namespace limpet::following::internal
