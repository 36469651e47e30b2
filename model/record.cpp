// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/model/record.hpp>

#include <algorithm>
#include <map>
#include <stdexcept>

#include <limpet/geometry/predicates.hpp>

#include "common_line_internal.hpp"
#include "record_internal.hpp"
#include "storage_internal.hpp"

namespace limpet::model::internal {
namespace {

std::vector<RawPointRecord> raw_records(const Segment& s) {
  std::vector<RawPointRecord> records;
  for (const RawPoint& r : s.data.raw()) records.push_back({r.at, r.axis, r.returned});
  return records;
}

PointSegmentRecord point_record(const Segment& s) {
  return {s.id.value, s.data.moments().record(), s.data.axis_sum(), raw_records(s), 0};
}

PolygonSegmentRecord polygon_record(const Complex& complex, const Segment& s) {
  const PolygonPart& part = *s.polygon;
  PolygonSegmentRecord r;
  r.id = s.id.value;
  r.moments = s.data.moments().record();
  r.axis_sum = s.data.axis_sum();
  r.chart_origin = part.chart.origin();
  r.chart_u = part.chart.u();
  r.chart_v = part.chart.v();
  r.chart_normal = part.chart.normal();
  r.height = {part.published.h0, part.published.hx, part.published.hy};
  r.initial_centroid = part.initial.point;
  r.initial_normal = part.initial.normal;
  r.confirmed = part.confirmed;
  for (const auto& cycle : part.perimeter.boundary()) {
    auto& vertices = r.cycles.emplace_back();
    for (const auto& v : cycle)
      vertices.push_back(
          {v.at.x, v.at.y, v.edge.value, v.shared ? complex.edges().at(v.edge).partner.value : 0});
  }
  r.raw = raw_records(s);
  return r;
}

Segment& segment_from(Engine& e, std::uint64_t id, const MomentsRecord& moments,
                      const Eigen::Vector3d& axis_sum, double variance_sum,
                      const std::vector<RawPointRecord>& raw) {
  Segment* s = Storage::add_segment(e.complex, e.agenda, {id});
  if (!s) throw std::invalid_argument("segment " + std::to_string(id) + " is there twice");
  const std::int64_t now = e.complex.now();
  SegmentData::Sums sums{Moments(moments), axis_sum, variance_sum, 0};
  if (!e.setting.noise_grows()) sums.variance = e.setting.variance_at(0) * sums.count();
  sums.since = static_cast<double>(now) * sums.count();
  const double variance = sums.variance / std::max(sums.count(), 1.0);
  std::vector<RawPoint> points;
  for (const RawPointRecord& r : raw) points.push_back({r.at, r.axis, variance, r.returned, now, -1});
  s->data = Storage::data(sums, std::move(points), now);
  return *s;
}

void polygon_from(Engine& e, const PolygonSegmentRecord& r) {
  Segment& s = segment_from(e, r.id, r.moments, r.axis_sum, r.variance_sum, r.raw);
  s.polygon = std::make_unique<PolygonPart>();
  PolygonPart& part = *s.polygon;
  part.chart = geometry::Chart(r.chart_origin, r.chart_u, r.chart_v, r.chart_normal, e.setting.step);
  part.published.h0 = r.height[0], part.published.hx = r.height[1], part.published.hy = r.height[2];
  part.outward = part.published.plane(part.chart).normal;
  part.initial = {r.initial_centroid, r.initial_normal};
  part.confirmed = r.confirmed;
  if (r.confirmed > 0 && !s.initial())
    throw std::invalid_argument("segment " + std::to_string(r.id) + " is confirmed, but not an initial one");
  std::vector<std::vector<geometry::NewVertex>> cycles;
  for (const auto& cycle : r.cycles) {
    auto& vertices = cycles.emplace_back();
    for (const VertexRecord& v : cycle) vertices.push_back({{v.x, v.y}, {v.edge}, v.partner != 0});
  }
  auto perimeter = geometry::Polygon::from_cycles(cycles, e.complex.edge_ids());
  if (!perimeter)
    throw std::invalid_argument("the perimeter of segment " + std::to_string(r.id) +
                                " is not a valid polygon");
  part.perimeter = std::move(*perimeter);
  part.box = perimeter_box(part);
  Storage::book_polygon(e.complex, s);
  if (s.initial())
    s.fit.centroid = part.plane().point, s.fit.normal = part.plane().normal;
  else
    s.fit = fit_to(s.data.moments(), e.setting.step, -part.plane().normal);
  s.next_fit = s.count() + 1 + s.count() / kGrowthPart;
  Storage::reindex(e.complex, s);
}

std::map<geometry::EdgeId, geometry::EdgeId> partners_in(const ModelRecord& r) {
  std::map<geometry::EdgeId, geometry::EdgeId> partners;
  for (const PolygonSegmentRecord& p : r.polygon_segments)
    for (const auto& cycle : p.cycles)
      for (const VertexRecord& v : cycle)
        if (v.partner != 0) partners[{v.edge}] = {v.partner};
  return partners;
}

/// What the rings of corners rely on: shared edges lie on lines where planes meet.
void require_lines(const Complex& complex, const ModelRecord& r) {
  for (const PolygonSegmentRecord& p : r.polygon_segments)
    for (const auto& cycle : p.cycles)
      for (const VertexRecord& v : cycle) {
        if (v.partner == 0) continue;
        const PolygonPart& part = *complex.find({p.id})->polygon;
        const PolygonPart& across = *complex.at(complex.edges().across({v.edge}).segment).polygon;
        if (!common_line(part.plane(), across.plane(), part.plane().point))
          throw std::invalid_argument("shared edge " + std::to_string(v.edge) +
                                      " is between parallel planes");
      }
}

[[noreturn]] void refuse_edge(geometry::EdgeId edge) {
  throw std::invalid_argument("shared edge " + std::to_string(edge.value) +
                              " has no partner on another segment");
}

}  // namespace

ModelRecord to_record(const Engine& e) {
  ModelRecord r;
  r.parameters = e.setting.parameters;
  r.grid_step = e.setting.step;
  r.arithmetic = geometry::arithmetic();
  r.points = e.complex.now();
  r.refused = e.counts.refused;
  r.expired = e.counts.expired;
  r.sets = e.counts.sets;
  r.redundant_by_count = e.counts.redundant_by_count;
  r.redundant_by_position = e.counts.redundant_by_position;
  r.next_segment = Storage::next_segment(e.complex);
  r.next_edge = e.complex.next_edge();
  e.complex.segments().for_each([&](const Segment& s) {
    if (s.polygon)
      r.polygon_segments.push_back(polygon_record(e.complex, s));
    else
      r.point_segments.push_back(point_record(s));
    if (e.setting.noise_grows())
      (s.polygon ? r.polygon_segments.back().variance_sum : r.point_segments.back().variance_sum) =
          s.data.sums().variance;
  });
  const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
  std::sort(r.point_segments.begin(), r.point_segments.end(), by_id);
  std::sort(r.polygon_segments.begin(), r.polygon_segments.end(), by_id);
  return r;
}

void from_record(Engine& e, const ModelRecord& r) {
  require_sound(e.setting, r);
  Storage::set_counters(e.complex, r.points, r.next_segment, r.next_edge);
  e.counts.refused = r.refused;
  e.counts.expired = r.expired;
  e.counts.sets = r.sets;
  e.counts.redundant_by_count = r.redundant_by_count;
  e.counts.redundant_by_position = r.redundant_by_position;
  for (const PointSegmentRecord& p : r.point_segments) {
    Segment& s = segment_from(e, p.id, p.moments, p.axis_sum, p.variance_sum, p.raw);
    s.fit = fit_to(s.data.moments(), e.setting.step, s.data.axis_sum());
    e.agenda.note_age(s.id, e.complex.now());
    Storage::reindex(e.complex, s);
  }
  for (const PolygonSegmentRecord& p : r.polygon_segments) polygon_from(e, p);
  Storage::pair_edges(e.complex, partners_in(r), refuse_edge);
  require_lines(e.complex, r);
}

}  // namespace limpet::model::internal
