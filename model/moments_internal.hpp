// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include <limpet/geometry/chart.hpp>
#include <limpet/model/record.hpp>

namespace limpet::model {

/// A sensor point on the model's grid: whole multiples of the grid step about the world's origin.
using GridPoint = std::array<std::int64_t, 3>;

/// Coordinates beyond this many steps are refused, so that sums of squares of 2^27 points fit in 128 bits.
inline constexpr std::int64_t kMaxSteps = std::int64_t{1} << 48;

/// Exact sums over sensor points (thesis §2.2), without cancellation far from the origin.
///  (1) The sums depend on neither the order nor the grouping of what was added;
///  (2) the covariance does not change, to the last bit, when all points move by whole steps and
///      their mean stays on the same side of the origin along each axis (it is rounded towards zero;
///      else the last bits may);
///  (3) exchanging or mirroring the axes exchanges or mirrors centroid and covariance, to the last bit;
///  (4) multiplying the step by a power of two scales them exactly.
class Moments {
 public:
  Moments() = default;
  explicit Moments(const GridPoint& p) { add(p); }
  explicit Moments(const MomentsRecord& r) : count_(r.count), sum_(r.sum), product_(r.product) {}

  void add(const GridPoint& p) {
    ++count_;
    const Int128 x = p[0], y = p[1], z = p[2];
    sum_[0] += x, sum_[1] += y, sum_[2] += z;
    product_[0] += x * x, product_[1] += x * y, product_[2] += x * z;
    product_[3] += y * y, product_[4] += y * z, product_[5] += z * z;
  }
  void add(const Moments& other);

  std::int64_t count() const { return count_; }
  /// Mean of the points, in the unit of `step`, the length of a grid step. Precondition: count() > 0.
  Eigen::Vector3d centroid(double step) const;
  /// Covariance matrix C of thesis §2.2, in the unit of step². Precondition: count() > 0.
  Eigen::Matrix3d covariance(double step) const;

  /// Mean squared distance of the points from a plane: nᵀCn + (n·(mean − point))². Precondition: count() > 0.
  double squared_residual(const geometry::Plane& plane, double step) const;

  MomentsRecord record() const { return {count_, sum_, product_}; }

 private:
  std::array<std::int64_t, 3> rounded_mean() const;

  std::int64_t count_ = 0;
  std::array<Int128, 3> sum_{};
  std::array<Int128, 6> product_{};  ///< xx, xy, xz, yy, yz, zz
};

}  // namespace limpet::model
