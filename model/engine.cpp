// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

void require(bool good, const char* what) {
  if (!good) throw std::invalid_argument(what);
}

}  // namespace

Engine::Engine(const Parameters& p) : parameters(p) {
  const auto finite = [](double x) { return std::isfinite(x); };
  require(finite(p.resolution) && p.resolution > 0, "the linear resolution must be a length greater than 0");
  require(finite(p.angle_rad) && p.angle_rad > 0 && p.angle_rad < 1.5707,
          "the angular resolution must lie between 0 and 90 degrees");
  require(finite(p.noise) && p.noise >= 0, "the noise must be a length of 0 or more");
  require(finite(p.noise_per_range) && p.noise_per_range >= 0 && finite(p.noise_per_range2) &&
              p.noise_per_range2 >= 0,
          "what the noise grows by with the range must be 0 or more");
  require(finite(p.tolerance) && p.tolerance >= 0, "the tolerance must be a length of 0 or more");
  require(finite(p.input_quantum) && p.input_quantum >= 0, "the input quantum must be a length of 0 or more");
  require(p.resolution > 1e-150 && p.resolution < 1e150, "the linear resolution is out of range");
  points = SpatialIndex(2.6 * p.resolution);  // their boxes are 2.5 λ wide
  polygons = SpatialIndex(8 * p.resolution);  // those of the smallest
  step = geometry::grid_step_for(p.resolution);
  rounding = step * step + p.input_quantum * p.input_quantum;
  gap = p.resolution / step;
  cos_angle = cosine(p.angle_rad);
  sin_angle = std::sqrt(1 - cos_angle * cos_angle);
}

Segment* Engine::find(SegmentId id) {
  const auto entry = slot_of.find(id.value);
  return entry == slot_of.end() ? nullptr : segments[entry->second].get();
}

Box3 box_around(const Eigen::Vector3d& p, double reach) {
  return {p - Eigen::Vector3d::Constant(reach), p + Eigen::Vector3d::Constant(reach)};
}

Segment& new_segment(Engine& e) {
  std::uint32_t slot = 0;
  if (e.free_slots.empty()) {
    slot = static_cast<std::uint32_t>(e.segments.size());
    e.segments.emplace_back();
  } else {
    slot = e.free_slots.back();
    e.free_slots.pop_back();
  }
  e.segments[slot] = std::make_unique<Segment>();
  Segment& s = *e.segments[slot];
  s.id = {e.next_segment++};
  s.slot = slot;
  e.slot_of[s.id.value] = slot;
  return s;
}

Segment& create_point_segment(Engine& e, const RawPoint& raw) {
  Segment& s = new_segment(e);
  s.moments = Moments(raw.at);
  s.axis_sum = raw.axis;
  s.variance_sum = raw.variance;
  s.raw = {raw};
  if (raw.since < 0) s.raw.front().since = e.counts.points;
  s.since_sum = static_cast<double>(s.raw.front().since);
  s.fit = fit_to(s.moments, e.step, s.axis_sum);
  s.last_joined = e.counts.points;
  e.by_age.emplace_back(s.last_joined, s.id);
  set_label(e, raw, s.id);
  mark_modified(e, s);
  e.changes.push_back({Change::Kind::created, {}, {}, s.id, {}});
  return s;
}

bool may_be_young(const Engine& e, std::int64_t count, const Fit& fit) {
  if (count <= kYoung || count > kMostYoung) return count <= kYoung;
  const double lambda2 = e.parameters.resolution * e.parameters.resolution;
  return 12 * std::sqrt(fit.u1 * fit.u2) < kYoungArea * lambda2;  // a rectangle with these variances
}

namespace {

SpatialIndex& index_of(Engine& e, const Segment& s) { return s.indexed_as_polygon ? e.polygons : e.points; }

void remove_from_index(Engine& e, Segment& s) {
  if (!s.indexed.isEmpty()) index_of(e, s).remove(s.indexed, s.slot);
  s.indexed.setEmpty();
}

}  // namespace

