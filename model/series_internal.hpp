// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

/// Functions computed from their series instead of the standard library, so that every machine gives the same
/// bits.
namespace limpet::model::internal {

/// Cosine of an angle in radians. Precondition: |x| ≤ 2.
inline double cosine(double x) {
  double term = 1, sum = 1;
  for (int k = 1; k < 20; ++k) {
    term *= -x * x / ((2 * k - 1) * (2 * k));
    sum += term;
  }
  return sum;
}

/// Natural logarithm. Precondition: x > 0.
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
