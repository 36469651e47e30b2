// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include <limpet/geometry/chart.hpp>
#include <limpet/geometry/polygon.hpp>
#include <limpet/model/changes.hpp>

#include "felt_internal.hpp"
#include "fit_internal.hpp"
#include "height_map_internal.hpp"
#include "owned_internal.hpp"
#include "passages_internal.hpp"
#include "segment_data_internal.hpp"
#include "spatial_index_internal.hpp"

namespace limpet::model::internal {

/// What a planar polygon segment has in addition to a point segment. In the world, it is the perimeter lifted
/// from the chart onto the published plane.
struct PolygonPart {
  Box3 box;  ///< of the perimeter in the world: first, since most questions end with it
  geometry::Chart chart;
  geometry::Polygon perimeter;
  geometry::Lift published;                           ///< published plane, to which the perimeter is lifted
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();  ///< unit normal of the published plane
  geometry::Plane initial;                            ///< initial plane of thesis §2.4.1
  HeightMap heights;                                  ///< of its points (rule `relief`); empty while young
  bool stale = false;                    ///< the plane of the fit has moved, but could not be published
  double counted_area = 0;               ///< the part of Complex::modelled_area() that is its own, λ²
  std::int64_t confirmed = 0;            ///< readings that lie on it; of an initial segment only
  std::uint64_t shape = 0;               ///< version number of the description
  Owned<Felt> felt;                      ///< since finish() has begun to add to it; none: all of it was felt
  Owned<Passages> passages;              ///< where readings have passed its plane; none: nowhere
  std::vector<geometry::EdgeId> shared;  ///< its edges that are shared with neighbours, ascending

  /// A chart point, or a vertex, in the world.
  Eigen::Vector3d at(geometry::Point2 p) const { return chart.at(p, published(p)); }
  Eigen::Vector3d position(geometry::Slot s) const { return at(perimeter.at(s)); }
  bool all_felt() const { return !felt || felt->is_all(); }
  geometry::Plane plane() const { return published.plane(chart); }
};

struct alignas(64) Segment {
  Fit fit;
  Owned<PolygonPart> polygon;  ///< none: a point segment
  SegmentId id;
  std::uint32_t slot = 0;
  std::int64_t next_fit = 0;  ///< number of points at which the plane is fitted anew
  SegmentData data;
  Box3 indexed;  ///< its box in the spatial index; empty: it is in none
  bool indexed_as_polygon = false;

  std::int64_t count() const { return data.count(); }
  bool young() const { return data.young(); }
  /// An initial segment (thesis §4.3), known beforehand, which represents no points.
  bool initial() const { return polygon && count() == 0; }
  bool mature_polygon() const { return polygon && !young() && !initial(); }
};

/// Calls f(slot) for every edge of a perimeter, in the order of slots.
template <class F>
void for_each_edge(const geometry::Polygon& perimeter, F&& f) {
  for (std::uint32_t i = 0; i < perimeter.slot_count(); ++i)
    if (perimeter.alive(geometry::Slot{i})) f(geometry::Slot{i});
}

/// Edges with the slots they were put in. Some may have been removed since.
using PlacedEdges = std::vector<std::pair<geometry::Slot, geometry::EdgeId>>;
/// Is the edge still where it was put?
inline bool still_there(const geometry::Polygon& perimeter,
                        const std::pair<geometry::Slot, geometry::EdgeId>& placed) {
  return perimeter.alive(placed.first) && perimeter.node(placed.first).edge == placed.second;
}

/// Boxes in the world.
Box3 box_around(const Eigen::Vector3d& p, double reach);
Box3 perimeter_box(const PolygonPart&);

/// Does an outward normal point against the sum of the sensing axes? The margin makes it true in exact
/// arithmetic, too.
inline bool faces_outside(const Eigen::Vector3d& normal, const Eigen::Vector3d& axis_sum) {
  return normal.dot(axis_sum) < -1e-6;
}

}  // namespace limpet::model::internal
