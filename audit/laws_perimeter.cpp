// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limpet/audit/laws_internal.hpp>
#include <limpet/audit/planar.hpp>
#include <limpet/audit/sweep.hpp>

namespace limpet::audit::internal {
namespace {

struct Box {
  Point low, high;
};

Box box_of(const std::vector<Point>& cycle) {
  Box box{cycle[0], cycle[0]};
  for (const Point& p : cycle) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

bool is_in(const Point& p, const Box& box) {
  return box.low.x <= p.x && p.x <= box.high.x && box.low.y <= p.y && p.y <= box.high.y;
}

// A polygon's cycles with edges of zero length left out, and cycles of fewer than three other vertices too;
// the sweep that looks for crossings requires that. For each cycle and vertex its index in the polygon.
struct Outline {
  std::vector<std::vector<Point>> cycles;
  std::vector<std::size_t> cycle_of;
  std::vector<std::vector<std::size_t>> vertex_of;
  bool whole = true;  // no cycle was left out
};

Outline outline_of(const Polygon& polygon) {
  Outline outline;
  for (std::size_t c = 0; c < polygon.cycles.size(); ++c) {
    const Cycle& cycle = polygon.cycles[c];
    std::vector<Point> points;
    std::vector<std::size_t> origins;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const Vertex& next = cycle[(i + 1) % cycle.size()];
      if (cycle[i].x == next.x && cycle[i].y == next.y) continue;
      points.push_back({cycle[i].x, cycle[i].y});
      origins.push_back(i);
    }
    if (points.size() < 3) {
      outline.whole = false;
      continue;
    }
    outline.cycles.push_back(std::move(points));
    outline.cycle_of.push_back(c);
    outline.vertex_of.push_back(std::move(origins));
  }
  return outline;
}

void judge_sizes(const Polygon& polygon, Report& report) {
  if (polygon.cycles.empty()) report.add("cycle-size", segment_name(polygon), "no outer cycle");
  for (std::size_t c = 0; c < polygon.cycles.size(); ++c) {
    const std::size_t n = polygon.cycles[c].size();
    if (n < 3) report.add("cycle-size", cycle_name(polygon, c), std::to_string(n) + " vertices");
  }
}

void judge_lengths(const Polygon& polygon, Report& report) {
  for (std::size_t c = 0; c < polygon.cycles.size(); ++c) {
    const Cycle& cycle = polygon.cycles[c];
    if (cycle.size() < 3) continue;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const Vertex& next = cycle[(i + 1) % cycle.size()];
      if (cycle[i].x == next.x && cycle[i].y == next.y)
        report.add("edge-length", vertex_name(polygon, c, i), "the edge that leaves it has zero length");
    }
  }
}

bool judge_simple(const Polygon& polygon, const Outline& outline, Report& report) {
  const auto clash = find_clash(outline.cycles);
  if (!clash) return true;
  const auto name = [&](const EdgePlace& place) {
    return vertex_name(polygon, outline.cycle_of[place.cycle], outline.vertex_of[place.cycle][place.vertex]);
  };
  report.add("simple", name(clash->first), "its edge meets the edge of " + name(clash->second));
  return false;
}

void judge_directions(const Polygon& polygon, const Outline& outline, Report& report) {
  for (std::size_t i = 0; i < outline.cycles.size(); ++i) {
    const bool outer = outline.cycle_of[i] == 0;
    if (area_sign(outline.cycles[i]) != (outer ? 1 : -1))
      report.add("direction", cycle_name(polygon, outline.cycle_of[i]),
                 outer ? "the outer cycle runs clockwise" : "the hole runs anticlockwise");
  }
}

// The cycles do not touch (judge_simple), so each lies wholly on the side on which its first vertex lies.
void judge_nesting(const Polygon& polygon, const Outline& outline, Report& report) {
  std::vector<Box> boxes;
  for (const auto& cycle : outline.cycles) boxes.push_back(box_of(cycle));
  for (std::size_t i = 1; i < outline.cycles.size(); ++i) {
    const Point& p = outline.cycles[i][0];
    if (side_of(p, outline.cycles[0]) != Side::kInside)
      report.add("nesting", cycle_name(polygon, i), "the hole is not inside the outer cycle");
    for (std::size_t j = 1; j < outline.cycles.size(); ++j)
      if (i != j && is_in(p, boxes[j]) && side_of(p, outline.cycles[j]) != Side::kOutside)
        report.add("nesting", cycle_name(polygon, i), "the hole is inside hole " + std::to_string(j));
  }
}

}  // namespace

void judge_perimeter(const Polygon& polygon, Report& report) {
  judge_sizes(polygon, report);
  judge_lengths(polygon, report);
  const Outline outline = outline_of(polygon);
  if (!judge_simple(polygon, outline, report)) return;
  judge_directions(polygon, outline, report);
  if (outline.whole && !outline.cycles.empty()) judge_nesting(polygon, outline, report);
}

}  // namespace limpet::audit::internal
