// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

/// Functions by their series, not by the machine's library: the same bits everywhere.
namespace limpet::model::internal {

/// Precondition: |x| ≤ 2.
inline double cosine(double x) {
  double term = 1, sum = 1;
  for (int k = 1; k < 20; ++k) {
    term *= -x * x / ((2 * k - 1) * (2 * k));
    sum += term;
  }
  return sum;
}

/// To base e. Precondition: x > 0.
inline double natural_log(double x) {
  constexpr double kE = 2.718281828459045;
  double whole = 0;
  for (; x > kE; ++whole) x /= kE;
  for (; x < 1; --whole) x *= kE;
  const double q = (x - 1) / (x + 1);
  double power = q, sum = 0;
  for (int k = 1; k < 60; k += 2, power *= q * q) sum += power / k;
  return whole + 2 * sum;
}

}  // namespace limpet::model::internal
