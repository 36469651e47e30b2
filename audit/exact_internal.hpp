// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limpet/audit/document.hpp>
#include <utility>

namespace limpet::audit {

/// A dyadic rational, mantissa · 2^exponent with a mantissa of any length. Every finite double is one, and
/// sums, differences and products of them are too, so every law can be decided exactly without a division,
/// and without the gcd that general rationals need.
class Dyadic {
 public:
  Dyadic() = default;
  /// `value` must be finite.
  Dyadic(double value) {
    int exponent = 0;
    auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    if (mantissa == 0) return;
    const int zeros = __builtin_ctzll(static_cast<unsigned long long>(mantissa));
    mantissa_ = mantissa >> zeros;  // exact: only zero bits are shifted out
    exponent_ = exponent - 53 + zeros;
  }
  Dyadic(int value) : mantissa_(value) {}
  Dyadic(std::uint64_t value) : mantissa_(value) {}
  Dyadic(Int128 value) : mantissa_(value) {}

  int sign() const { return mantissa_.sign(); }

  /// Nearest double, or close to it: for messages only.
  double approximate() const {
    if (mantissa_.is_zero()) return 0;
    Integer head = boost::multiprecision::abs(mantissa_);
    const int shift = static_cast<int>(boost::multiprecision::msb(head)) - 60;
    if (shift > 0) head >>= shift;
    const double value = std::ldexp(head.convert_to<double>(), exponent_ + std::max(shift, 0));
    return mantissa_.sign() < 0 ? -value : value;
  }

  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, 1); }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, -1); }
  friend bool operator<(const Dyadic& a, const Dyadic& b) { return (a - b).sign() < 0; }
  friend bool operator<=(const Dyadic& a, const Dyadic& b) { return (a - b).sign() <= 0; }
  friend bool operator==(const Dyadic& a, const Dyadic& b) { return (a - b).sign() == 0; }

 private:
  using Integer = boost::multiprecision::cpp_int;

  Dyadic(Integer mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  static Dyadic sum(const Dyadic& a, const Dyadic& b, int sign_b) {
    // The exponent of zero means nothing, so zero must not take part in the alignment of exponents.
    if (b.mantissa_.is_zero()) return a;
    if (a.mantissa_.is_zero()) return {sign_b * b.mantissa_, b.exponent_};
    const int exponent = std::min(a.exponent_, b.exponent_);
    return {(a.mantissa_ << (a.exponent_ - exponent)) + sign_b * (b.mantissa_ << (b.exponent_ - exponent)),
            exponent};
  }

  Integer mantissa_ = 0;
  int exponent_ = 0;
};

using ExactVector = std::array<Dyadic, 3>;

inline ExactVector exact(const Vector& a) { return {a[0], a[1], a[2]}; }
inline ExactVector operator+(const ExactVector& a, const ExactVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline ExactVector operator-(const ExactVector& a, const ExactVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline ExactVector operator*(const Dyadic& s, const ExactVector& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline Dyadic dot(const ExactVector& a, const ExactVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline ExactVector cross(const ExactVector& a, const ExactVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The plane a polygon segment is published on. The chart point (x, y), in grid steps, lies in the world at
/// q + step·(x·along_x + y·along_y).
struct ExactPlane {
  ExactVector q, along_x, along_y;
  ExactVector normal;  ///< along_x × along_y: points outwards, not a unit vector

  ExactPlane(const Polygon& polygon, double step)
      : q(exact(polygon.origin) + Dyadic(step) * Dyadic(polygon.h0) * exact(polygon.n)),
        along_x(exact(polygon.u) + Dyadic(polygon.hx) * exact(polygon.n)),
        along_y(exact(polygon.v) + Dyadic(polygon.hy) * exact(polygon.n)),
        normal(cross(along_x, along_y)) {}
};

}  // namespace limpet::audit
