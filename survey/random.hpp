// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cmath>
#include <cstdint>

namespace limpet::survey {

/// The last step of splitmix64: each bit of the result depends on all of the word.
inline std::uint64_t mixed(std::uint64_t word) {
  word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9u;
  word = (word ^ (word >> 27)) * 0x94d049bb133111ebu;
  return word ^ (word >> 31);
}

/// A small random generator (xoshiro256**, seeded by splitmix64) whose numbers are the same on every
/// machine: the standard library's distributions are not, and neither is libm's log, so only + − × ÷ √ are
/// used.
class Random {
 public:
  explicit Random(std::uint64_t seed) {
    for (std::uint64_t& word : state_) {
      seed += 0x9e3779b97f4a7c15u;
      word = mixed(seed);
    }
  }

  std::uint64_t next() {
    const std::uint64_t result = rotated(state_[1] * 5, 7) * 9;
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = rotated(state_[3], 45);
    return result;
  }

  /// Uniform in [0, 1), a multiple of 2⁻⁵³.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Uniform in 0 … count − 1. Precondition: count > 0.
  std::uint64_t below(std::uint64_t count) {
    const std::uint64_t reject = (0 - count) % count;  // 2⁶⁴ mod count: the part that would be unfair
    for (;;) {
      const std::uint64_t word = next();
      if (word >= reject) return word % count;
    }
  }

  /// Normally distributed, mean 0 and standard deviation 1 (Marsaglia's polar method).
  double normal() {
    for (;;) {
      const double x = uniform(-1, 1);
      const double y = uniform(-1, 1);
      const double s = x * x + y * y;
      if (s > 0 && s < 1) return x * std::sqrt(-2 * logarithm(s) / s);
    }
  }

 private:
  static std::uint64_t rotated(std::uint64_t word, int by) { return (word << by) | (word >> (64 - by)); }

  /// log x by the series of 2·artanh((m − 1)/(m + 1)), x = m·2ᵉ, to about 1e-16.
  static double logarithm(double x) {
    int exponent = 0;
    double m = std::frexp(x, &exponent);  // exact
    if (m < 0.7071067811865476) {
      m *= 2;
      --exponent;
    }
    const double t = (m - 1) / (m + 1);
    double sum = 0;
    for (int k = 21; k >= 1; k -= 2) sum = sum * (t * t) + 1.0 / k;
    return 2 * t * sum + exponent * 0.6931471805599453;
  }

  std::uint64_t state_[4];
};

}  // namespace limpet::survey
