// Copyright the limpet authors. GPL-3.0-or-later.
//
// The commit protocol. After any change of a perimeter, it records which edges were removed, created and
// moved, unshares the removed ones, and notes where the description has changed and what is to be looked at
// because of it.
#include <algorithm>

#include "complex_internal.hpp"
#include "heights_internal.hpp"

namespace limpet::model::internal {

using geometry::EdgeId;
using geometry::Slot;

BoundaryDifference Complex::book_difference(Segment& s, bool looked_at) {
  geometry::Polygon& perimeter = s.polygon->perimeter;
  BoundaryDifference difference = std::move(spare_);  // to reuse its memory
  perimeter.take_changes(difference.removed, difference.put);
  book_put_edges(s, difference);
  if (!looked_at) {
    PlacedEdges& fresh = agenda_.polygon(s.slot).fresh;
    fresh.insert(fresh.end(), difference.put.begin(), difference.put.end());
  }
  if (!difference.removed.empty()) book_removed_edges(difference.removed);
  return difference;
}

/// Enters the edges that were put in place in the edge table, at their new slots and on this segment, if they
/// come from another one.
void Complex::book_put_edges(Segment& s, BoundaryDifference& difference) {
  PolygonPart& part = *s.polygon;
  for (const auto& placed : difference.put) {
    if (!still_there(part.perimeter, placed)) continue;
    const auto [slot, edge] = placed;
    const std::uint32_t before = edges_.put(edge, s.slot, slot);
    (before == EdgeTable::kNowhere ? difference.appeared : difference.moved).push_back(edge);
    if (before == EdgeTable::kNowhere || before == s.slot || !edges_.shared(edge)) continue;
    erase_sorted(segments_.in_slot(before)->polygon->shared, edge);
    insert_sorted(part.shared, edge);
  }
}

/// Unshares the removed edges and deletes them from the edge table. Ignores those that were created within
/// the same operation.
void Complex::book_removed_edges(std::vector<EdgeId>& removed) {
  // All of them lose their slots before the first is unshared, so that ends_meet() does not look for their
  // ends.
  bool any_shared = false;
  std::erase_if(removed, [&](EdgeId edge) {
    const EdgePlace* place = edges_.find(edge);
    if (place && place->partner) edges_.lose_slot(edge), any_shared = true;
    return !place;
  });
  if (any_shared)
    for (const EdgeId edge : removed)
      if (edges_.shared(edge)) unshare(edge);
  for (const EdgeId edge : removed) edges_.erase(edge);
}

void Complex::tell(const Segment& s, BoundaryDifference&& difference) {
  changes_.add(Change::Kind::edges_removed, s.id, difference.removed);
  changes_.add(Change::Kind::edges_created, s.id, difference.appeared);
  changes_.add(Change::Kind::edges_moved, s.id, difference.moved);
  difference.clear();
  spare_ = std::move(difference);
}

bool Complex::commit(const Transaction& transaction) {
  for (const auto& [slot, edit] : transaction.edits)
    if (at(slot).polygon->perimeter.judge(edit) != geometry::Verdict::valid) return false;
  commit_judged(transaction);
  return true;
}

void Complex::commit_judged(const Transaction& transaction) {
  for (const auto& [slot, edit] : transaction.edits)
    segments_.in_slot(slot)->polygon->perimeter.commit(edit, edge_ids_);
  for (const auto& [a, b] : transaction.pairs) {
    const std::uint32_t of_a = transaction.edits[0].first, of_b = transaction.edits[1].first;
    for (const auto& [edge, slot] : {std::pair(a, of_a), std::pair(b, of_b)}) {
      edges_.put(edge, slot, geometry::kNoSlot);
      insert_sorted(segments_.in_slot(slot)->polygon->shared, edge);
      agenda_.polygon(slot).corners_due.push_back(edge);
    }
    edges_.pair(a, b);
    for (const std::uint32_t slot : {of_a, of_b}) agenda_.mark_modified(slot);
  }
  for (std::size_t i = 0; i < transaction.edits.size(); ++i) {
    note_addition(at(transaction.edits[i].first));
    std::vector<EdgeId> born;
    for (const auto& [a, b] : transaction.pairs) born.push_back(i == 0 ? a : b);
    perimeter_changed(*segments_.in_slot(transaction.edits[i].first), born);
  }
}

void Complex::keep_ends_in_place(const Transaction& transaction) {
  std::vector<EdgeId> touched;
  for (const auto& [slot, edit] : transaction.edits) {
    const geometry::Polygon& perimeter = at(slot).polygon->perimeter;
    for (const geometry::Chain& chain : edit.chains) {
      Slot edge = perimeter.prev(chain.from);
      for (std::size_t i = 0; i < chain.via.size() + 3; ++i, edge = perimeter.next(edge))
        if (perimeter.node(edge).shared) touched.push_back(perimeter.node(edge).edge);
    }
  }
  with_ends_apart([&] { note_ends(touched); });
}

/// Records a committed edit and its consequences. `born`: new edges that are in the edge table already,
/// because they were shared.
void Complex::perimeter_changed(Segment& s, std::span<const EdgeId> born) {
  BoundaryDifference difference = book_difference(s, false);
  for (const EdgeId edge : born)
    if (std::erase(difference.moved, edge) > 0) difference.appeared.push_back(edge);
  complete(s, region_of(*s.polygon, difference.put), std::move(difference));
}

/// What follows of a difference that has been recorded.
void Complex::complete(Segment& s, const DirtyRegion& where, BoundaryDifference&& difference) {
  extend_box(s, where);
  description_changed(s, where);
  reindex(s);
  tell(s, std::move(difference));
}

void Complex::extend_box(const Segment& s, const DirtyRegion& where) {
  for (const Box3& place : where.boxes()) mutable_of(s).polygon->box.extend(place);
}

void Complex::count_area(PolygonPart& part) {
  const double gap = setting_.scale_at(part.box.center()).gap, area = part.perimeter.area() / (gap * gap);
  modelled_area_ += area - part.counted_area;
  part.counted_area = area;
}

void Complex::description_changed(const Segment& s, const DirtyRegion& where) {
  PolygonPart& part = *mutable_of(s).polygon;
  ++part.shape;
  if (!s.initial()) count_area(part);
  agenda_.description_changed(s.slot, where, s.young());
}

void Complex::become_polygon(const Segment& point_segment, std::unique_ptr<PolygonPart> part) {
  Segment& s = mutable_of(point_segment);
  s.polygon = std::move(part);
  agenda_.became_polygon(s.slot);
  modelled_points_ += s.count();
  if (!s.young()) add_height(setting_, *s.polygon, s.fit.centroid, static_cast<double>(s.count()));
  BoundaryDifference difference = book_difference(s, false);
  s.polygon->box = perimeter_box(*s.polygon);
  s.next_fit = s.count() + 1;
  reindex(s);
  description_changed(s, s.polygon->box);
  if (agenda_.finishing) keep_felt(s);
  changes_.add(Change::Kind::became_polygon, {}, {}, s.id);
  tell(s, std::move(difference));
}

const Segment& Complex::create_initial(const Fit& fit, std::unique_ptr<PolygonPart> part) {
  Segment& s = segments_.create();
  agenda_.opened(s.slot);
  s.fit = fit;
  s.polygon = std::move(part);
  ++initial_count_;
  agenda_.became_polygon(s.slot);
  BoundaryDifference difference = book_difference(s, true);
  s.polygon->box = perimeter_box(*s.polygon);
  changes_.add(Change::Kind::created, {}, {}, s.id);
  changes_.add(Change::Kind::became_polygon, {}, {}, s.id);
  tell(s, std::move(difference));
  reindex(s);
  description_changed(s, s.polygon->box);
  return s;
}

void Complex::replace_perimeter(const Segment& segment, const geometry::Chart& chart,
                                geometry::Polygon&& perimeter, const geometry::Plane& plane) {
  Segment& s = mutable_of(segment);
  PolygonPart& part = *s.polygon;
  const std::vector<EdgeId> shared_before = part.shared;
  std::vector<EdgeId> before;
  for_each_edge(part.perimeter, [&](Slot slot) { before.push_back(part.perimeter.node(slot).edge); });

  const geometry::Chart old_chart = std::exchange(part.chart, chart);
  rechart_heights(setting_, part, old_chart);
  part.perimeter = std::move(perimeter);
  part.published = geometry::Lift(part.chart, plane);
  part.outward = plane.normal;

  // The slots are new, so all edges are searched for fissures again.
  for (const EdgeId edge : shared_before) edges_.lose_slot(edge);
  agenda_.polygon(s.slot).fresh.clear();
  BoundaryDifference difference = book_difference(s, false);
  for (const EdgeId edge : shared_before)
    if (edges_.shared(edge) && edges_.at(edge).slot == geometry::kNoSlot) unshare(edge);
  for (const EdgeId edge : before)
    if (!still_there(part.perimeter, {edges_.at(edge).slot, edge})) {
      edges_.erase(edge);
      difference.removed.push_back(edge);
    }
  difference.moved.clear();  // plane_moved() reports all edges as moved
  tell(s, std::move(difference));
}

void Complex::set_plane(const Segment& s, const geometry::Lift& lift, const Eigen::Vector3d& outward) {
  PolygonPart& part = *mutable_of(s).polygon;
  part.published = lift;
  part.outward = outward;
}

void Complex::plane_moved(const Segment& s) {
  PolygonPart& part = *mutable_of(s).polygon;
  part.box = perimeter_box(part);
  description_changed(s, part.box);
  reindex(s);
  BoundaryDifference difference = std::move(spare_);
  for_each_edge(part.perimeter,
                [&](Slot slot) { difference.moved.push_back(part.perimeter.node(slot).edge); });
  tell(s, std::move(difference));
}

}  // namespace limpet::model::internal