void erase_segment(Engine& e, Segment& s) {
  const std::uint32_t slot = s.slot;
  if (s.polygon) dissolve_all_neighbours(e, s);
  remove_from_index(e, s);
  e.slot_of.erase(s.id.value);
  if (s.polygon) e.modelled_area -= s.polygon->counted_area, e.modelled_points -= s.moments.count();
  e.segments[slot].reset();
  e.free_slots.push_back(slot);
}

void mark_modified(Engine& e, Segment& s) {
  if (s.modified) return;
  s.modified = true;
  e.modified.push_back(s.slot);
  if (e.parameters.neighbours) e.to_share.push_back(s.slot);
}

void update_index(Engine& e, Segment& s) {
  // Boxes are larger by λ than what they hold, and by some slack more, so that most growth leaves the index
  // alone.
  const double reach = e.parameters.resolution;
  const Box3 tight = s.polygon ? s.polygon->box : box_around(s.fit.centroid, 0);
  const Box3 needed(tight.min() - Eigen::Vector3d::Constant(reach),
                    tight.max() + Eigen::Vector3d::Constant(reach));
  if (s.indexed_as_polygon == (s.polygon != nullptr) && !s.indexed.isEmpty() && s.indexed.contains(needed))
    return;
  remove_from_index(e, s);
  const double slack = s.polygon ? reach + 0.1 * tight.sizes().maxCoeff() : reach / 4;
  s.indexed =
      Box3(needed.min() - Eigen::Vector3d::Constant(slack), needed.max() + Eigen::Vector3d::Constant(slack));
  s.indexed_as_polygon = s.polygon != nullptr;
  index_of(e, s).insert(s.indexed, s.slot);
}

Box3 perimeter_box(const PolygonPart& part) {
  Box3 box;
  for (std::uint32_t i = 0; i < part.perimeter.slot_count(); ++i) {
    const geometry::Slot s{i};
    if (!part.perimeter.alive(s)) continue;
    const geometry::Point2 p = part.perimeter.at(s);
    box.extend(part.chart.at(p, part.published(p)));
  }
  return box;
}

void count_area(Engine& e, PolygonPart& part) {
  const double area = part.perimeter.area() / (e.gap * e.gap);
  e.modelled_area += area - part.counted_area;
  part.counted_area = area;
}

void description_changed(Engine& e, Segment& s, const Places& where) {
  ++s.polygon->shape;
  if (!s.initial()) count_area(e, *s.polygon);
  s.polygon->changed.add(where);
  if (e.parameters.neighbours && (e.finishing || !s.young())) s.polygon->unshared.add(where);
  mark_modified(e, s);
}

Turn polygons_near(Engine& e, const Places& places, std::uint32_t but) {
  query(e.polygons, places, e.found);
  Turn near;
  for (const std::uint32_t slot : e.found)
    if (slot != but && e.at(slot).polygon) near.emplace_back(e.at(slot).id, slot);
  std::sort(near.begin(), near.end());
  return near;
}

void set_label(Engine& e, const RawPoint& raw, SegmentId id) {
  if (e.labels_kept && raw.serial >= 0) e.labels[static_cast<std::size_t>(raw.serial)] = id.value;
}

void forward_label(Engine& e, SegmentId from, SegmentId to) {
  if (e.labels_kept && from != to) e.label_goes_to[from.value] = to.value;
}

void settle_labels(Engine& e) {
  auto& goes_to = e.label_goes_to;
  const auto end_of = [&](std::uint64_t id) {
    std::uint64_t last = id;
    for (auto next = goes_to.find(id); next != goes_to.end(); next = goes_to.find(last)) last = next->second;
    while (id != last) id = std::exchange(goes_to.at(id), last);  // the next one has a shorter way
    return e.slot_of.count(last) ? last : 0;
  };
  std::uint64_t before = 0, settled = 0;  // points in a row are often in one segment
  for (std::uint64_t& label : e.labels) {
    if (label != before) before = label, settled = end_of(label);
    label = settled;
  }
  goes_to.clear();
}

}  // namespace limpet::model::internal
