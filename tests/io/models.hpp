// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limpet/model/record.hpp>
#include <map>
#include <utility>
#include <vector>

/// Models made by hand, with known areas and counts.
namespace limpet::io::testing {

using Loop = std::vector<Eigen::Vector3d>;

/// A model of flat faces given by their loops in the world (the perimeter anticlockwise about the outward
/// normal, holes clockwise). Edges that two faces run along in opposite directions are shared. Coordinates
/// must be multiples of 1/1024, faces parallel to the axes or with normals whose square root is whole, so
/// that nothing is rounded.
class ModelMaker {
 public:
  ModelMaker() {
    model_.parameters.resolution = 0.0625;
    model_.parameters.angle_rad = 0.17453292519943295;
    model_.parameters.noise = 0.001;
    model_.parameters.tolerance = 0.0125;
    model_.grid_step = 1.0 / 1024;
    model_.arithmetic = "exact";
    model_.parameters.rules = model::Rules::thesis();
  }

  ModelMaker& face(const std::vector<Loop>& loops) {
    model::PolygonSegmentRecord& segment = model_.polygon_segments.emplace_back();
    segment.id = model_.next_segment++;
    const Eigen::Vector3d normal = normal_of(loops[0]);
    const Eigen::Vector3d u = (loops[0][1] - loops[0][0]).normalized();
    segment.chart_origin = segment.initial_centroid = loops[0][0];
    segment.chart_u = u;
    segment.chart_v = normal.cross(u);
    segment.chart_normal = segment.initial_normal = normal;
    segment.moments.count = 100;
    segment.axis_sum = -100 * normal;
    model_.points += 100;
    for (const Loop& loop : loops) {
      auto& cycle = segment.cycles.emplace_back();
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Eigen::Vector3d from_origin = (loop[i] - segment.chart_origin) / model_.grid_step;
        const std::uint64_t edge = model_.next_edge++;
        cycle.push_back({from_origin.dot(u), from_origin.dot(segment.chart_v), edge, 0});
        edges_[{key(loop[i]), key(loop[(i + 1) % loop.size()])}] = edge;
      }
    }
    return *this;
  }

  ModelMaker& loose(const Eigen::Vector3d& at) {
    model::PointSegmentRecord& segment = model_.point_segments.emplace_back();
    segment.id = model_.next_segment++;
    segment.moments.count = 1;
    for (int i = 0; i < 3; ++i) segment.moments.sum[i] = static_cast<model::Int128>(at[i] / model_.grid_step);
    ++model_.points;
    return *this;
  }

  model::ModelRecord make() {
    std::map<std::uint64_t, std::uint64_t> partners;
    for (const auto& [ends, edge] : edges_) {
      const auto found = edges_.find({ends.second, ends.first});
      if (found != edges_.end()) partners[edge] = found->second;
    }
    for (auto& segment : model_.polygon_segments) {
      for (auto& cycle : segment.cycles) {
        for (auto& vertex : cycle) {
          if (partners.count(vertex.edge) != 0) vertex.partner = partners[vertex.edge];
        }
      }
    }
    return model_;
  }

 private:
  using Key = std::array<double, 3>;
  static Key key(const Eigen::Vector3d& at) { return {at.x(), at.y(), at.z()}; }
  static Eigen::Vector3d normal_of(const Loop& loop) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) sum += (loop[i] - loop[0]).cross(loop[i + 1] - loop[0]);
    return sum.normalized();
  }

  model::ModelRecord model_;
  std::map<std::pair<Key, Key>, std::uint64_t> edges_;
};

/// The side faces of a prism over `base` (anticlockwise seen from above, at its own height) up to `top`.
inline void add_sides(ModelMaker& maker, const Loop& base, double top) {
  for (std::size_t i = 0; i < base.size(); ++i) {
    const Eigen::Vector3d &a = base[i], &b = base[(i + 1) % base.size()];
    maker.face({{a, b, {b.x(), b.y(), top}, {a.x(), a.y(), top}}});
  }
}

inline Loop raised(Loop loop, double z) {
  for (Eigen::Vector3d& p : loop) p.z() = z;
  return loop;
}

inline Loop reversed(Loop loop) { return Loop(loop.rbegin(), loop.rend()); }

inline void add_prism(ModelMaker& maker, const Loop& base, double top) {
  maker.face({reversed(base)});
  add_sides(maker, base, top);
  maker.face({raised(base, top)});
}

inline Loop rectangle(double x0, double y0, double x1, double y1, double z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

/// Unit cube at `offset`: 6 polygons, 24 vertices in cycles, 12 shared edges, area 6.
inline model::ModelRecord cube(const Eigen::Vector3d& offset = Eigen::Vector3d::Zero()) {
  ModelMaker maker;
  Loop base = rectangle(0, 0, 1, 1, 0);
  for (Eigen::Vector3d& p : base) p += offset;
  add_prism(maker, base, 1 + offset.z());
  return maker.make();
}

/// The same cube without its top: 5 polygons, 8 shared edges, 4 open, area 5.
inline model::ModelRecord open_cube() {
  ModelMaker maker;
  const Loop base = rectangle(0, 0, 1, 1, 0);
  maker.face({reversed(base)});
  add_sides(maker, base, 1);
  return maker.make();
}

/// L-shaped block: 8 polygons, two of them with six vertices; area 2·3 + 8·1 = 14.
inline model::ModelRecord l_block() {
  ModelMaker maker;
  add_prism(maker, {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}, 1);
  return maker.make();
}

/// Plate 4 × 2 × 0.25 with two square bores of side 1 and 0.5, closed: 14 polygons, two of them with two
/// holes. Area 2·(8 − 1 − 0.25) + 0.25·(12 + 4 + 2) = 18.
inline model::ModelRecord plate() {
  ModelMaker maker;
  const Loop outer = rectangle(0, 0, 4, 2, 0);
  const Loop bore = reversed(rectangle(0.5, 0.5, 1.5, 1.5, 0)),
             small = reversed(rectangle(2.5, 0.75, 3, 1.25, 0));
  maker.face({reversed(outer), reversed(bore), reversed(small)});
  for (const Loop& loop : {outer, bore, small}) add_sides(maker, loop, 0.25);
  maker.face({raised(outer, 0.25), raised(bore, 0.25), raised(small, 0.25)});
  return maker.make();
}

}  // namespace limpet::io::testing
