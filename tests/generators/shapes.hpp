// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <limpet/geometry/polygon.hpp>

/// Degenerate polygons as functions of a few small whole numbers: coincident and collinear edges, slivers,
/// combs, spirals, rings, holes a step apart. Valid where nothing else is said.
namespace limpet::shapes {

using geometry::NewVertex;
using geometry::Point2;
using Cycles = std::vector<std::vector<NewVertex>>;

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

/// A set of full cells, n to a row, none of them in the outermost rows and columns.
struct Cells {
  explicit Cells(int side) : n(side), full(slot(0, n)) {}
  char& at(int x, int y) { return full[slot(x, y)]; }
  char at(int x, int y) const { return full[slot(x, y)]; }
  std::size_t slot(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(n) + static_cast<std::size_t>(x);
  }
  int n;
  std::vector<char> full;
};

/// The outline of a set of cells, connected by their sides, holes included; vertices at every cell corner or
/// at the turns. Not valid where cells touch in a corner.
inline Cycles outline_of(const Cells& cells, bool all_corners) {
  const int n = cells.n;
  constexpr int kDx[] = {1, 0, -1, 0}, kDy[] = {0, 1, 0, -1};
  // Is the cell left of (or right of) the lattice edge from (x, y) in this direction full?
  const auto cell = [&](int cx, int cy, int d, bool left) {
    const int ox = left ? (d == 0 || d == 3 ? 0 : -1) : (d == 0 || d == 1 ? 0 : -1);
    const int oy = left ? (d == 0 || d == 1 ? 0 : -1) : (d == 1 || d == 2 ? 0 : -1);
    const int px = cx + ox, py = cy + oy;
    return px >= 0 && py >= 0 && px < n && py < n && cells.at(px, py) != 0;
  };
  const auto boundary = [&](int cx, int cy, int d) {
    return cell(cx, cy, d, true) && !cell(cx, cy, d, false);
  };
  const auto side = static_cast<std::size_t>(n) + 1;
  std::vector<char> done(side * side * 4);
  Cycles cycles;
  for (int sy = 0; sy <= n; ++sy)
    for (int sx = 0; sx <= n; ++sx)
      for (int sd = 0; sd < 4; ++sd) {
        if (!boundary(sx, sy, sd)) continue;
        std::vector<NewVertex> cycle;
        int cx = sx, cy = sy, d = sd, before = -1;
        for (;;) {
          char& mark = done[(static_cast<std::size_t>(cy) * side + static_cast<std::size_t>(cx)) * 4 +
                            static_cast<std::size_t>(d)];
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

inline Cycles comb(int teeth, double tooth, double slit, double depth, double spine) {
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

inline Cycles spiral(int turns, double pitch, double width) {
  std::vector<Point2> outer{{0, 0}}, inner;
  Point2 p{0, 0};
  constexpr double kDx[] = {1, 0, -1, 0}, kDy[] = {0, 1, 0, -1};
  for (int k = 0; k < turns; ++k) {
    const int round = k / 2;
    const double length = pitch * (round + 1);
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

inline Cycles ring(double wall, double bore) {
  const double side = 2 * wall + bore;
  return {rectangle(0, 0, side, side), reversed(rectangle(wall, wall, wall + bore, wall + bore))};
}

/// A ring cut open by a slit of this width.
inline Cycles slit_ring(double wall, double bore, double slit) {
  const double side = 2 * wall + bore;
  return {cycle_of({{0, 0},
                    {side, 0},
                    {side, side},
                    {wall + slit, side},
                    {wall + slit, wall + bore},
                    {wall + bore, wall + bore},
                    {wall + bore, wall},
                    {wall, wall},
                    {wall, side},
                    {0, side}})};
}

/// About the origin, in sixteen directions as many times as there are radii; radii from 1.
inline Cycles star(const std::vector<std::int64_t>& radii) {
  static constexpr std::array<std::array<int, 2>, 16> kDirections = {{{1, 0},
                                                                      {2, 1},
                                                                      {1, 1},
                                                                      {1, 2},
                                                                      {0, 1},
                                                                      {-1, 2},
                                                                      {-1, 1},
                                                                      {-2, 1},
                                                                      {-1, 0},
                                                                      {-2, -1},
                                                                      {-1, -1},
                                                                      {-1, -2},
                                                                      {0, -1},
                                                                      {1, -2},
                                                                      {1, -1},
                                                                      {2, -1}}};
  std::vector<NewVertex> cycle;
  const std::size_t n = radii.size() < 4 ? radii.size() : radii.size() < 16 ? radii.size() : 16;
  for (std::size_t k = 0; k < n; ++k) {
    const auto& d = kDirections[16 * k / n];
    const auto r = static_cast<double>(radii[k]);
    cycle.push_back({{r * d[0], r * d[1]}});
  }
  return {cycle};
}

/// Blades that meet in one point, parallel but for a step.
inline Cycles fan(int blades, double notch) {
  std::vector<NewVertex> cycle{{{0, 0}}};
  for (int i = 0; i < blades; ++i) {
    cycle.push_back({{2 * notch, 4.0 * i}});
    if (i + 1 < blades) cycle.push_back({{notch, 2.0 * i + 1}});
  }
  if (blades == 1) cycle.push_back({{2 * notch, 1}});
  return {cycle};
}

/// `rise` steps high at its foot, its tip `lift` steps above the foot's line.
inline Cycles needle(double length, double rise, double lift) {
  return {cycle_of({{0, 0}, {length, lift}, {0, rise}})};
}

/// Stairs one step high, and one step from the straight line below them.
inline Cycles staircase(int steps) {
  std::vector<NewVertex> cycle;
  for (int k = 0; k < steps; ++k) {
    const double x = k;
    cycle.push_back({{x, x}}), cycle.push_back({{x + 1, x}});
  }
  const double end = steps;
  cycle.push_back({{end, end}}), cycle.push_back({{end, end + 1}}), cycle.push_back({{0, 1}});
  return {cycle};
}

/// A chain along a line with these distances from it, and the same chain again `thickness` above, or two
/// corners there. Two distances or more.
inline Cycles near_line(const std::vector<std::int64_t>& off, double stride, double thickness, bool twice) {
  std::vector<NewVertex> cycle;
  const auto at = [&](std::size_t i) {
    return Point2{stride * static_cast<double>(i), static_cast<double>(off[i])};
  };
  for (std::size_t i = 0; i < off.size(); ++i) cycle.push_back({at(i)});
  for (std::size_t i = off.size(); i-- > 0;)
    if (twice || i == 0 || i + 1 == off.size()) {
      const double y = twice ? static_cast<double>(off[i]) : 2;
      cycle.push_back({{at(i).x, y + thickness}});
    }
  return {cycle};
}

/// Square holes in rows, `wall` apart and `border` from the perimeter.
inline Cycles sieve(int columns, int rows, double hole, double wall, double border) {
  const auto extent = [&](int n) { return 2 * border + n * hole + (n - 1) * wall; };
  Cycles cycles{rectangle(0, 0, extent(columns), extent(rows))};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = border + i * (hole + wall), y = border + j * (hole + wall);
      cycles.push_back(reversed(rectangle(x, y, x + hole, y + hole)));
    }
  return cycles;
}

/// Holes about holes: each but the innermost runs round the next, but for a neck one step wide.
inline Cycles nest(int depth, double wall, double slit) {
  const double side = 2 * depth * (wall + slit) + 5;
  Cycles cycles{rectangle(0, 0, side, side)};
  double a = wall;
  const double m = depth * (wall + slit) + 2;  // the neck is from m to m + 1
  for (int k = 1; k < depth; ++k, a += slit + wall) {
    const double b = a + slit, s = side;
    cycles.push_back(reversed(cycle_of({{s - a, m + 1},
                                        {s - a, s - a},
                                        {a, s - a},
                                        {a, a},
                                        {s - a, a},
                                        {s - a, m},
                                        {s - b, m},
                                        {s - b, b},
                                        {b, b},
                                        {b, s - b},
                                        {s - b, s - b},
                                        {s - b, m + 1}})));
  }
  cycles.push_back(reversed(rectangle(a, a, side - a, side - a)));
  return cycles;
}

/// Maps of the plane with whole coefficients: turns, shears that make near-parallel lines, scale, place.
struct Map {
  double a = 1, b = 0, c = 0, d = 1, x = 0, y = 0;
  Point2 operator()(Point2 p) const { return {a * p.x + b * p.y + x, c * p.x + d * p.y + y}; }
};

inline Map translation(Point2 by) { return {1, 0, 0, 1, by.x, by.y}; }
inline constexpr Map kQuarterTurn{0, -1, 1, 0, 0, 0};
inline constexpr Map kMirror{-1, 0, 0, 1, 0, 0};

inline void map_all(Cycles& cycles, const Map& map) {
  for (auto& cycle : cycles)
    for (NewVertex& v : cycle) v.at = map(v.at);
}
inline Cycles mapped(Cycles cycles, const Map& map) {
  map_all(cycles, map);
  return cycles;
}

}  // namespace limpet::shapes
