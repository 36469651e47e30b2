// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "../generators/shapes.hpp"

/// Degenerate polygons at random, from seeds that stay what they are.
namespace limpet::shapes {

/// Points, identities and flags alike.
inline bool same(const Cycles& a, const Cycles& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& c, const auto& d) {
    return std::equal(c.begin(), c.end(), d.begin(), d.end(), [](const NewVertex& v, const NewVertex& w) {
      return v.at == w.at && v.edge == w.edge && v.shared == w.shared;
    });
  });
}

/// The same numbers on every machine (the standard's distributions are not). Made of bytes, it takes its
/// choices from them, as few bytes as will do, until they end: so a fuzzer that changes bytes changes
/// choices.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  explicit Random(std::span<const std::uint8_t> bytes) : state_(bytes.size()), bytes_(bytes) {}
  std::uint64_t bits() {
    if (!bytes_.empty()) return taken(8);
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// A whole number from `low` to `high`.
  std::int64_t whole(std::int64_t low, std::int64_t high) {
    const auto count = static_cast<std::uint64_t>(high - low + 1);
    const std::uint64_t any = bytes_.empty() ? bits() : taken(count <= 256 ? 1 : count <= 65536 ? 2 : 8);
    return low + static_cast<std::int64_t>(any % count);
  }
  double unit() {
    return bytes_.empty() ? static_cast<double>(bits() >> 11) * 0x1p-53
                          : static_cast<double>(taken(2)) * 0x1p-16;
  }
  /// Bytes left to choose by.
  std::size_t left() const { return bytes_.size(); }
  bool chance(double p) { return unit() < p; }
  /// Every order of magnitude alike.
  double scale(double low, double high) { return low * std::pow(high / low, unit()); }

 private:
  std::uint64_t taken(std::size_t count) {
    std::uint64_t value = 0;
    for (; count > 0 && !bytes_.empty(); --count, bytes_ = bytes_.subspan(1)) value = value << 8 | bytes_[0];
    return value;
  }

  std::uint64_t state_;
  std::span<const std::uint8_t> bytes_;
};

/// The outline of a connected set of grid cells, holes included, vertices at every cell corner or at the
/// turns.
inline Cycles blob(Random& random, int side) {
  Cells cells(side + 2);
  int x = cells.n / 2, y = cells.n / 2;
  for (std::int64_t k = random.whole(1, side * side); k >= 0; --k) {
    cells.at(x, y) = 1;
    (random.chance(0.5) ? x : y) += random.chance(0.5) ? 1 : -1;
    x = std::min(std::max(x, 1), side), y = std::min(std::max(y, 1), side);
  }
  return outline_of(cells, random.chance(0.4));
}

inline Cycles comb(Random& random) {
  const double tooth = static_cast<double>(random.whole(1, 4)),
               slit = static_cast<double>(random.whole(1, 4));
  const double depth = static_cast<double>(random.whole(2, 40)),
               spine = static_cast<double>(random.whole(1, 3));
  return comb(static_cast<int>(random.whole(2, 30)), tooth, slit, depth, spine);
}

inline Cycles spiral(Random& random) {
  const auto turns = static_cast<int>(random.whole(4, 24));
  const double pitch = static_cast<double>(random.whole(2, 6)),
               width = static_cast<double>(random.whole(1, 1));
  return spiral(turns, pitch, width);
}

inline Cycles star(Random& random, int vertices, double radius) {
  std::vector<NewVertex> cycle;
  const double rough = random.chance(0.5) ? 0.1 : 0.8;
  for (int k = 0; k < vertices; ++k) {
    const double angle = 2 * 3.14159265358979 * k / vertices, r = radius * (1 - rough * random.unit());
    cycle.push_back({{std::round(r * std::cos(angle)), std::round(r * std::sin(angle))}});
  }
  return {cycle};
}

/// A shape in small whole coordinates; not always valid.
inline Cycles raw_shape(Random& random) {
  const auto small = [&](std::int64_t high) { return static_cast<double>(random.whole(0, high)); };
  switch (random.whole(0, 9)) {
    case 0:
      return blob(random, 3);
    case 1:
      return blob(random, static_cast<int>(random.whole(3, 16)));
    case 2:
      return comb(random);
    case 3:
      return spiral(random);
    case 4:
      return star(random, static_cast<int>(random.whole(3, 60)), random.scale(4, 1000));
    case 5: {  // a triangle in a tiny range
      return {cycle_of({{small(6), small(6)}, {small(6), small(6)}, {small(6), small(6)}})};
    }
    case 6: {  // a sliver one step wide
      const double l = random.scale(2, 10000);
      return {cycle_of({{0, 0}, {std::floor(l), small(2)}, {std::floor(l), 3}, {small(3) - 1, 1}})};
    }
    case 7: {  // a ring
      const double o = 1 + small(3), i = 1 + small(8);
      return ring(o, i);
    }
    case 8: {  // a ring with a slit
      const double o = 1 + small(3), i = 2 + small(8), s = 1 + small(1);
      return slit_ring(o, i, s);
    }
    default:
      return {rectangle(0, 0, 1 + small(9), 1 + small(9))};
  }
}

inline Map random_map(Random& random, double scale, double place) {
  Map m;
  const double s = std::max(1.0, std::floor(scale));
  switch (random.whole(0, 4)) {
    case 0:
      m = {0, -s, s, 0};
      break;
    case 1: {
      const double k = static_cast<double>(random.whole(1, 50));
      m = {s, s * k, 0, s};
      break;
    }
    case 2: {
      const double k = static_cast<double>(random.whole(1, 5));
      m = {s * k, -s, s, s * k};
      break;
    }
    default:
      m = {s, 0, 0, s};
  }
  m.x = std::floor((2 * random.unit() - 1) * place), m.y = std::floor((2 * random.unit() - 1) * place);
  return m;
}

}  // namespace limpet::shapes
