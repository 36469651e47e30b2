// Copyright the limpet authors. GPL-3.0-or-later.
//
// One polygon segment becomes two.
#include <limpet/geometry/predicates.hpp>

#include "complex_internal.hpp"
#include "divided_data_internal.hpp"

namespace limpet::model::internal {

void Complex::take_portion(Segment& s, const Portion& portion) {
  s.data = portion.data;
  s.fit = portion.fit;
  s.next_fit = s.count() + 1;
  s.polygon->heights = portion.heights;
  s.polygon->box = perimeter_box(*s.polygon);
}

const Segment& Complex::split(const Segment& whole, const geometry::Edit& rest,
                              std::unique_ptr<PolygonPart> part, const Portions& portions) {
  Transaction transaction;
  transaction.edits.emplace_back(whole.slot, rest);
  commit_judged(transaction);
  take_portion(mutable_of(whole), portions.rest);
  reindex(whole);

  Segment& s = segments_.create();
  agenda_.opened(s.slot);
  s.polygon = std::move(part);
  if (whole.polygon->felt) s.polygon->felt = std::make_unique<Felt>(*whole.polygon->felt);
  if (Owned<Passages>& passages = mutable_of(whole).polygon->passages) {
    const auto in_piece = [&](const Eigen::Vector3d& p) {
      const geometry::Point2 at = geometry::round_to_grid(s.polygon->chart.project(p));
      return s.polygon->perimeter.locate(at) != geometry::Polygon::Side::outside;
    };
    const auto share = static_cast<double>(portions.piece.data.count()) /
                       static_cast<double>(portions.piece.data.count() + portions.rest.data.count());
    s.polygon->passages = std::make_unique<Passages>(passages->split(in_piece, share));
  }
  agenda_.became_polygon(s.slot);
  BoundaryDifference difference = book_difference(s, false);
  take_portion(s, portions.piece);
  description_changed(s, s.polygon->box);
  changes_.add(Change::Kind::created, {}, {}, s.id);
  changes_.add(Change::Kind::became_polygon, {}, {}, s.id);
  tell(s, std::move(difference));
  reindex(s);
  return s;
}

}  // namespace limpet::model::internal
