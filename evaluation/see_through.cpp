// Copyright the limpet authors. GPL-3.0-or-later.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limpet/evaluation/see_through_internal.hpp>
#include <limpet/evaluation/triangle_tree_internal.hpp>
#include <optional>
#include <unordered_map>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using model::SensorPoint;

constexpr int kCompany = 5;  ///< readings in a cube of 3λ, of which an outlier has fewer

/// All polygons as triangles, which are asked for those that a ray meets.
class Screens {
 public:
  explicit Screens(const std::vector<Ground>& grounds) {
    for (std::size_t i = 0; i < grounds.size(); ++i)
      for (const Triangle3& t : grounds[i].region.triangles) {
        const Kernel::Triangle_3 triangle(point(t[0]), point(t[1]), point(t[2]));
        if (triangle.is_degenerate()) continue;
        triangles_.push_back(triangle);
        polygon_.push_back(static_cast<int>(i));
      }
    tree_.insert(triangles_.cbegin(), triangles_.cend());
    tree_.build();
  }

  /// Each polygon once, ascending.
  std::vector<int> met_between(const Vector3d& from, const Vector3d& to) const {
    std::vector<ExactPrimitive::Id> met;
    if (!triangles_.empty())
      tree_.all_intersected_primitives(Kernel::Segment_3(point(from), point(to)), std::back_inserter(met));
    std::vector<int> polygons;
    for (const ExactPrimitive::Id& triangle : met)
      polygons.push_back(polygon_[triangle - triangles_.cbegin()]);
    std::sort(polygons.begin(), polygons.end());
    polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
    return polygons;
  }

 private:
  ExactTriangles triangles_;
  std::vector<int> polygon_;
  ExactTree tree_;
};

/// How many readings are about a place.
class Company {
 public:
  Company(const std::vector<SensorPoint>& readings, double edge) : edge_(edge) {
    for (const SensorPoint& reading : readings) ++count_[key(cell(reading.position))];
  }

  bool has(const Vector3d& place) const {
    const Cell middle = cell(place);
    int readings = 0;
    for (int i = 0; i < 27; ++i) {
      const auto found =
          count_.find(key({middle.x() + i % 3 - 1, middle.y() + i / 3 % 3 - 1, middle.z() + i / 9 - 1}));
      if (found != count_.end()) readings += found->second;
    }
    return readings >= kCompany;
  }

 private:
  using Cell = Eigen::Matrix<std::int64_t, 3, 1>;
  Cell cell(const Vector3d& place) const {
    return (place / edge_).array().floor().matrix().cast<std::int64_t>();
  }
  /// 21 bits a coordinate: cells that share a key are two million cells apart.
  static std::int64_t key(const Cell& cell) {
    constexpr std::int64_t kBits = (1 << 21) - 1;
    return (cell.x() & kBits) | (cell.y() & kBits) << 21 | (cell.z() & kBits) << 42;
  }

  double edge_;
  std::unordered_map<std::int64_t, int> count_;
};

double mean_at(const std::vector<SensorPoint>& readings, const ResolutionField& resolution) {
  if (!resolution.grows()) return resolution.at(Vector3d::Zero());
  double sum = 0;
  for (const SensorPoint& reading : readings) sum += resolution.at(reading.position);
  return sum / static_cast<double>(readings.size());
}

/// Distances in a polygon to its perimeter, of those that are asked.
class Perimeters {
 public:
  explicit Perimeters(const std::vector<Ground>& grounds) : grounds_(grounds), lines_(grounds.size()) {}

  double distance(int polygon, const Vector3d& from) {
    if (!lines_[polygon]) lines_[polygon].emplace(boundary_segments(grounds_[polygon].region.face));
    return lines_[polygon]->distance(from);
  }

 private:
  const std::vector<Ground>& grounds_;
  std::vector<std::optional<NearestLine>> lines_;
};

}  // namespace

RayCounts see_through(const std::vector<Ground>& grounds, const Footing& footing, const Tolerance& tolerance,
                      const std::vector<SensorPoint>& readings, const ResolutionField& resolution,
                      std::int64_t most) {
  RayCounts counts{0, std::vector<std::int64_t>(grounds.size()), std::vector<std::int64_t>(grounds.size())};
  std::vector<std::size_t> ranged;
  for (std::size_t i = 0; i < readings.size(); ++i)
    if (readings[i].range > 0) ranged.push_back(i);
  if (ranged.empty()) return counts;

  const Screens screens(grounds);
  const Company company(readings, mean_at(readings, resolution));
  Perimeters perimeters(grounds);
  const auto all = static_cast<std::int64_t>(ranged.size());
  counts.rays = std::min(all, most);
  for (std::int64_t k = 0; k < counts.rays; ++k) {
    const SensorPoint& reading = readings[ranged[k * all / counts.rays]];
    const double off = tolerance.at(reading.range);
    footing.each(reading, off, [&](const Footing::Foot& foot) { ++counts.on[foot.polygon]; });
    const double lambda = resolution.at(reading.position);
    if (reading.range <= lambda || !company.has(reading.position)) continue;
    const Vector3d from = reading.position - reading.range * reading.axis;
    const Vector3d to = reading.position - lambda * reading.axis;
    for (const int polygon : screens.met_between(from, to)) {
      const FlatPolygon& flat = grounds[polygon].flat;
      const double start = flat.height(from), end = flat.height(reading.position);
      if (std::abs(end) <= off || start == end) continue;
      const Vector3d crossing = from + start / (start - end) * (reading.position - from);
      if (perimeters.distance(polygon, crossing) > resolution.at(crossing)) ++counts.through[polygon];
    }
  }
  return counts;
}

}  // namespace limpet::evaluation
