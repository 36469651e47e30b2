// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/geometry/polygon.hpp>

#include "archive_internal.hpp"
#include "storage_internal.hpp"

/// Serialisation of the parts of an Engine, for an archive (Writer or Reader).
namespace limpet::model::internal {

/// Serialises a class as the plain data that take_apart() gives, from which put_together() makes it again.
template <class Archive, class T, class TakeApart, class PutTogether>
void describe_taken_apart(Archive& archive, T& x, const TakeApart& take_apart,
                          const PutTogether& put_together) {
  auto parts = take_apart(x);
  archive(parts);
  if constexpr (Archive::kReads) x = put_together(std::move(parts));
}

// geometry/
void describe(auto& archive, Is<geometry::Point2> auto& p) { archive(p.x, p.y); }
void describe(auto& archive, Is<geometry::Box2> auto& box) { archive(box.low, box.high); }
void describe(auto& archive, Is<geometry::EdgeId> auto& id) { archive(id.value); }
void describe(auto& archive, Is<geometry::EdgeIds> auto& ids) {
  describe_taken_apart(
      archive, ids, [](const auto& i) { return i.next(); },
      [](std::uint64_t next) { return geometry::EdgeIds(next); });
}
void describe(auto& archive, Is<geometry::Plane> auto& plane) { archive(plane.point, plane.normal); }
void describe(auto& archive, Is<geometry::Lift> auto& lift) { archive(lift.h0, lift.hx, lift.hy); }
void describe(auto& archive, Is<geometry::Chart> auto& chart) {
  using Vectors = std::array<Eigen::Vector3d, 4>;
  describe_taken_apart(
      archive, chart,
      [](const auto& c) {
        return std::pair(Vectors{c.origin(), c.u(), c.v(), c.normal()}, c.step());
      },
      [](const auto& c) {
        const auto& [origin, u, v, normal] = c.first;
        return geometry::Chart(origin, u, v, normal, c.second);
      });
}
void describe(auto& archive, Is<geometry::Polygon::Node> auto& n) {
  archive(n.at, n.next, n.prev, n.cycle, n.edge, n.shared);
}
void describe(auto& archive, Is<geometry::Polygon::Cycle> auto& c) { archive(c.first, c.size, c.hole); }
void describe(auto& archive, Is<geometry::PolygonState> auto& p) {
  archive(p.nodes, p.cycles, p.free, p.origin, p.twice_area, p.box, p.index_edges, p.removed, p.created,
          p.version, p.joins);
  if (p.index_edges > 0) archive(p.index_box);
}
void describe(auto& archive, Is<geometry::Polygon> auto& polygon) {
  describe_taken_apart(
      archive, polygon, [](const auto& p) { return p.state(); },
      [](geometry::PolygonState p) { return geometry::Polygon::from_state(std::move(p)); });
}

// model/
void describe(auto& archive, Is<SegmentId> auto& id) { archive(id.value); }
void describe(auto& archive, Is<MomentsRecord> auto& m) { archive(m.count, m.sum, m.product); }
void describe(auto& archive, Is<Moments> auto& moments) {
  describe_taken_apart(
      archive, moments, [](const auto& m) { return m.record(); },
      [](const MomentsRecord& m) { return Moments(m); });
}
void describe(auto& archive, Is<Fit> auto& f) {
  archive(f.centroid, f.normal, f.u2, f.count, f.u1, f.u3, f.axis1, f.axis2);
}
void describe(auto& archive, Is<RawPoint> auto& r) {
  archive(r.at, r.axis, r.variance, r.returned, r.since, r.serial);
}
void describe(auto& archive, Is<DirtyRegion> auto& places) {
  describe_taken_apart(
      archive, places, [](const auto& p) { return p.boxes(); },
      [](std::vector<Box3> boxes) { return DirtyRegion::of_boxes(std::move(boxes)); });
}
void describe(auto& archive, Is<HeightMap::Sum> auto& sum) { archive(sum.count, sum.x, sum.y, sum.height); }
void describe(auto& archive, Is<HeightMap> auto& map) {
  describe_taken_apart(
      archive, map, [](const auto& m) { return m.keyed_squares(); },
      [](const auto& squares) { return HeightMap::of_squares(squares); });
}
void describe(auto& archive, Is<SegmentData> auto& data) { Storage::describe_data(archive, data); }
void describe(auto& archive, Is<Felt::Part> auto& p) {
  archive(p.chart, p.perimeter, p.points, p.area, p.thinning);
}
void describe(auto& archive, Is<Felt> auto& felt) {
  std::apply([&](auto&... members) { archive(members...); }, felt.members());
}
void describe(auto& archive, Is<Passages::Place> auto& p) { archive(p.at, p.count); }
void describe(auto& archive, Is<Passages> auto& passages) {
  std::apply([&](auto&... members) { archive(members...); }, passages.members());
}
void describe(auto& archive, Is<PolygonPart> auto& p) {
  archive(p.chart, p.perimeter, p.published, p.outward, p.initial, p.box, p.heights, p.stale, p.counted_area,
          p.shape, p.felt, p.passages);
}
void describe(auto& archive, Is<Segment> auto& s) {
  archive(s.id, s.fit, s.data, s.next_fit, s.indexed, s.indexed_as_polygon, s.polygon);
}
void describe(auto& archive, Is<PolygonDue> auto& due) {
  archive(due.changed, due.unshared, due.fresh, due.corners_due, due.next_share, due.shared_later);
}
void describe(auto& archive, Is<Counts> auto& c) {  // the others are counted anew each time
  archive(c.refused, c.expired, c.sets, c.redundant_by_count, c.redundant_by_position);
}
void describe(auto& archive, Is<Parameters> auto& p) {
  archive(p.resolution, p.angle_rad, p.noise, p.noise_per_range, p.noise_per_range2, p.input_quantum,
          p.tolerance, p.outlier_patience, p.redundancy_count, p.redundancy_ratio, p.neighbours);
  archive(p.resolution_per_range, p.sensors);
  describe_taken_apart(
      archive, p.rules,
      [](const Rules& rules) {
        const std::string text = rules.to_string();
        return std::vector<char>(text.begin(), text.end());
      },
      [](const std::vector<char>& text) {
        return Rules::parse({text.data(), text.size()});
      });
}

/// Everything of an engine that outlasts a call, except its parameters and what state.cpp stores itself.
void describe(auto& archive, Is<Engine> auto& e) {
  archive(e.counts);
  Storage::describe_complex(archive, e.complex);
  Storage::describe_agenda(archive, e.agenda);
}

}  // namespace limpet::model::internal
