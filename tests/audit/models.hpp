// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <limpet/audit/laws.hpp>
#include <limpet/audit/planar.hpp>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

/// Small models made by hand for the tests of the oracle.
namespace limpet::audit {

using Whole = std::array<std::int64_t, 3>;
using Outline = std::vector<Point>;

inline constexpr double kStep = 0x1p-10;
inline constexpr double kResolution = 0.25;  // 256 steps
inline constexpr std::int64_t kResolutionSteps = 256;

/// A random engine whose seed stands in the log of a failing test.
class SeededTest : public ::testing::Test {
 protected:
  SeededTest() { RecordProperty("seed", std::to_string(seed_)); }
  std::int64_t uniform(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }
  double uniform_whole(std::int64_t low, std::int64_t high) {
    return static_cast<double>(uniform(low, high));
  }
  Point uniform_point(std::int64_t low, std::int64_t high) {
    const double x = uniform_whole(low, high);
    return {x, uniform_whole(low, high)};
  }

  // --gtest_random_seed=N tries another; without it every run is the same.
  const std::int64_t seed_ = GTEST_FLAG_GET(random_seed) != 0 ? GTEST_FLAG_GET(random_seed) : 20240229;
  ::testing::ScopedTrace trace_{__FILE__, __LINE__, "seed " + std::to_string(seed_)};
  std::mt19937_64 random_{static_cast<std::uint64_t>(seed_)};
};

/// A chart with whole axes; its origin in grid steps.
struct Frame {
  Whole origin{0, 0, 0};
  Whole u{1, 0, 0}, v{0, 1, 0}, n{0, 0, 1};
};

inline constexpr Frame kFloor = {};
inline constexpr Frame kEastWall = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
inline constexpr Frame kWestWall = {{0, 0, 0}, {0, -1, 0}, {0, 0, 1}, {-1, 0, 0}};

inline Vector real(const Whole& a) {
  return {static_cast<double>(a[0]), static_cast<double>(a[1]), static_cast<double>(a[2])};
}

inline Moments moments_of(const std::vector<Whole>& points) {
  Moments moments;
  moments.m = points.size();
  for (const Whole& p : points) {
    int k = 0;
    for (int i = 0; i < 3; ++i) {
      moments.sum[i] += p[i];
      for (int j = i; j < 3; ++j) moments.product[k++] += static_cast<Int128>(p[i]) * p[j];
    }
  }
  return moments;
}

inline Document empty_document() {
  Document document;
  document.resolution = kResolution;
  document.angle = 0.1;
  document.noise = 0.001;
  document.tolerance = 0.05;
  document.step = kStep;
  document.rules = "thesis";
  document.next_segment = document.next_edge = 1;
  return document;
}

/// The points' sensing axes are all `axis`.
inline void set_points(Document& document, Segment& segment, const std::vector<Whole>& points,
                       const Vector& axis) {
  document.points += points.size() - segment.moments.m;
  segment.moments = moments_of(points);
  for (int i = 0; i < 3; ++i) segment.axis_sum[i] = static_cast<double>(points.size()) * axis[i];
}

inline Segment& add_point(Document& document, const std::vector<Whole>& points) {
  Segment& segment = document.point_segments.emplace_back();
  ++document.declared_points;
  segment.id = document.next_segment++;
  set_points(document, segment, points, {0, 0, -1});
  for (const Whole& p : points) segment.raw.push_back({real(p), {0, 0, -1}, 0});
  return segment;
}

inline Cycle cycle_of(Document& document, const Outline& outline) {
  Cycle cycle;
  for (const Point& p : outline) cycle.push_back({p.x, p.y, document.next_edge++, 0});
  return cycle;
}

/// A polygon on the chart's plane; the vertices of its outer cycle are its sensor points.
inline Polygon& add_polygon(Document& document, const Frame& frame, const std::vector<Outline>& cycles) {
  Polygon& polygon = document.polygons.emplace_back();
  ++document.declared_polygons;
  polygon.id = document.next_segment++;
  for (int i = 0; i < 3; ++i) polygon.origin[i] = kStep * static_cast<double>(frame.origin[i]);
  polygon.u = real(frame.u);
  polygon.v = real(frame.v);
  polygon.n = polygon.initial_normal = real(frame.n);
  std::vector<Whole> points;
  for (const Point& p : cycles[0]) {
    Whole& point = points.emplace_back();
    for (int i = 0; i < 3; ++i)
      point[i] = frame.origin[i] + static_cast<std::int64_t>(p.x) * frame.u[i] +
                 static_cast<std::int64_t>(p.y) * frame.v[i];
  }
  set_points(document, polygon, points, {-polygon.n[0], -polygon.n[1], -polygon.n[2]});
  for (const Outline& outline : cycles) polygon.cycles.push_back(cycle_of(document, outline));
  return polygon;
}

inline Outline rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}
inline Outline reversed(Outline outline) { return {outline.rbegin(), outline.rend()}; }
inline Outline scaled(Outline outline, double by) {
  for (Point& p : outline) p = {by * p.x, by * p.y};
  return outline;
}

inline Document document_of(const std::vector<Outline>& cycles, const Frame& frame = {}) {
  Document document = empty_document();
  add_polygon(document, frame, cycles);
  return document;
}

inline void share(Vertex& e, Vertex& f) {
  e.partner = f.edge;
  f.partner = e.edge;
}

/// The vertex of polygon s, outer cycle, at chart point p.
inline Vertex& vertex_at(Document& document, std::size_t s, const Point& p) {
  for (Vertex& vertex : document.polygons[s].cycles[0])
    if (vertex.x == p.x && vertex.y == p.y) return vertex;
  throw std::logic_error("no such vertex");
}

