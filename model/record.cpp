// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/model/record.hpp>

#include <algorithm>
#include <stdexcept>

#include <limpet/geometry/predicates.hpp>

#include "engine_internal.hpp"

namespace limpet::model::internal {
namespace {

std::vector<RawPointRecord> raw_records(const Segment& s) {
  std::vector<RawPointRecord> records;
  for (const RawPoint& r : s.raw) records.push_back({r.at, r.axis, r.returned});
  return records;
}

PointSegmentRecord point_record(const Segment& s) {
  return {s.id.value, s.moments.record(), s.axis_sum, raw_records(s), 0};
}

PolygonSegmentRecord polygon_record(const Engine& e, const Segment& s) {
  const PolygonPart& part = *s.polygon;
  PolygonSegmentRecord r;
  r.id = s.id.value;
  r.moments = s.moments.record();
  r.axis_sum = s.axis_sum;
  r.chart_origin = part.chart.origin();
  r.chart_u = part.chart.u();
  r.chart_v = part.chart.v();
  r.chart_normal = part.chart.normal();
  r.height = {part.published.h0, part.published.hx, part.published.hy};
  r.initial_centroid = part.initial.point;
  r.initial_normal = part.initial.normal;
  for (const auto& cycle : part.perimeter.boundary()) {
    auto& vertices = r.cycles.emplace_back();
    for (const auto& v : cycle)
      vertices.push_back(
          {v.at.x, v.at.y, v.edge.value, v.shared ? e.shared.at(v.edge.value).partner.value : 0});
  }
  r.raw = raw_records(s);
  return r;
}

Segment& segment_from(Engine& e, std::uint64_t id, const MomentsRecord& moments,
                      const Eigen::Vector3d& axis_sum, double variance_sum,
                      const std::vector<RawPointRecord>& raw) {
  const auto slot = static_cast<std::uint32_t>(e.segments.size());
  e.segments.push_back(std::make_unique<Segment>());
  Segment& s = *e.segments.back();
  s.id = {id};
  s.slot = slot;
  s.moments = Moments(moments);
  s.axis_sum = axis_sum;
  s.variance_sum = e.noise_grows() ? variance_sum : e.variance_at(0) * static_cast<double>(s.moments.count());
  for (const RawPointRecord& r : raw)
    s.raw.push_back({r.at, r.axis, s.variance(), r.returned, e.counts.points, -1});
  s.last_joined = e.counts.points;
  s.since_sum = static_cast<double>(e.counts.points) * static_cast<double>(s.moments.count());
  e.slot_of[id] = slot;
  return s;
}

/// The copies of shared edges on this segment.
void shared_from(Engine& e, Segment& s, const PolygonSegmentRecord& r) {
  std::unordered_map<std::uint64_t, std::uint64_t> partner;
  for (const auto& cycle : r.cycles)
    for (const VertexRecord& v : cycle)
      if (v.partner != 0) partner[v.edge] = v.partner;
  PolygonPart& part = *s.polygon;
  for (std::uint32_t i = 0; i < part.perimeter.slot_count(); ++i) {
    const auto& node = part.perimeter.node(geometry::Slot{i});
    if (!node.edge || !node.shared) continue;
    e.shared[node.edge.value] = {s.slot, geometry::Slot{i}, {partner.at(node.edge.value)}};
    part.shared.push_back(node.edge);
  }
  std::sort(part.shared.begin(), part.shared.end());
}

void require_partners(const Engine& e) {
  for (const auto& [edge, entry] : e.shared) {
    const auto partner = e.shared.find(entry.partner.value);
    if (partner == e.shared.end() || partner->second.partner.value != edge ||
        partner->second.segment == entry.segment)
      throw std::invalid_argument("shared edge " + std::to_string(edge) +
                                  " has no partner on another segment");
  }
}

void polygon_from(Engine& e, const PolygonSegmentRecord& r) {
  Segment& s = segment_from(e, r.id, r.moments, r.axis_sum, r.variance_sum, r.raw);
  s.polygon = std::make_unique<PolygonPart>();
  PolygonPart& part = *s.polygon;
  part.chart = geometry::Chart(r.chart_origin, r.chart_u, r.chart_v, r.chart_normal, e.step);
  part.published.h0 = r.height[0], part.published.hx = r.height[1], part.published.hy = r.height[2];
  part.outward = part.published.plane(part.chart).normal;
  part.initial = {r.initial_centroid, r.initial_normal};
  std::vector<std::vector<geometry::NewVertex>> cycles;
  for (const auto& cycle : r.cycles) {
    auto& vertices = cycles.emplace_back();
    for (const VertexRecord& v : cycle) vertices.push_back({{v.x, v.y}, {v.edge}, v.partner != 0});
  }
  auto perimeter = geometry::Polygon::from_cycles(cycles, e.edge_ids);
  if (!perimeter)
    throw std::invalid_argument("the perimeter of segment " + std::to_string(r.id) +
                                " is not a valid polygon");
  part.perimeter = std::move(*perimeter);
  part.perimeter.take_created();
  shared_from(e, s, r);
  part.box = perimeter_box(part);
  e.modelled_points += s.moments.count();
  if (s.initial()) {
    s.fit.centroid = part.plane().point, s.fit.normal = part.plane().normal;
  } else {
    count_area(e, part);
    s.fit = fit_to(s.moments, e.step, -part.plane().normal);
  }
  s.next_fit = s.moments.count() + 1 + s.moments.count() / 32;
  update_index(e, s);
}

}  // namespace

ModelRecord to_record(const Engine& e) {
  ModelRecord r;
  r.parameters = e.parameters;
  r.grid_step = e.step;
  r.arithmetic = geometry::arithmetic();
  r.points = e.counts.points;
  r.refused = e.counts.refused;
  r.expired = e.counts.expired;
  r.sets = e.counts.sets;
  r.redundant_by_count = e.counts.redundant_by_count;
  r.redundant_by_position = e.counts.redundant_by_position;
  r.next_segment = e.next_segment;
  r.next_edge = e.edge_ids.next();
  for (const auto& s : e.segments) {
    if (!s) continue;
    if (s->polygon)
      r.polygon_segments.push_back(polygon_record(e, *s));
    else
      r.point_segments.push_back(point_record(*s));
    if (e.noise_grows())
      (s->polygon ? r.polygon_segments.back().variance_sum : r.point_segments.back().variance_sum) =
          s->variance_sum;
  }
  const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
  std::sort(r.point_segments.begin(), r.point_segments.end(), by_id);
  std::sort(r.polygon_segments.begin(), r.polygon_segments.end(), by_id);
  return r;
}

void from_record(Engine& e, const ModelRecord& r) {
  e.counts.points = r.points;
  e.counts.refused = r.refused;
  e.counts.expired = r.expired;
  e.counts.sets = r.sets;
  e.counts.redundant_by_count = r.redundant_by_count;
  e.counts.redundant_by_position = r.redundant_by_position;
  e.next_segment = r.next_segment;
  e.edge_ids = geometry::EdgeIds(r.next_edge);
  for (const PointSegmentRecord& p : r.point_segments) {
    Segment& s = segment_from(e, p.id, p.moments, p.axis_sum, p.variance_sum, p.raw);
    s.fit = fit_to(s.moments, e.step, s.axis_sum);
    e.by_age.emplace_back(s.last_joined, s.id);
    update_index(e, s);
  }
  for (const PolygonSegmentRecord& p : r.polygon_segments) polygon_from(e, p);
  require_partners(e);
  list_all_pairs(e);
}

}  // namespace limpet::model::internal
