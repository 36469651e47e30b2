// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>

namespace limpet::following::internal {

/// The i-th point of Halton's sequence in the unit cube of so many dimensions (Halton 1960; i ≥ 1): evenly
/// spread, and the same on every machine.
inline Eigen::VectorXd halton(int i, Eigen::Index dimensions) {
  Eigen::VectorXd point(dimensions);
  int base = 1;
  for (double& x : point) {
    for (bool is_prime = false; !is_prime;) {
      ++base;
      is_prime = true;
      for (int divisor = 2; divisor * divisor <= base; ++divisor) is_prime &= base % divisor != 0;
    }
    x = 0;
    double share = 1;
    for (int rest = i; rest > 0; rest /= base) x += (share /= base) * (rest % base);
  }
  return point;
}

}  // namespace limpet::following::internal
