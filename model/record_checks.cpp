// Copyright the limpet authors. GPL-3.0-or-later.
//
// Checks that a model can be made of a record, and used safely. The perimeters are judged by
// geometry::Polygon::from_cycles(), the pairs of shared edges by Storage::pair_edges().
#include <cmath>
#include <stdexcept>
#include <string>
#include <unordered_set>

#include <limpet/geometry/predicates.hpp>

#include "record_internal.hpp"

namespace limpet::model::internal {
namespace {

constexpr std::int64_t kMostCounted = std::int64_t{1} << 53;  ///< that every double holds
constexpr std::uint64_t kMostIdentities = std::uint64_t{1} << 63;
constexpr double kFarthestSteps =
    2.0 * static_cast<double>(kMaxSteps);             ///< of what lies among points, or nearly
constexpr double kFarthestInChart = 0x1p40;           ///< steps
constexpr double kUnit = 1e-6;                        ///< by which a unit vector may be none
constexpr double kTanMostTilt = 0.05240777928304120;  ///< of 3°, as the law `tilt` says

bool is_within(const Eigen::Vector3d& v, double limit) {  // false for what is not finite, too
  return std::abs(v.x()) <= limit && std::abs(v.y()) <= limit && std::abs(v.z()) <= limit;
}
bool is_unit(const Eigen::Vector3d& v) { return std::abs(v.norm() - 1) <= kUnit; }
bool is_count(std::int64_t n) { return n >= 0 && n <= kMostCounted; }

void require(bool good, const char* what) {
  if (!good) throw std::invalid_argument(what);
}

/// What is said of one segment.
class SegmentChecks {
 public:
  SegmentChecks(std::uint64_t id, double step) : id_(id), step_(step) {}

  void require(bool good, const char* what) const {
    if (!good) throw std::invalid_argument("segment " + std::to_string(id_) + " " + what);
  }

  /// Of segments of both kinds.
  void data(const auto& s) const {
    const char* fault = fault_of(s.moments);
    require(!fault, fault);
    const auto m = static_cast<double>(s.moments.count);
    require(is_within(s.axis_sum, m + kUnit * (1 + m)), "has an axis sum that its points' axes do not have");
    require(s.variance_sum >= 0 && std::isfinite(s.variance_sum), "has a variance that is none");
    require(s.raw.empty() || static_cast<std::int64_t>(s.raw.size()) == s.moments.count,
            "keeps other sensor points than it counts");
    for (const RawPointRecord& point : s.raw) raw_point(point);
  }

  void plane(const PolygonSegmentRecord& s) const {
    const double farthest = kFarthestSteps * step_;
    require(is_within(s.chart_origin, farthest), "has a chart that is beyond 2^49 grid steps");
    const Eigen::Vector3d &u = s.chart_u, &v = s.chart_v, &n = s.chart_normal;
    require(is_unit(u) && is_unit(v) && std::abs(u.dot(v)) <= kUnit && is_within(n - u.cross(v), kUnit),
            "has chart axes that are not orthonormal and right-handed");
    require(std::abs(s.height[0]) <= kFarthestSteps, "has a plane that is beyond 2^49 grid steps");
    require(std::hypot(s.height[1], s.height[2]) <= kTanMostTilt,
            "has a plane that differs from its chart by more than 3 degrees");
    require(is_within(s.initial_centroid, farthest) && is_unit(s.initial_normal),
            "has an initial plane that is none");
    require(is_count(s.confirmed), "has a count that is below 0 or beyond 2^53");
  }

 private:
  void raw_point(const RawPointRecord& point) const {
    for (const std::int64_t x : point.at)
      require(-kMaxSteps <= x && x <= kMaxSteps, "keeps a sensor point that is beyond 2^48 grid steps");
    require(is_unit(point.axis), "keeps a sensor point whose axis is no unit vector");
    require(point.returned >= 0, "keeps a sensor point that returned less than never");
  }

  std::uint64_t id_;
  double step_;
};

void require_header(const Setting& setting, const ModelRecord& r) {
  const Parameters& p = setting.parameters;
  require(std::isfinite(p.redundancy_count) && std::isfinite(p.redundancy_ratio),
          "the redundancy thresholds ψ and φ must be finite");
  require(r.grid_step == setting.step, "the grid step is not that of the linear resolution");
  for (const std::int64_t n :
       {r.points, r.refused, r.expired, r.sets, r.redundant_by_count, r.redundant_by_position})
    require(is_count(n), "a count is below 0 or beyond 2^53");
  require(r.next_segment <= kMostIdentities && r.next_edge <= kMostIdentities,
          "the next identities are beyond 2^63");
}

/// Identities of edges; those of segments are entered, and thereby judged, as the segments are made.
class EdgeChecks {
 public:
  explicit EdgeChecks(std::uint64_t next) : next_(next) {}

  void cycles(const PolygonSegmentRecord& s, const SegmentChecks& segment) {
    for (const auto& cycle : s.cycles)
      for (const VertexRecord& v : cycle) {
        segment.require(is_in_chart(v.x) && is_in_chart(v.y),
                        "has a vertex that is no grid point within 2^40 steps of its chart's origin");
        segment.require(v.edge > 0 && v.edge < next_, "has an edge of an identity that was not given yet");
        segment.require(seen_.insert(v.edge).second, "has an edge whose identity occurs twice");
      }
  }

 private:
  bool is_in_chart(double x) const {
    return std::abs(x) <= kFarthestInChart && (anywhere_ || x == std::trunc(x));
  }

  std::uint64_t next_;
  bool anywhere_ = geometry::arithmetic() == std::string("float");  ///< not on the grid alone
  std::unordered_set<std::uint64_t> seen_;
};

}  // namespace

const char* fault_of(const MomentsRecord& m) {
  const auto sized = [](Int128 x) { return x < 0 ? -x : x; };
  const Int128 lowest = Int128{1} << 127, largest = Int128{1} << 124;
  const Int128 squared_steps = Int128{kMaxSteps} * kMaxSteps;
  if (m.count < 0) return "has fewer than no points";
  if (m.count > kMostCounted) return "has too many points";
  for (const Int128 sum : m.sum) {
    if (sum == lowest || sized(sum) > Int128{m.count} * kMaxSteps) return "has sums that no points have";
    // Moments::covariance() multiplies sums by the rounded mean.
    const auto x = static_cast<long double>(sum);
    if (m.count > 0 && x * x / static_cast<long double>(m.count) > static_cast<long double>(largest))
      return "has too many points";
  }
  for (const Int128 product : m.product) {
    if (product == lowest || sized(product) > largest) return "has too many points";
    if (m.count < largest / squared_steps && sized(product) > m.count * squared_steps)
      return "has sums that no points have";
  }
  return nullptr;
}

void require_sound(const Setting& setting, const ModelRecord& r) {
  require_header(setting, r);
  EdgeChecks edges(r.next_edge);
  const auto identity = [&](const auto& s, const SegmentChecks& segment) {
    segment.require(s.id > 0 && s.id < r.next_segment, "has an identity that was not given yet");
    segment.data(s);
  };
  for (const PointSegmentRecord& s : r.point_segments) {
    const SegmentChecks segment(s.id, setting.step);
    identity(s, segment);
    segment.require(s.moments.count > 0, "has no points");
  }
  for (const PolygonSegmentRecord& s : r.polygon_segments) {
    const SegmentChecks segment(s.id, setting.step);
    identity(s, segment);
    segment.plane(s);
    edges.cycles(s, segment);
  }
}

}  // namespace limpet::model::internal
