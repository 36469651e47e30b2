// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <utility>

#include <limpet/geometry/types.hpp>

#include "property.hpp"

namespace limpet::geometry {

/// As text that can be put into a test.
inline std::ostream& operator<<(std::ostream& out, Point2 p) {
  return out << std::setprecision(17) << '{' << p.x << ',' << p.y << '}';
}

}  // namespace limpet::geometry

/// Chart points that nearly lie on one line, or do, or are one: what predicates are asked about.
namespace limpet::properties {

using geometry::Point2;

/// N points to be asked about together.
template <std::size_t N>
struct Points {
  std::array<Point2, N> at;
  Point2 operator[](std::size_t i) const { return at[i]; }
};

template <std::size_t N>
std::ostream& operator<<(std::ostream& out, const Points<N>& points) {
  const char* comma = "{";
  for (const Point2 p : points.at) out << comma << p, comma = ", ";
  return out << '}';
}

inline Point2 small_point(std::int64_t reach) {
  const auto x = static_cast<double>(about_zero(reach)), y = static_cast<double>(about_zero(reach));
  return {x, y};
}

namespace points_detail {

/// On a lattice of few points, so that any two may be one and any three collinear.
template <std::size_t N>
void on_lattice(std::array<Point2, N>& at) {
  for (Point2& p : at) p = small_point(3);
}

/// Multiples of one direction from one place, some of them a step off.
template <std::size_t N>
void on_line(std::array<Point2, N>& at) {
  const Point2 along = small_point(1000), from = small_point(1000);
  for (Point2& p : at) {
    const auto k = static_cast<double>(about_zero(20));
    p = from + k * along;
    if (one_of(3) == 2) p = p + small_point(1);
  }
}

/// Near the straight line between the first two, rounded.
template <std::size_t N>
void near_line(std::array<Point2, N>& at) {
  at[0] = small_point(1 << 30), at[1] = small_point(1 << 30);
  for (std::size_t i = 2; i < N; ++i) {
    const double t = static_cast<double>(about_zero(1000)) / 512;
    const Point2 p = at[0] + t * (at[1] - at[0]);
    at[i] = {std::floor(p.x), std::floor(p.y)};
    if (one_of(4) == 3) at[i] = at[static_cast<std::size_t>(one_of(2))];
  }
}

/// Corners of triangles of area one half, with sides as long as they come: as near to a line as the grid
/// allows.
template <std::size_t N>
void least_triangles(std::array<Point2, N>& at) {
  Point2 u{1, 0}, v{0, 1};
  for (auto n = whole(0, 16); n > 0; --n) {
    u = u + static_cast<double>(whole(1, 6)) * v;
    if (squared_length(u) > 0x1p60) break;
    std::swap(u, v);
  }
  for (std::size_t i = 0; i < N; ++i) {
    const auto k = static_cast<double>(about_zero(1)), l = static_cast<double>(about_zero(1));
    at[i] = i == 1 ? u : i == 2 ? v : i == 0 ? Point2{} : k * u + l * v;
  }
}

}  // namespace points_detail

/// Grid points below 2^50 steps: on few places, on a line, near one, or as near as can be, at three sizes: as
/// they are, in large steps (with or without a step between), and far from the origin.
template <std::size_t N>
rc::Gen<Points<N>> grid_points() {
  return rc::gen::exec([] {
    Points<N> points;
    const int kind = one_of(4);
    if (kind == 0) points_detail::on_lattice(points.at);
    if (kind == 1) points_detail::on_line(points.at);
    if (kind == 2) points_detail::near_line(points.at);
    if (kind == 3) points_detail::least_triangles(points.at);
    const int regime = one_of(4);
    const double scale = regime == 1 || regime == 2 ? power_of_two(0, 18) : 1;
    const Point2 place = regime == 3 ? power_of_two(20, 49) * small_point(1) : Point2{};
    for (Point2& p : points.at) {
      p = scale * p + place;
      if (regime == 2) p = p + small_point(1);
    }
    return points;
  });
}

/// Any finite doubles: grid points times powers of two from the smallest to the largest, one for all of them
/// or for each its own; with zeros, and the last bit of some changed.
template <std::size_t N>
rc::Gen<Points<N>> points_of_all_sizes() {
  return rc::gen::exec([] {
    Points<N> points = *grid_points<N>();
    const auto scaled = [](double x, double by) {
      const double y = x * by;
      return std::isfinite(y) ? y : std::copysign(std::numeric_limits<double>::max(), x);
    };
    const bool alike = one_of(2) == 0;
    double by = power_of_two(-1074, 1000);
    for (Point2& p : points.at) {
      if (!alike) by = power_of_two(-1074, 1000);
      p = {scaled(p.x, by), scaled(p.y, by)};
      const int change = one_of(6);
      if (change == 4) p.x = std::nextafter(p.x, 0);
      if (change == 5) p.y = std::nextafter(p.y, 0);
    }
    return points;
  });
}

}  // namespace limpet::properties
