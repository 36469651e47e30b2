// Copyright the limpet authors. GPL-3.0-or-later.
//
// A polygon as plain data, and restored from it. The data may come from a damaged file, so all is checked.
#include <cmath>
#include <stdexcept>
#include <string>

#include <limpet/geometry/judge.hpp>
#include <limpet/geometry/polygon.hpp>
#include <limpet/geometry/predicates.hpp>

namespace limpet::geometry {
namespace {

constexpr double kFarthest = 0x1p300;  ///< squares of coordinates, and their sums, stay finite

void require(bool good, const char* what) {
  if (!good) throw std::invalid_argument(std::string("a stored polygon ") + what);
}

bool is_sound(double x) { return std::abs(x) <= kFarthest; }
bool is_sound(Point2 p) { return is_sound(p.x) && is_sound(p.y); }

std::uint32_t number(Slot s) { return static_cast<std::uint32_t>(s); }

/// Indices are within the arrays they refer to, and coordinates are finite and on the grid.
void require_places(const PolygonState& p) {
  const auto is_place = [&](Slot s) { return s == kNoSlot || number(s) < p.nodes.size(); };
  require(p.nodes.size() < number(kNoSlot), "has too many vertices");
  for (const Polygon::Node& n : p.nodes) {
    require(is_place(n.next) && is_place(n.prev), "has a vertex beside none");
    require(static_cast<std::uint32_t>(n.cycle) < p.cycles.size(), "has a vertex on no perimeter");
    require(is_sound(n.at) && round_to_grid(n.at) == n.at, "has a vertex off the grid");
  }
  for (const Polygon::Cycle& c : p.cycles) require(is_place(c.first), "has a perimeter without a vertex");
  for (const auto& [slot, edge] : p.created) require(is_place(slot), "has a new edge nowhere");
}

/// The free slots are exactly those without an edge, each listed once.
void require_free_places(const PolygonState& p) {
  std::vector<char> free(p.nodes.size());
  for (const std::uint32_t i : p.free) {
    require(i < p.nodes.size() && !p.nodes[i].edge && !free[i], "has a place that is free and is not");
    free[i] = 1;
  }
  for (std::size_t i = 0; i < p.nodes.size(); ++i)
    require(bool(p.nodes[i].edge) != bool(free[i]), "has a place that is neither free nor taken");
}

/// Each cycle returns to its first vertex after as many vertices as it says, and each vertex is on a cycle.
void require_links(const PolygonState& p) {
  std::size_t walked = 0, outer = 0;
  for (std::uint32_t id = 0; id < p.cycles.size(); ++id) {
    const Polygon::Cycle& cycle = p.cycles[id];
    if (cycle.size == 0) continue;
    outer += !cycle.hole;
    require(cycle.size <= p.nodes.size() - walked, "has more vertices on perimeters than there are");
    Slot s = cycle.first;
    for (std::uint32_t i = 0; i < cycle.size; ++i) {
      require(s != kNoSlot, "has a perimeter that ends");
      const Polygon::Node& n = p.nodes[number(s)];
      require(n.edge && n.cycle == CycleId{id}, "has a vertex that is not on its perimeter");
      require(n.next != kNoSlot && p.nodes[number(n.next)].prev == s, "has links that do not fit");
      require((n.next == cycle.first) == (i + 1 == cycle.size), "has a perimeter of another length");
      s = n.next;
    }
    walked += cycle.size;
  }
  require(outer == 1, "has not one outer perimeter");
  require(walked + p.free.size() == p.nodes.size(), "has vertices on no perimeter");
}

void require_measures(const PolygonState& p) {
  require(is_sound(p.origin) && is_sound(p.box.low) && is_sound(p.box.high), "has a box without bounds");
  require(std::isfinite(p.twice_area) && p.twice_area > 0, "has no area");
  for (const Polygon::Node& n : p.nodes)
    require(!n.edge || p.box.contains(n.at), "has a vertex outside its box");
  if (p.index_edges == 0) return;
  require(is_sound(p.index_box.low) && is_sound(p.index_box.high) &&
              p.index_box.low.x <= p.index_box.high.x && p.index_box.low.y <= p.index_box.high.y &&
              p.index_edges <= 16 * p.nodes.size(),
          "has an index that does not suit it");
}

}  // namespace

PolygonState Polygon::state() const {
  PolygonState p{nodes_, cycles_, free_,    origin_,  twice_area_, box_,
                 {},     0,       removed_, created_, version_,    joins_};
  if (index_.active()) p.index_box = index_.cells_box(), p.index_edges = index_.built_for();
  return p;
}

Polygon Polygon::from_state(PolygonState p) {
  require_places(p);
  require_free_places(p);
  require_links(p);
  require_measures(p);
  Polygon polygon;
  polygon.nodes_ = std::move(p.nodes);
  polygon.cycles_ = std::move(p.cycles);
  polygon.free_ = std::move(p.free);
  polygon.edge_count_ = polygon.nodes_.size() - polygon.free_.size();
  polygon.origin_ = p.origin;
  polygon.twice_area_ = p.twice_area;
  polygon.box_ = p.box;
  polygon.removed_ = std::move(p.removed);
  polygon.created_ = std::move(p.created);
  polygon.version_ = p.version;
  polygon.joins_ = p.joins;
  if (const Verdict v = judge_polygon(polygon); v != Verdict::valid)
    require(false, (std::string("is not valid: ") + to_string(v)).c_str());
  if (p.index_edges > 0) polygon.index_.reset_cells(p.index_box, p.index_edges);
  require(polygon.index_.fits(polygon.box_, polygon.index_size()), "has an index that does not suit it");
  if (polygon.index_.active()) polygon.fill_index();
  return polygon;
}

}  // namespace limpet::geometry
