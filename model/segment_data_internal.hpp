// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "moments_internal.hpp"

namespace limpet::model::internal {

struct RawPoint {
  GridPoint at{};
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  double variance = 0;       ///< about its plane, from noise, grid and input rounding; scan's unit squared
  int returned = 0;          ///< how often it came back from a segment dissolved by rule `dissolve`
  std::int64_t since = -1;   ///< number of sensor points that had come when it came; −1: not set yet
  std::int64_t serial = -1;  ///< place in the labels; −1: none
};

/// Sums over the sensor points of a segment (the thesis's model segment data, §2.2), and, while the segment
/// is young, the points themselves.
///
/// Invariant: a young segment keeps all its points, and its sums are over these.
class SegmentData {
 public:
  /// Sums over the points. The sums of two sets of points add up to those of their union.
  struct Sums {
    Moments moments;
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    double variance = 0;  ///< Σ RawPoint::variance
    double since = 0;     ///< Σ RawPoint::since; not added to once the segment is mature

    double count() const { return static_cast<double>(moments.count()); }
    Sums& operator+=(const Sums& other);
    /// Adds a point, but for its `since`.
    void add(const RawPoint& point) {
      moments.add(point.at);
      axis += point.axis;
      variance += point.variance;
    }
  };

  SegmentData() = default;
  /// The data of a mature segment.
  SegmentData(const Sums& sums, std::int64_t last_joined) : sums_(sums), last_joined_(last_joined) {}
  /// The data of a single point, which joins now.
  SegmentData(const RawPoint&, std::int64_t now);

  const Sums& sums() const { return sums_; }
  const Moments& moments() const { return sums_.moments; }
  std::int64_t count() const { return sums_.moments.count(); }
  const Eigen::Vector3d& axis_sum() const { return sums_.axis; }
  /// Mean variance of a point about its plane.
  double variance() const { return sums_.variance / static_cast<double>(std::max<std::int64_t>(count(), 1)); }
  /// All the points while young, else none.
  const std::vector<RawPoint>& raw() const { return raw_; }
  bool young() const { return !raw_.empty(); }
  /// The number of sensor points that had come when a point or segment last joined.
  std::int64_t last_joined() const { return last_joined_; }

  /// Adds the points of the other data; keeps the points themselves if this `stays_young` (precondition: both
  /// are young), else none.
  void absorb(const SegmentData& other, bool stays_young, std::int64_t now);
  /// A point joins. It is kept if this is young.
  void absorb(const RawPoint& point, std::int64_t now) {
    sums_.add(point);
    last_joined_ = now;
    if (young()) keep(point, now);
  }
  /// Makes this mature: keeps the sums, and drops the points.
  void forget_points() { raw_ = std::vector<RawPoint>(); }  // `= {}` would keep the memory
  /// Sets RawPoint::returned back to 0.
  void allow_returns();

 private:
  void keep(const RawPoint&, std::int64_t now);

  friend struct Storage;  // taking apart and putting together (storage_internal.hpp)

  Sums sums_;
  std::vector<RawPoint> raw_;
  std::int64_t last_joined_ = 0;
};

}  // namespace limpet::model::internal
