// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include <limpet/geometry/types.hpp>

namespace limpet::model::internal {

/// Where an edge is, and its partner, if it is shared (thesis §2.2).
struct EdgePlace {
  std::uint32_t segment = 0;                ///< slot of its segment
  geometry::Slot slot = geometry::kNoSlot;  ///< none: it is being put in place, or has just been removed
  geometry::EdgeId partner;                 ///< none: an open edge
};

/// Every edge of a model by its identity, and the edges that any two segments share. Coordinates play no part
/// here.
///
/// Invariant: partners are mutual, and on different segments; the edges listed between two segments are
/// exactly those that have partners there.
///
/// A hash table with open addressing: every change of a perimeter looks up several edges.
class EdgeTable {
 public:
  EdgeTable() : places_(16) {}

  /// Null when there is no such edge. The pointer is valid until the table changes.
  const EdgePlace* find(geometry::EdgeId edge) const {
    const Entry& entry = places_[index_of(edge)];
    return entry.edge ? &entry.place : nullptr;
  }
  /// Precondition: there is such an edge.
  const EdgePlace& at(geometry::EdgeId edge) const { return *find(edge); }
  bool shared(geometry::EdgeId edge) const {
    const EdgePlace* place = find(edge);
    return place && place->partner;
  }
  /// The place of its partner. Precondition: the edge is shared.
  const EdgePlace& across(geometry::EdgeId edge) const { return at(at(edge).partner); }
  /// The edges that the segments in two slots share, as their copies on the segment in the lower slot,
  /// ascending.
  std::span<const geometry::EdgeId> between(std::uint32_t a, std::uint32_t b) const;

  std::size_t size() const { return size_; }
  std::size_t pair_count() const { return pair_count_; }
  /// Calls f(edge, place) for every edge, in no particular order.
  template <class F>
  void for_each(F&& f) const {
    for (const Entry& entry : places_)
      if (entry.edge) f(entry.edge, entry.place);
  }

  /// Puts an edge on this segment; it keeps its partner. Returns the slot of the segment it was on, or
  /// kNowhere when it is new.
  std::uint32_t put(geometry::EdgeId, std::uint32_t segment, geometry::Slot);
  static constexpr std::uint32_t kNowhere = 0xffffffffu;
  /// A shared edge has been removed from its perimeter, but not unshared yet.
  void lose_slot(geometry::EdgeId edge) { find_mutable(edge)->slot = geometry::kNoSlot; }
  /// Precondition: it is not shared.
  void erase(geometry::EdgeId);
  /// Makes two edges partners. Precondition: both exist, are open, and are on different segments.
  void pair(geometry::EdgeId a, geometry::EdgeId b);
  /// Makes both copies of an edge open. Precondition: it is shared.
  void unpair(geometry::EdgeId);
  /// Pairs of slots whose segments have become neighbours, or ceased to be, since the last call, or both.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> take_changed_links() {
    return std::exchange(changed_links_, {});
  }

 private:
  struct Entry {
    geometry::EdgeId edge;
    EdgePlace place;
  };

  std::size_t home(geometry::EdgeId edge) const {
    return (edge.value * 0x9e3779b97f4a7c15u) >> 32 & (places_.size() - 1);
  }
  /// The index of an edge in the table, or the free one where it would be put.
  std::size_t index_of(geometry::EdgeId edge) const {
    std::size_t i = home(edge);
    while (places_[i].edge && places_[i].edge != edge) i = (i + 1) & (places_.size() - 1);
    return i;
  }
  EdgePlace* find_mutable(geometry::EdgeId edge) {
    Entry& entry = places_[index_of(edge)];
    return entry.edge ? &entry.place : nullptr;
  }
  void grow();
  void list(geometry::EdgeId);
  void unlist(geometry::EdgeId);

  std::vector<Entry> places_;  ///< a power of two, at most half of them taken
  std::size_t size_ = 0, pair_count_ = 0;
  /// For each two neighbours, by their slots, the edges they share: the copies on the one in the lower slot,
  /// ascending.
  std::unordered_map<std::uint64_t, std::vector<geometry::EdgeId>> between_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> changed_links_;
};

/// For ascending lists of edges. Inserting an edge twice, or erasing one that is not there, does nothing.
void insert_sorted(std::vector<geometry::EdgeId>& edges, geometry::EdgeId edge);
void erase_sorted(std::vector<geometry::EdgeId>& edges, geometry::EdgeId edge);

}  // namespace limpet::model::internal
