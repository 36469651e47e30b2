// Copyright the limpet authors. GPL-3.0-or-later.
#include "segment_table_internal.hpp"

namespace limpet::model::internal {

SegmentTable::SegmentTable(const Setting& setting)
    : polygons_(8 * setting.least.lambda),    // boxes are 4 λ and 1.2 times the polygon wide (reindex())
      points_(2.6 * setting.least.lambda) {}  // boxes are 2.5 λ wide

const Segment* SegmentTable::find(SegmentId id) const {
  const auto entry = slot_of_.find(id.value);
  return entry == slot_of_.end() ? nullptr : segments_[entry->second].get();
}

Segment& SegmentTable::create() {
  std::uint32_t slot = 0;
  if (free_.empty()) {
    slot = slot_count();
    segments_.emplace_back();
  } else {
    slot = free_.back();
    free_.pop_back();
  }
  segments_[slot] = std::make_unique<Segment>();
  Segment& s = *segments_[slot];
  s.id = {next_id_++};
  s.slot = slot;
  slot_of_[s.id.value] = slot;
  return s;
}

void SegmentTable::remove_from_index(Segment& s) {
  if (!s.indexed.isEmpty()) index_of(s).remove(s.indexed, s.slot);
  s.indexed.setEmpty();
}

void SegmentTable::erase(Segment& s) {
  const std::uint32_t slot = s.slot;
  remove_from_index(s);
  slot_of_.erase(s.id.value);
  segments_[slot].reset();
  free_.push_back(slot);
}

void SegmentTable::rename(Segment& s) {
  slot_of_.erase(s.id.value);
  s.id = {next_id_++};
  slot_of_[s.id.value] = s.slot;
}

void SegmentTable::reindex(const Setting& setting, Segment& s) {
  // Boxes reach λ beyond their segments, and some slack more, so that most growth leaves the index alone.
  const Box3 tight = s.polygon ? s.polygon->box : box_around(s.fit.centroid, 0);
  const double reach = setting.largest_scale(tight).lambda;
  const Box3 needed(tight.min() - Eigen::Vector3d::Constant(reach),
                    tight.max() + Eigen::Vector3d::Constant(reach));
  if (s.indexed_as_polygon == bool(s.polygon) && !s.indexed.isEmpty() && s.indexed.contains(needed)) return;
  remove_from_index(s);
  const double slack = s.polygon ? reach + 0.1 * tight.sizes().maxCoeff() : reach / 4;
  s.indexed =
      Box3(needed.min() - Eigen::Vector3d::Constant(slack), needed.max() + Eigen::Vector3d::Constant(slack));
  s.indexed_as_polygon = bool(s.polygon);
  index_of(s).insert(s.indexed, s.slot);
}

}  // namespace limpet::model::internal
