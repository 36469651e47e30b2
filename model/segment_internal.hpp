// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include <limpet/geometry/chart.hpp>
#include <limpet/geometry/polygon.hpp>
#include <limpet/model/changes.hpp>

#include "fit_internal.hpp"
#include "height_map_internal.hpp"
#include "owned_internal.hpp"
#include "segment_data_internal.hpp"
#include "spatial_index_internal.hpp"

namespace limpet::model::internal {

/// What a planar polygon segment has beyond a point segment. Its shape in the world is the perimeter's,
/// lifted from the chart onto the published plane.
struct PolygonPart {
  geometry::Chart chart;
  geometry::Polygon perimeter;
  geometry::Lift published;                           ///< plane that perimeters are lifted to
  Eigen::Vector3d outward = Eigen::Vector3d::Zero();  ///< normal of the published plane
  geometry::Plane initial;                            ///< thesis §2.4.1
  Box3 box;                                           ///< of the perimeter in the world
  HeightMap heights;                                  ///< of its points (rule `relief`); none while young
  bool stale = false;                    ///< the fit has moved on, but its plane could not be published
  double counted_area = 0;               ///< what of its area is in Complex::modelled_area(), λ²
  std::uint64_t shape = 0;               ///< counts changes of the description
  std::vector<geometry::EdgeId> shared;  ///< its edges that are shared with neighbours, ascending

  /// A chart point, or a vertex, in the world.
  Eigen::Vector3d at(geometry::Point2 p) const { return chart.at(p, published(p)); }
  Eigen::Vector3d position(geometry::Slot s) const { return at(perimeter.at(s)); }
  geometry::Plane plane() const { return published.plane(chart); }
};

struct alignas(64) Segment {
  Fit fit;
  Owned<PolygonPart> polygon;  ///< none: a point segment
  SegmentId id;
  std::uint32_t slot = 0;
  SegmentData data;
  std::int64_t next_fit = 0;  ///< count at which the fit is computed anew
  Box3 indexed;               ///< as it is in the spatial index
  bool indexed_as_polygon = false;

  std::int64_t count() const { return data.count(); }
  bool young() const { return data.young(); }
  /// Known beforehand (thesis §4.3): represents no points.
  bool initial() const { return polygon && count() == 0; }
  bool mature_polygon() const { return polygon && !young() && !initial(); }
};

/// Calls f(slot) for every edge of a perimeter, in the order of memory.
template <class F>
void for_each_edge(const geometry::Polygon& perimeter, F&& f) {
  for (std::uint32_t i = 0; i < perimeter.slot_count(); ++i)
    if (perimeter.alive(geometry::Slot{i})) f(geometry::Slot{i});
}

/// Edges with the slots they were put in. They may have gone since.
using PlacedEdges = std::vector<std::pair<geometry::Slot, geometry::EdgeId>>;
/// Is the edge still where it was put?
inline bool still_there(const geometry::Polygon& perimeter,
                        const std::pair<geometry::Slot, geometry::EdgeId>& placed) {
  return perimeter.alive(placed.first) && perimeter.node(placed.first).edge == placed.second;
}

/// World boxes.
Box3 box_around(const Eigen::Vector3d& p, double reach);
Box3 perimeter_box(const PolygonPart&);

/// Does an outward normal face away from where the sensing axes point? With a margin, so that it holds
/// exactly, too.
inline bool faces_outside(const Eigen::Vector3d& normal, const Eigen::Vector3d& axis_sum) {
  return normal.dot(axis_sum) < -1e-6;
}

}  // namespace limpet::model::internal
