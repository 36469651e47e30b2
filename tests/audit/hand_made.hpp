// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "models.hpp"

/// Models and mutations that break one law, or nearly do.
namespace limpet::audit {

inline const Names kNothing = {};

// The parts of everything().
inline Polygon& plate(Document& document) { return document.polygons[0]; }
inline Polygon& cube_face(Document& document, std::size_t i) { return document.polygons[1 + i]; }
inline Segment& point(Document& document) { return document.point_segments[0]; }

// The moments of two points 2n apart: variance n².
inline Moments apart(std::int64_t n) { return moments_of({{-n, 0, 0}, {n, 0, 0}}); }

inline void add_bare_point(Document& d, const Moments& moments) {
  Segment& segment = d.point_segments.emplace_back();
  segment.id = d.next_segment++;
  segment.moments = moments;
  d.points += moments.m;
  ++d.declared_points;
}

// Moments of m points about the origin.
inline Moments centred(std::uint64_t m, const std::array<Int128, 6>& product) {
  Moments moments;
  moments.m = m;
  moments.product = product;
  return moments;
}

// Two polygons, floor and wall; the shared edges are those that begin at the given chart points.
inline Document neighbours(const Outline& floor, const Outline& wall,
                           const std::vector<std::pair<Point, Point>>& shared,
                           const Frame& wall_frame = kEastWall) {
  Document d = empty_document();
  add_polygon(d, kFloor, {floor});
  add_polygon(d, wall_frame, {wall});
  for (const auto& [e, f] : shared) share(vertex_at(d, 0, e), vertex_at(d, 1, f));
  return d;
}

// A floor west of x = 0 and a wall below z = 0 that share one edge, the wall moved by whole steps.
inline Document roof(std::int64_t along = 0, std::int64_t up = 0, std::int64_t away = 0) {
  Frame wall = kEastWall;
  wall.origin = {away, along, up};
  return neighbours(rectangle(-800, 0, 0, 1000), rectangle(0, -800, 1000, 0), {{{0, 0}, {1000, 0}}}, wall);
}

// One segment that meets another at three edges, in the order 1, 3, 2 along their line.
inline Document twisted() {
  const Outline floor = scaled({{0, 0},
                                {0, 1},
                                {1, 1},
                                {1, 4},
                                {0, 4},
                                {0, 5},
                                {-1, 5},
                                {-1, 2},
                                {0, 2},
                                {0, 3},
                                {.5, 3},
                                {.5, 1.5},
                                {-2, 1.5},
                                {-2, 0}},
                               100);
  const Outline wall = scaled(
      {{0, -2}, {5, -2}, {5, 0}, {4, 0}, {4, -1}, {3, -1}, {3, 0}, {2, 0}, {2, -1}, {1, -1}, {1, 0}, {0, 0}},
      100);
  return neighbours(floor, wall, {{{0, 0}, {100, 0}}, {{0, 400}, {500, 0}}, {{0, 200}, {300, 0}}});
}

// A comb on a wall: three shared edges in the right order.
inline Document combs() {
  const Outline floor = scaled(
      {{0, 0}, {0, 1}, {-1, 1}, {-1, 2}, {0, 2}, {0, 3}, {-1, 3}, {-1, 4}, {0, 4}, {0, 5}, {-2, 5}, {-2, 0}},
      100);
  const Outline wall = scaled(
      {{0, -2}, {5, -2}, {5, 0}, {4, 0}, {4, -1}, {3, -1}, {3, 0}, {2, 0}, {2, -1}, {1, -1}, {1, 0}, {0, 0}},
      100);
  return neighbours(floor, wall, {{{0, 0}, {100, 0}}, {{0, 400}, {500, 0}}, {{0, 200}, {300, 0}}});
}

// A floor whose perimeter goes from the west wall to the east wall and back twice.
inline Document alternating() {
  Document d = empty_document();
  const Outline floor = scaled({{0, 9},
                                {0, 8},
                                {-1, 8},
                                {-1, 1},
                                {10, 1},
                                {10, 2},
                                {9, 5},
                                {0, 5},
                                {0, 4},
                                {-.5, 4},
                                {-.5, 6},
                                {9, 6},
                                {10, 8},
                                {10, 9}},
                               100);
  add_polygon(d, kFloor, {floor});
  add_polygon(d, kWestWall,
              {scaled({{-9, -2}, {-4, -2}, {-4, 0}, {-5, 0}, {-5, -1}, {-8, -1}, {-8, 0}, {-9, 0}}, 100)});
  Frame east = kEastWall;
  east.origin = {1000, 0, 0};
  add_polygon(d, east, {scaled({{1, -2}, {9, -2}, {9, 0}, {8, 0}, {8, -1}, {2, -1}, {2, 0}, {1, 0}}, 100)});
  share(vertex_at(d, 0, {0, 900}), vertex_at(d, 1, {-800, 0}));
  share(vertex_at(d, 0, {0, 500}), vertex_at(d, 1, {-400, 0}));
  share(vertex_at(d, 0, {1000, 100}), vertex_at(d, 2, {200, 0}));
  share(vertex_at(d, 0, {1000, 800}), vertex_at(d, 2, {900, 0}));
  return d;
}

// Two segments through each other, once convex and once concave.
inline Document both_concavities() {
  return neighbours(scaled({{-1, 0}, {0, 0}, {0, 1}, {1, 1}, {1, 3}, {0, 3}, {0, 2}, {-1, 2}}, 300),
                    scaled({{0, -1}, {2, -1}, {2, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 0}, {0, 0}}, 300),
                    {{{0, 0}, {300, 0}}, {{0, 900}, {600, 0}}});
}

}  // namespace limpet::audit
