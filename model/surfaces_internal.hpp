// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace limpet::model::internal {

/// Surfaces: the connected components of the neighbour relation (thesis §2.2), with segments named by their
/// slots. They are updated incrementally: when two surfaces meet, the smaller one is relabelled. When
/// neighbours part, searches start from both, the one with less work so far always going first, until they
/// meet or one has seen the whole of its component.
class Surfaces {
 public:
  using Slot = std::uint32_t;

  /// The present neighbour relation.
  struct Relation {
    std::function<bool(Slot, Slot)> are_neighbours;
    /// Appends the neighbours of a segment; one may come more than once.
    std::function<void(Slot, std::vector<Slot>&)> add_neighbours;
  };

  /// The members of the surface of this segment, itself included, in no particular order; empty if it is
  /// alone.
  std::span<const Slot> with(Slot slot) const {
    const std::uint32_t surface = surface_of(slot);
    return surface == kAlone ? std::span<const Slot>{} : std::span<const Slot>(members_[surface]);
  }
  bool together(Slot a, Slot b) const {
    return a == b || (surface_of(a) != kAlone && surface_of(a) == surface_of(b));
  }

  /// The segment in this slot is gone. The links it had must be among those given to the next update().
  void remove(Slot);
  /// Brings the surfaces up to date, after links between these pairs have come or gone.
  void update(std::span<const std::pair<Slot, Slot>> changed_links, const Relation&);

 private:
  static constexpr std::uint32_t kAlone = 0xffffffffu;
  struct Place {
    std::uint32_t surface = kAlone, index = 0;  ///< in members_[surface]
  };
  class Search;

  std::uint32_t surface_of(Slot slot) const { return slot < place_.size() ? place_[slot].surface : kAlone; }
  std::uint32_t make_surface();
  void enter(Slot, std::uint32_t surface);
  void leave(Slot);
  void join(Slot, Slot);
  void end_if_alone(std::uint32_t surface);
  void split(std::span<const Slot> suspects, const Relation&);

  std::vector<Place> place_;                ///< by slot
  std::vector<std::vector<Slot>> members_;  ///< by surface; empty: an unused entry
  std::vector<std::uint32_t> free_;
};

}  // namespace limpet::model::internal
