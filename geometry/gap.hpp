// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <functional>
#include <limpet/geometry/types.hpp>

namespace limpet::geometry {

/// λ in grid steps: the same everywhere, or one that differs from place to place (chart).
class Gap {
 public:
  Gap(double everywhere) : most_(everywhere) {}
  /// `most` is no less than any of what `at` gives.
  Gap(std::function<double(Point2)> at, double most) : most_(most), at_(std::move(at)) {}
  double at(Point2 p) const { return at_ ? at_(p) : most_; }
  double most() const { return most_; }

 private:
  double most_ = 0;
  std::function<double(Point2)> at_;
};

}  // namespace limpet::geometry
