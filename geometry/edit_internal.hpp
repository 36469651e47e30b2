// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/geometry/judge.hpp>
#include <limpet/geometry/polygon.hpp>

namespace limpet::geometry {

/// What stays of the boundary between the end of one chain of an edit and the start of the next one.
struct Polygon::Run {
  std::vector<Slot> kept;  ///< from the first chain's `to` to the second one's `from`; all of it if walked
  std::size_t next_chain = 0;  ///< index of the second chain
  bool walked = false;
};

struct Polygon::Difference {
  std::vector<Slot> removed_edges;  ///< these bear the polygon's stamp
  std::vector<Slot> removed_vertices;
  std::vector<KeyedEdge> new_edges;
  std::vector<Segment2> sweep;
  std::vector<Slot> starts, ends;  ///< of the chains, sorted
  std::vector<Run> runs;           ///< one behind each chain; at most one of them not walked to its end
  Box2 box;
  bool broken = false;  ///< the chains and removed cycles get into each other's way

  void clear() {
    removed_edges.clear(), removed_vertices.clear(), new_edges.clear(), sweep.clear();
    starts.clear(), ends.clear(), runs.clear();
    box = {}, broken = false;
  }
  void add_edge(Point2 a, Point2 b, std::uint64_t key_a, std::uint64_t key_b) {
    new_edges.push_back({a, b, key_a, key_b});
    sweep.emplace_back(a, b);
  }
  bool starts_at(Slot s) const { return std::binary_search(starts.begin(), starts.end(), s); }
  bool ends_at(Slot s) const { return std::binary_search(ends.begin(), ends.end(), s); }
};

}  // namespace limpet::geometry
