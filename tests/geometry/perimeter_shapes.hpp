// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <limpet/geometry/polygon.hpp>

/// Degenerate polygons to operate on: coincident and collinear edges, slivers, combs, spirals, rings.
namespace limpet::shapes {

using geometry::NewVertex;
using geometry::Point2;
using Cycles = std::vector<std::vector<NewVertex>>;

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

inline std::vector<NewVertex> cycle_of(std::initializer_list<Point2> points) {
  std::vector<NewVertex> result;
  for (const Point2 p : points) result.push_back({p});
  return result;
}

inline std::vector<NewVertex> rectangle(double x0, double y0, double x1, double y1) {
  return cycle_of({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

inline std::vector<NewVertex> reversed(std::vector<NewVertex> cycle) {
  return {cycle.rbegin(), cycle.rend()};
}

/// The outline of a connected set of grid cells, holes included, vertices at every cell corner or at the
/// turns.
inline Cycles blob(Random& random, int side) {
  const int n = side + 2;
  std::vector<char> full(static_cast<std::size_t>(n * n));
  const auto at = [&](int x, int y) -> char& { return full[static_cast<std::size_t>(y * n + x)]; };
  int x = n / 2, y = n / 2;
  for (std::int64_t k = random.whole(1, side * side); k >= 0; --k) {
    at(x, y) = 1;
    (random.chance(0.5) ? x : y) += random.chance(0.5) ? 1 : -1;
    x = std::min(std::max(x, 1), side), y = std::min(std::max(y, 1), side);
  }
  constexpr int kDx[] = {1, 0, -1, 0}, kDy[] = {0, 1, 0, -1};
  // Is the cell left of (or right of) the lattice edge from (x, y) in this direction full?
  const auto cell = [&](int cx, int cy, int d, bool left) {
    const int ox = left ? (d == 0 || d == 3 ? 0 : -1) : (d == 0 || d == 1 ? 0 : -1);
    const int oy = left ? (d == 0 || d == 1 ? 0 : -1) : (d == 1 || d == 2 ? 0 : -1);
    const int px = cx + ox, py = cy + oy;
    return px >= 0 && py >= 0 && px < n && py < n && at(px, py) != 0;
  };
  const auto boundary = [&](int cx, int cy, int d) {
    return cell(cx, cy, d, true) && !cell(cx, cy, d, false);
  };
  std::vector<char> done(static_cast<std::size_t>((n + 1) * (n + 1) * 4));
  const bool all_corners = random.chance(0.4);
  Cycles cycles;
  for (int sy = 0; sy <= n; ++sy)
    for (int sx = 0; sx <= n; ++sx)
      for (int sd = 0; sd < 4; ++sd) {
        if (!boundary(sx, sy, sd)) continue;
        std::vector<NewVertex> cycle;
        int cx = sx, cy = sy, d = sd, before = -1;
        for (;;) {
          char& mark = done[static_cast<std::size_t>((cy * (n + 1) + cx) * 4 + d)];
          if (mark) break;
          mark = 1;
          if (all_corners || d != before)
            cycle.push_back({{static_cast<double>(cx), static_cast<double>(cy)}});
          before = d;
          cx += kDx[d], cy += kDy[d];
          for (const int turn : {1, 0, 3})
            if (boundary(cx, cy, (d + turn) % 4)) {
              d = (d + turn) % 4;
              break;
            }
        }
        if (cycle.size() > 2) cycles.push_back(std::move(cycle));
      }
  return cycles;  // the lowest cycle comes first: the outer one
}

inline Cycles comb(Random& random) {
  const double tooth = static_cast<double>(random.whole(1, 4)),
               slit = static_cast<double>(random.whole(1, 4));
  const double depth = static_cast<double>(random.whole(2, 40)),
               spine = static_cast<double>(random.whole(1, 3));
  const auto teeth = static_cast<int>(random.whole(2, 30));
  std::vector<NewVertex> cycle{{{0, 0}}};
  double x = teeth * tooth + (teeth - 1) * slit;
  cycle.push_back({{x, 0}});
  for (int k = 0; k < teeth; ++k) {
    cycle.push_back({{x, spine + depth}}), cycle.push_back({{x - tooth, spine + depth}});
    if (k + 1 == teeth) break;
    cycle.push_back({{x - tooth, spine}}), cycle.push_back({{x - tooth - slit, spine}});
    x -= tooth + slit;
  }
  return {cycle};
}

inline Cycles spiral(Random& random) {
  const auto turns = static_cast<int>(random.whole(4, 24));
  const double pitch = static_cast<double>(random.whole(2, 6)),
               width = static_cast<double>(random.whole(1, 1));
  std::vector<Point2> outer{{0, 0}}, inner;
  Point2 p{0, 0};
  constexpr double kDx[] = {1, 0, -1, 0}, kDy[] = {0, 1, 0, -1};
  for (int k = 0; k < turns; ++k) {
    const double length = pitch * (k / 2 + 1);
    p = {p.x + kDx[k % 4] * length, p.y + kDy[k % 4] * length};
    outer.push_back(p);
  }
  // The arm lies on the left of the way out; its inner side is the way moved to the left at every corner.
  for (int k = 0; k <= turns; ++k) {
    const int in = k == 0 ? 0 : (k - 1) % 4, out = k == turns ? (k - 1) % 4 : k % 4;
    Point2 q = outer[static_cast<std::size_t>(k)];
    const auto left = [&](int d) { return Point2{-kDy[d] * width, kDx[d] * width}; };
    q = q + left(in);
    if (in != out) q = q + left(out);
    inner.push_back(q);
  }
  std::vector<NewVertex> cycle;
  for (const Point2 v : outer) cycle.push_back({v});
  for (auto v = inner.rbegin(); v != inner.rend(); ++v) cycle.push_back({*v});
  return {cycle};
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
      return {rectangle(0, 0, 2 * o + i, 2 * o + i), reversed(rectangle(o, o, o + i, o + i))};
    }
    case 8: {  // a ring with a slit
      const double o = 1 + small(3), i = 2 + small(8), s = 1 + small(1);
      return {cycle_of({{0, 0},
                        {2 * o + i, 0},
                        {2 * o + i, 2 * o + i},
                        {o + s, 2 * o + i},
                        {o + s, o + i},
                        {o + i, o + i},
                        {o + i, o},
                        {o, o},
                        {o, 2 * o + i},
                        {0, 2 * o + i}})};
    }
    default:
      return {rectangle(0, 0, 1 + small(9), 1 + small(9))};
  }
}

/// Maps of the plane with whole coefficients: turns, shears that make near-parallel lines, scale, place.
struct Map {
  double a = 1, b = 0, c = 0, d = 1, x = 0, y = 0;
  Point2 operator()(Point2 p) const { return {a * p.x + b * p.y + x, c * p.x + d * p.y + y}; }
};

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

inline void map_all(Cycles& cycles, const Map& map) {
  for (auto& cycle : cycles)
    for (NewVertex& v : cycle) v.at = map(v.at);
}

}  // namespace limpet::shapes
