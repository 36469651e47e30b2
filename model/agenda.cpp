// Copyright the limpet authors. GPL-3.0-or-later.
#include "agenda_internal.hpp"

namespace limpet::model::internal {

void Agenda::opened(std::uint32_t slot) {
  if (slot >= due_.size()) due_.resize(slot + std::size_t{1});
  due_[slot] = {};
}

void Agenda::became_polygon(std::uint32_t slot) { due_[slot].polygon = std::make_unique<PolygonDue>(); }

void Agenda::list_modified(std::uint32_t slot) {
  modified_.push_back(slot);
  if (neighbours_) to_share_.push_back(slot);
}

void Agenda::clear_modified() {
  for (const std::uint32_t slot : modified_) due_[slot].modified = false;
  modified_.clear();
}

void Agenda::description_changed(std::uint32_t slot, const DirtyRegion& where, bool young) {
  polygon(slot).changed.add(where);
  if (finishing || !young) look_for_neighbours(slot, where);
  mark_modified(slot);
}

const std::vector<std::uint32_t>& Agenda::take_to_share() {
  for (int i = 0; i < kWaitingSeen && !share_later_.empty(); ++i) {
    const std::uint32_t slot = share_later_.front();
    share_later_.pop_front();
    to_share_.push_back(slot);
    if (due_[slot].polygon) polygon(slot).shared_later = false;
  }
  taken_.clear();
  std::swap(taken_, to_share_);
  return taken_;
}

void Agenda::wait_to_share(std::uint32_t slot) {
  if (!std::exchange(polygon(slot).shared_later, true)) share_later_.push_back(slot);
}

/// Pairs take turns in the order of their slots, so that none waits for ever.
std::pair<SlotPair, DirtyRegion> Agenda::take_look() {
  auto next = looks_due_.upper_bound(last_look_);
  if (next == looks_due_.end()) next = looks_due_.begin();
  last_look_ = next->first;
  return {next->first, std::move(looks_due_.extract(next).mapped())};
}

/// A large polygon calls for many looks at once; they are spread over the sets, by the number of points that
/// have come.
std::int64_t Agenda::looks_for(std::int64_t points) {
  return kFewestLooks + (points - std::exchange(looked_at_, points)) / kPointsPerLook;
}

void Agenda::remember_refusal(SegmentPair pair, std::pair<std::uint64_t, std::uint64_t> shapes) {
  refused_[pair] = shapes;
}

bool Agenda::remembered_as_refused(SegmentPair pair, std::pair<std::uint64_t, std::uint64_t> shapes) const {
  const auto found = refused_.find(pair);
  return found != refused_.end() && found->second == shapes;
}

std::optional<std::pair<std::int64_t, SegmentId>> Agenda::take_aged(std::int64_t before) {
  if (by_age_.empty() || by_age_.front().first >= before) return std::nullopt;
  const auto aged = by_age_.front();
  by_age_.pop_front();
  return aged;
}

}  // namespace limpet::model::internal
