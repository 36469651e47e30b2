// Copyright the limpet authors. GPL-3.0-or-later.
//
// One polygon segment becomes two.
#include "area_moments_internal.hpp"
#include "complex_internal.hpp"

namespace limpet::model::internal {

void Complex::take_share(Segment& s, const Share& share) {
  s.data = share.data;
  s.fit = share.fit;
  s.next_fit = s.count() + 1;
  s.polygon->heights = share.heights;
  s.polygon->box = perimeter_box(*s.polygon);
}

const Segment& Complex::split(const Segment& whole, const geometry::Edit& rest,
                              std::unique_ptr<PolygonPart> part, const Shares& shares) {
  Transaction transaction;
  transaction.edits.emplace_back(whole.slot, rest);
  commit_judged(transaction);
  take_share(mutable_of(whole), shares.rest);
  reindex(whole);

  Segment& s = segments_.create();
  agenda_.opened(s.slot);
  s.polygon = std::move(part);
  if (whole.polygon->felt) s.polygon->felt = std::make_unique<Felt>(*whole.polygon->felt);
  agenda_.became_polygon(s.slot);
  BoundaryDifference difference = book_difference(s, false);
  take_share(s, shares.piece);
  description_changed(s, s.polygon->box);
  changes_.add(Change::Kind::created, {}, {}, s.id);
  changes_.add(Change::Kind::became_polygon, {}, {}, s.id);
  tell(s, std::move(difference));
  reindex(s);
  return s;
}

}  // namespace limpet::model::internal
