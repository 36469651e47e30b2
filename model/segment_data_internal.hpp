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
  double variance = 0;       ///< about its plane: noise, grid and input rounding together
  int returned = 0;          ///< how often it came out of a dissolved segment
  std::int64_t since = -1;   ///< how many sensor points had come when it came; not yet known: −1
  std::int64_t serial = -1;  ///< place in the labels, when they are kept
};

/// What is kept of the sensor points behind a segment (the thesis's model segment data, §2.2), and, while the
/// segment is young, the points themselves.
///
/// Invariant: a young segment has all its points, and its sums are theirs.
class SegmentData {
 public:
  /// Sums over the points. Those of two sets of points are the sum of both.
  struct Sums {
    Moments moments;
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    double variance = 0;  ///< of the points about their plane
    double since = 0;     ///< of how many points had come when they came; complete while young

    double count() const { return static_cast<double>(moments.count()); }
    Sums& operator+=(const Sums& other);
  };

  SegmentData() = default;
  /// Of a single point, which joins now.
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
  /// How many sensor points had come when this last grew.
  std::int64_t last_joined() const { return last_joined_; }

  /// The only way two become one: the other's points are here as well from now on, one by one if this
  /// `stays_young` (precondition: both are).
  void absorb(const SegmentData& other, bool stays_young, std::int64_t now);
  /// A point joins, and is kept while this is young.
  void absorb(const RawPoint&, std::int64_t now);
  /// Ends youth: the sums stay, the points go.
  void forget_points() { raw_ = std::vector<RawPoint>(); }  // `= {}` would keep the memory
  /// Points that have come out of kMaxReturns dissolved segments may do so again.
  void allow_returns();

 private:
  friend struct Storage;  // taking apart and putting together (storage_internal.hpp)

  Sums sums_;
  std::vector<RawPoint> raw_;
  std::int64_t last_joined_ = 0;
};

}  // namespace limpet::model::internal
