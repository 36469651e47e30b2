// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/geometry/cut.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <limpet/geometry/predicates.hpp>

namespace limpet::geometry {
namespace {

/// An edge that the cut crosses, and where.
struct Crossing {
  Slot edge;
  Point2 at;
};

/// The two edges that the segment crosses; nothing if there are more or fewer, or it meets a vertex.
std::optional<std::array<Crossing, 2>> crossings(const Polygon& polygon, Point2 a, Point2 b) {
  std::vector<Slot> crossed;
  bool clean = true;
  polygon.any_edge_near(box_of(a, b), [&](Slot s) {
    const Point2 p = polygon.at(s), q = polygon.end(s);
    if (!segments_meet(a, b, p, q)) return false;
    clean &= orientation(a, b, p) != 0 && orientation(a, b, q) != 0;
    crossed.push_back(s);
    return !clean;
  });
  std::sort(crossed.begin(), crossed.end());
  crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
  if (!clean || crossed.size() != 2) return std::nullopt;
  std::array<Crossing, 2> result{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Point2 p = polygon.at(crossed[i]), q = polygon.end(crossed[i]);
    const double to_p = cross(b - a, p - a), to_q = cross(b - a, q - a);
    result[i] = {crossed[i], round_to_grid(p + to_p / (to_p - to_q) * (q - p))};
  }
  return result;
}

/// The loop that lies on one side of the cut: from one crossing along the boundary to the other.
std::vector<NewVertex> loop_between(const Polygon& polygon, const Crossing& from, const Crossing& to) {
  std::vector<NewVertex> loop{{from.at}};
  const auto go_to = [&](Point2 at) {
    if (loop.back().at != at) loop.push_back({at});
  };
  for (Slot s = polygon.next(from.edge); s != from.edge; s = polygon.next(s)) {
    go_to(polygon.at(s));
    if (s == to.edge) break;
  }
  go_to(to.at);
  return loop;
}

/// Leads the boundary from one crossing straight to the other. Where a crossing is rounded to a vertex, it
/// goes from that.
Chain straight(const Polygon& polygon, const Crossing& from, const Crossing& to) {
  Chain chain{from.edge, {}, polygon.next(to.edge)};
  if (from.at == polygon.end(from.edge))
    chain.from = polygon.next(from.edge);
  else if (from.at != polygon.at(from.edge))
    chain.via.push_back({from.at});
  if (to.at == polygon.at(to.edge))
    chain.to = to.edge;
  else if (to.at != polygon.end(to.edge))
    chain.via.push_back({to.at});
  return chain;
}

double twice_area(const std::vector<NewVertex>& loop) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += cross(loop[i].at - loop[0].at, loop[i + 1].at - loop[0].at);
  return sum;
}

}  // namespace

std::optional<Cut> cut_off(const Polygon& polygon, Point2 a, Point2 b, EdgeIds& ids) {
  const auto crossed = crossings(polygon, a, b);
  if (!crossed) return std::nullopt;
  Crossing from = (*crossed)[0], to = (*crossed)[1];
  const CycleId cycle = polygon.node(from.edge).cycle;
  if (polygon.node(to.edge).cycle != cycle) return std::nullopt;
  std::vector<NewVertex> loop = loop_between(polygon, from, to), other = loop_between(polygon, to, from);
  const double area = twice_area(loop), other_area = twice_area(other);
  // Of a hole's two loops one runs round the new hole; of the outer cycle's both run round a part.
  const bool other_is_piece = area < 0 || (other_area > 0 && other_area < area);
  if (other_is_piece) std::swap(from, to), std::swap(loop, other);
  if (twice_area(loop) <= 0) return std::nullopt;

  const std::array outer{loop};
  const auto without_holes = Polygon::from_cycles(outer, ids);
  if (!without_holes) return std::nullopt;
  Cut cut;
  cut.rest.chains.push_back(straight(polygon, from, to));
  std::vector<std::vector<NewVertex>> cycles{loop};
  for (std::size_t c = 0; c < polygon.cycles().size(); ++c) {
    const Polygon::Cycle& hole = polygon.cycles()[c];
    const CycleId id{static_cast<std::uint32_t>(c)};
    if (hole.size == 0 || id == cycle || !hole.hole) continue;
    if (without_holes->locate(polygon.at(hole.first)) != Polygon::Side::inside) continue;
    auto& vertices = cycles.emplace_back(polygon.vertices(hole));
    for (NewVertex& v : vertices) v = {v.at};
    cut.rest.removed_cycles.push_back(id);
  }
  auto piece = Polygon::from_cycles(cycles, ids);
  if (!piece || polygon.judge(cut.rest) != Verdict::valid) return std::nullopt;
  cut.piece = std::move(*piece);
  cut.length = std::sqrt(squared_length(to.at - from.at));
  return cut;
}

}  // namespace limpet::geometry
