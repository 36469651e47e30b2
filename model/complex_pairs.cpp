// Copyright the limpet authors. GPL-3.0-or-later.
//
// Which segments share which edges (thesis §2.2), and unsharing (§2.8). The edge table has both copies of
// every shared edge by identity; coordinates decide only whether two ends still coincide.
#include <algorithm>
#include <array>
#include <cmath>

#include <limpet/geometry/predicates.hpp>

#include "common_line_internal.hpp"
#include "complex_internal.hpp"

namespace limpet::model::internal {

using geometry::EdgeId;
using geometry::Slot;

bool Complex::is_corner(const Segment& s, Slot vertex) const {
  const auto& perimeter = s.polygon->perimeter;
  const auto &before = perimeter.node(perimeter.prev(vertex)), &after = perimeter.node(vertex);
  return before.shared && after.shared &&
         edges_.across(before.edge).segment != edges_.across(after.edge).segment;
}

std::vector<std::uint32_t> Complex::neighbours_across(std::span<const EdgeId> edges) const {
  std::vector<std::uint32_t> slots;
  for (const EdgeId edge : edges)
    if (edges_.shared(edge)) slots.push_back(edges_.across(edge).segment);
  std::sort(slots.begin(), slots.end());
  slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
  return slots;
}

void Complex::tell_shared(const Segment& a, const Segment& b, EdgeId of_a, EdgeId of_b) {
  changes_.add(Change::Kind::shared, a.id, b.id, {}, std::array{of_a, of_b});
}

void Complex::tell_corner(const Segment& a, const Segment& b, std::span<const EdgeId> edges) {
  changes_.add(Change::Kind::corner_formed, a.id, b.id, {}, edges);
}

/// Marks a copy that has just lost its partner as an open edge of its perimeter, if it is still there.
void Complex::make_open(EdgeId edge) {
  const EdgePlace place = edges_.at(edge);
  Segment& s = *segments_.in_slot(place.segment);
  PolygonPart& part = *s.polygon;
  erase_sorted(part.shared, edge);
  if (place.slot == geometry::kNoSlot || !still_there(part.perimeter, {place.slot, edge})) return;
  mark_shared(s, place.slot, false);
}

void Complex::mark_shared(Segment& s, Slot edge, bool shared) {
  PolygonPart& part = *s.polygon;
  part.perimeter.set_shared(edge, shared);
  Box3 where(part.position(edge));
  description_changed(s, where.extend(part.position(part.perimeter.next(edge))));
}

void Complex::share_open(EdgeId a, EdgeId b) {
  for (const EdgeId edge : {a, b}) {
    const EdgePlace place = edges_.at(edge);
    Segment& s = *segments_.in_slot(place.segment);
    PolygonPart& part = *s.polygon;
    insert_sorted(part.shared, edge);
    mark_shared(s, place.slot, true);
  }
  edges_.pair(a, b);
  tell_shared(at(edges_.at(a).segment), at(edges_.at(b).segment), a, b);
}

/// Do the two edges at a corner vertex run on in one line? Then the corner need not be on either of theirs.
bool Complex::runs_on(const Segment& s, Slot corner) const {
  const auto& perimeter = s.polygon->perimeter;
  const Slot before = perimeter.prev(corner);
  const auto line = [&](Slot edge) {
    const EdgePlace& other = edges_.across(perimeter.node(edge).edge);
    return common_line(s.polygon->plane(), at(other.segment).polygon->plane(), s.polygon->position(corner));
  };
  const auto first = line(before), second = line(corner);
  return first && second && run_on(perimeter, before, corner, *first, *second);
}

/// Is the end of a shared edge at this vertex as near to the plane across it as it has to be?
bool Complex::end_in_place(const Segment& s, Slot vertex, const geometry::Plane& across) const {
  const double height = std::abs(across.height_of(s.polygon->position(vertex)));
  if (height <= kEndSteps * setting_.step) return true;
  return height <= kRunsOnReach * setting_.least.lambda && is_corner(s, vertex) && runs_on(s, vertex);
}

/// Do the two copies of a shared edge lie on their line, run opposite to each other, and meet with their ends
/// (kEndSteps)? Ends at a corner vertex need not meet.
bool Complex::ends_meet(EdgeId edge) const {
  const EdgePlace &mine = edges_.at(edge), &other = edges_.across(edge);
  if (mine.slot == geometry::kNoSlot || other.slot == geometry::kNoSlot)
    return true;  // it is being put in place or removed
  const Segment &a = at(mine.segment), &b = at(other.segment);
  const geometry::Plane plane_a = a.polygon->plane(), plane_b = b.polygon->plane();
  const double reach = kEndSteps * setting_.step / sine_between(plane_a, plane_b);
  const auto meet = [&](Slot p, Slot q) {
    if (!is_corner(a, p) && !is_corner(b, q) &&
        (a.polygon->position(p) - b.polygon->position(q)).squaredNorm() > reach * reach)
      return false;
    return end_in_place(a, p, plane_b) && end_in_place(b, q, plane_a);
  };
  const Slot end_a = a.polygon->perimeter.next(mine.slot), end_b = b.polygon->perimeter.next(other.slot);
  const Eigen::Vector3d along_a = a.polygon->position(end_a) - a.polygon->position(mine.slot),
                        along_b = b.polygon->position(end_b) - b.polygon->position(other.slot);
  return along_a.dot(along_b) < 0 && meet(mine.slot, end_b) && meet(end_a, other.slot);
}

/// Adds the shared edges directly before and after this one on its perimeter, with which it may have formed a
/// corner.
void Complex::add_adjoining(EdgeId edge, std::vector<EdgeId>& result) const {
  const EdgePlace& place = edges_.at(edge);
  if (place.slot == geometry::kNoSlot) return;
  const auto& perimeter = at(place.segment).polygon->perimeter;
  if (!still_there(perimeter, {place.slot, edge})) return;
  for (const Slot s : {perimeter.prev(place.slot), perimeter.next(place.slot)})
    if (perimeter.node(s).shared) result.push_back(perimeter.node(s).edge);
}

void Complex::unshare(EdgeId edge) {
  std::vector<EdgeId> going{edge};
  while (!going.empty()) {
    const EdgeId next = going.back();
    going.pop_back();
    if (!edges_.shared(next)) continue;
    const EdgeId partner = edges_.at(next).partner;
    std::vector<EdgeId> beside;
    add_adjoining(next, beside);
    add_adjoining(partner, beside);
    changes_.add(Change::Kind::unshared, at(edges_.at(next).segment).id, at(edges_.at(partner).segment).id,
                 {}, std::array{next, partner});
    edges_.unpair(next);
    make_open(next);
    make_open(partner);
    for (const EdgeId b : beside)
      if (ends_held_ > 0)
        ends_due_.push_back(b);
      else if (edges_.shared(b) && !ends_meet(b))
        going.push_back(b);
  }
}

void Complex::dissolve_neighbours(const Segment& a, const Segment& b) {
  const auto between = edges_between(a, b);
  for (const EdgeId edge : std::vector<EdgeId>(between.begin(), between.end()))
    if (edges_.shared(edge)) unshare(edge);
}

void Complex::dissolve_all_neighbours(const Segment& s) {
  while (!s.polygon->shared.empty()) unshare(s.polygon->shared.front());
}

void Complex::note_ends(std::span<const EdgeId> edges) {
  for (const EdgeId edge : edges) {
    if (!edges_.shared(edge)) continue;
    ends_due_.push_back(edge);
    add_adjoining(edge, ends_due_);
    add_adjoining(edges_.at(edge).partner, ends_due_);
  }
}

void Complex::unshare_where_ends_part() {
  for (const EdgeId edge : std::exchange(ends_due_, {}))
    if (edges_.shared(edge) && !ends_meet(edge)) unshare(edge);
}

}  // namespace limpet::model::internal