/// A cube with all twelve edges shared and eight corners.
inline void add_cube(Document& document, const Whole& origin, double side) {
  const auto far = static_cast<std::int64_t>(side);
  const std::size_t first = document.polygons.size();
  for (int axis = 0; axis < 3; ++axis)
    for (const int sign : {1, -1}) {
      Frame frame{origin, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
      if (sign > 0) frame.origin[axis] += far;
      frame.n[axis] = sign;
      frame.u[(axis + (sign > 0 ? 1 : 2)) % 3] = 1;
      frame.v[(axis + (sign > 0 ? 2 : 1)) % 3] = 1;
      add_polygon(document, frame, {rectangle(0, 0, side, side)});
    }
  const auto corner = [&](std::size_t s, std::size_t i) {
    const Polygon& polygon = document.polygons[s];
    const Vertex& p = polygon.cycles[0][i % 4];
    Vector at = polygon.origin;
    for (int k = 0; k < 3; ++k) at[k] += kStep * (p.x * polygon.u[k] + p.y * polygon.v[k]);
    return at;
  };
  for (std::size_t s = first; s < first + 6; ++s)
    for (std::size_t t = s + 1; t < first + 6; ++t)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
          if (corner(s, i) == corner(t, j + 1) && corner(s, i + 1) == corner(t, j))
            share(document.polygons[s].cycles[0][i], document.polygons[t].cycles[0][j]);
}

/// A valid model with something of everything: segment 1 is a point, 2 a plate with two holes, 3 to 8 a cube.
inline Document everything() {
  Document document = empty_document();
  add_point(document, {{5000, 0, 0}, {5010, 20, -7}, {4990, 3, 9}});
  add_polygon(document, {{0, -9000, 77}},
              {rectangle(0, 0, 1000, 1000), reversed(rectangle(100, 100, 300, 300)),
               reversed(rectangle(500, 500, 900, 900))});
  add_cube(document, {-3000, 40, 900}, 1000);
  document.expired = 4;
  document.points += 4;
  return document;
}

using Names = std::set<std::string>;

/// The laws a model breaks.
inline Names broken(const Document& document) {
  Names names;
  for (const Violation& violation : judge(document)) names.insert(violation.law);
  return names;
}

/// The native file of a document.
inline std::string text_of(const Document& document) {
  std::ostringstream out;
  const auto real_text = [](double x) {
    char buffer[64];
    return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr);
  };
  const auto whole_text = [](Int128 x) {
    std::string digits;
    const bool negative = x < 0;
    do {
      const int digit = static_cast<int>(x % 10);
      digits.insert(digits.begin(), static_cast<char>('0' + (digit < 0 ? -digit : digit)));
      x /= 10;
    } while (x != 0);
    return (negative ? "-" : "") + digits;
  };
  const auto vector_text = [&](const Vector& a) {
    return ' ' + real_text(a[0]) + ' ' + real_text(a[1]) + ' ' + real_text(a[2]);
  };
  const auto segment_text = [&](const char* keyword, const Segment& segment) {
    out << keyword << ' ' << segment.id << ' ' << segment.moments.m;
    for (const Int128 x : segment.moments.sum) out << ' ' << whole_text(x);
    for (const Int128 x : segment.moments.product) out << ' ' << whole_text(x);
    out << vector_text(segment.axis_sum) << '\n';
  };
  const auto raw_text = [&](const Segment& segment) {
    out << "raw " << segment.raw.size() << '\n';
    for (const RawPoint& point : segment.raw)
      out << vector_text(point.position).substr(1) << vector_text(point.axis) << ' ' << point.returned
          << '\n';
  };
  const char* arithmetic[] = {"exact", "float-grid", "float"};
  out << "limpet 1\nresolution " << real_text(document.resolution) << "\nangle " << real_text(document.angle)
      << "\nnoise " << real_text(document.noise) << "\ntolerance " << real_text(document.tolerance)
      << "\ngrid " << real_text(document.step) << "\narithmetic "
      << arithmetic[static_cast<int>(document.arithmetic)] << "\nrules " << document.rules << "\ncounts "
      << document.points << ' ' << document.refused << ' ' << document.expired << ' ' << document.sets
      << "\nnext " << document.next_segment << ' ' << document.next_edge << "\nsegments "
      << document.declared_points << ' ' << document.declared_polygons << '\n';
  for (const Segment& segment : document.point_segments) {
    segment_text("point", segment);
    raw_text(segment);
  }
  for (const Polygon& polygon : document.polygons) {
    segment_text("polygon", polygon);
    out << "chart" << vector_text(polygon.origin) << vector_text(polygon.u) << vector_text(polygon.v)
        << vector_text(polygon.n) << "\nheight " << real_text(polygon.h0) << ' ' << real_text(polygon.hx)
        << ' ' << real_text(polygon.hy) << "\ninitial" << vector_text(polygon.initial_centroid)
        << vector_text(polygon.initial_normal);
    if (polygon.confirmed > 0) out << "\nconfirmed " << polygon.confirmed;
    out << "\ncycles " << polygon.cycles.size() << '\n';
    for (const Cycle& cycle : polygon.cycles) {
      out << "cycle " << cycle.size() << '\n';
      for (const Vertex& p : cycle)
        out << real_text(p.x) << ' ' << real_text(p.y) << ' ' << p.edge << ' ' << p.partner << '\n';
    }
    raw_text(polygon);
  }
  out << "end\n";
  return out.str();
}

}  // namespace limpet::audit
