// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace limpet::survey {

/// The cells of a cubic grid along a Morton curve (Morton 1966, "A computer oriented geodetic data base"):
/// cells that are near in space are near along it, but for its jumps.
class Curve {
 public:
  static constexpr int kBits = 18;  ///< for each axis

  /// Cells of this edge > 0, scan's unit; the 2¹⁸ along each axis lie about `middle`, and what is beyond
  /// counts into the last of them.
  Curve(const Eigen::Vector3d& middle, double edge) : middle_(middle), edge_(edge) {}

  /// The place along the curve of the cell that holds this position: below 2⁵⁴.
  std::uint64_t place(const Eigen::Vector3d& position) const {
    std::uint64_t bits = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double cell = std::floor((position[axis] - middle_[axis]) / edge_);
      const double within = std::clamp(cell, -kHalf, kHalf - 1) + kHalf;
      bits |= spread(static_cast<std::uint64_t>(within)) << axis;
    }
    return bits;
  }

 private:
  static constexpr double kHalf = 1 << (kBits - 1);

  /// The word's lowest 21 bits, two zeros between each and the next.
  static std::uint64_t spread(std::uint64_t word) {
    word = (word | word << 32) & 0x001f00000000ffffu;
    word = (word | word << 16) & 0x001f0000ff0000ffu;
    word = (word | word << 8) & 0x100f00f00f00f00fu;
    word = (word | word << 4) & 0x10c30c30c30c30c3u;
    return (word | word << 2) & 0x1249249249249249u;
  }

  Eigen::Vector3d middle_;
  double edge_;
};

}  // namespace limpet::survey
