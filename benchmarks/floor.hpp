// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <limpet/geometry/chart.hpp>
#include <limpet/geometry/polygon.hpp>
#include <limpet/model/record.hpp>
#include <limpet/model/sensor_point.hpp>

namespace limpet::benchmarks {

/// What no incremental planar model can do without, on a finished model: for each point one query of an
/// R-tree of the polygons' boxes, fattened by λ, one exact containment in the polygon of the nearest plane,
/// one addition to its moments. The R-tree is Boost's whatever the engine uses: a yardstick does not change.
class Floor {
 public:
  explicit Floor(const model::ModelRecord&);
  /// How many of the points lie in a polygon.
  std::int64_t add(std::span<const model::SensorPoint>);

 private:
  struct Frozen {
    geometry::Chart chart;
    geometry::Plane plane;
    geometry::Polygon polygon;
    model::MomentsRecord moments;
  };
  using Corner = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Entry = std::pair<boost::geometry::model::box<Corner>, std::uint32_t>;

  bool add(const model::SensorPoint&);

  double resolution_, step_;
  std::vector<Frozen> frozen_;
  boost::geometry::index::rtree<Entry, boost::geometry::index::quadratic<16>> index_;
};

}  // namespace limpet::benchmarks
