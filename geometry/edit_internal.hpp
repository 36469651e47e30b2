// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/geometry/judge.hpp>
#include <limpet/geometry/polygon.hpp>

#include "small_vector_internal.hpp"

namespace limpet::geometry {

/// The boundary that stays between the end of one chain of an edit and the start of the next chain.
struct Polygon::Run {
  std::vector<Slot> kept;      ///< from the first chain's `to`; as far as the second one's `from` if walked
  std::size_t next_chain = 0;  ///< index of the second chain
  bool walked = false;         ///< `kept` holds all of the run
};

/// What the edit does to the boundary. The inline capacities suit the usual edit: one chain that replaces two
/// or three edges.
struct Polygon::Difference {
  Difference(const Polygon&, const Edit&);
  Difference(const Difference&) = delete;
  Difference& operator=(const Difference&) = delete;

  internal::SmallVector<Slot, 8> removed_edges;  ///< in the order in which they are met
  internal::SmallVector<Slot, 8> removed_vertices;
  internal::SmallVector<KeyedEdge, 8> new_edges;
  /// Removed and new edges together: by the even-odd rule they bound the region that changes sides.
  internal::SmallVector<Segment2, 16> sweep;
  std::vector<Run> runs;  ///< one behind each chain, at most one of them not walked; empty until needed
  Box2 box;               ///< of the sweep
  bool broken = false;    ///< chains or removed cycles overlap; the rest is then incomplete

  bool removes(Slot edge) const {
    if (!sorted_removed_.empty())
      return std::binary_search(sorted_removed_.begin(), sorted_removed_.end(), edge);
    const Slot *first = removed_edges.data(), *last = first + removed_edges.size();
    while (first != last && *first != edge) ++first;  // faster for the usual two or three
    return first != last;
  }
  bool starts_at(Slot s) const { return is_among(s, start_, starts_); }
  bool ends_at(Slot s) const { return is_among(s, end_, ends_); }

 private:
  static bool is_among(Slot s, Slot only, const internal::SmallVector<Slot, 4>& sorted) {
    return sorted.empty() ? s == only : std::binary_search(sorted.begin(), sorted.end(), s);
  }
  void note_ends_of_chains(const Edit&);
  void remove_edge(const Polygon&, Slot);
  void add_edge(Point2 a, Point2 b, std::uint64_t key_a, std::uint64_t key_b);
  void add_chain(const Polygon&, const Chain&, std::uint64_t& next_key);
  void remove_cycle(const Polygon&, CycleId);
  void add_loop(const std::vector<NewVertex>&, std::uint64_t& next_key);

  Slot start_ = kNoSlot, end_ = kNoSlot;           ///< of the chain, if there is only one
  internal::SmallVector<Slot, 4> starts_, ends_;   ///< else those of all, sorted
  internal::SmallVector<Slot, 8> sorted_removed_;  ///< where they are not few edges of one chain
};

}  // namespace limpet::geometry
