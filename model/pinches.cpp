// Copyright the limpet authors. GPL-3.0-or-later.
//
// Where six faces meet, three planes may have two of them each, which touch in the vertex only. As they grow
// they come within λ of each other there, and become one polygon; which planes pass there is known when all
// are.
#include "pinches_internal.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <limpet/geometry/cut.hpp>
#include <limpet/geometry/predicates.hpp>

#include "divided_data_internal.hpp"
#include "line_chains_internal.hpp"
#include "meeting_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::Point2;

/// A place where a polygon may be cut, and the ends of the cut in its chart.
struct Pinch {
  Eigen::Vector3d at;
  Point2 from, to;
};

Point2 unit(Point2 p) { return 1 / std::sqrt(squared_length(p)) * p; }

/// Does the polygon fill two opposite quadrants between the two lines (directions in its chart) through p,
/// and none of the other two? They are asked kPinchDepth from both lines, where no merger of the two can have
/// got, and twice as far, as chance may leave a corner out.
std::optional<Pinch> pinch_at(const Setting& setting, const PolygonPart& part, const Eigen::Vector3d& at,
                              Point2 along_first, Point2 along_second) {
  const Point2 p = part.chart.project(at), u = unit(along_first), v = unit(along_second);
  const std::array<Point2, 4> bisectors{unit(u + v), unit(v - u), unit(-1 * (u + v)), unit(u - v)};
  std::array<Point2, 4> ends{};
  std::array<bool, 4> filled{};
  for (std::size_t i = 0; i < 4; ++i) {
    const double sine = std::abs(cross(bisectors[i], u));
    if (sine < kLeastPinchSine) return std::nullopt;
    const Point2 step = kPinchDepth * setting.scale_at(at).gap / sine * bisectors[i];
    ends[i] = geometry::round_to_grid(p + step);
    for (const Point2 probe : {ends[i], geometry::round_to_grid(p + 2 * step)})
      filled[i] = filled[i] || part.perimeter.locate(probe) == geometry::Polygon::Side::inside;
  }
  if (filled[0] != filled[2] || filled[1] != filled[3] || filled[0] == filled[1]) return std::nullopt;
  const std::size_t empty = filled[0] ? 1 : 0;
  return Pinch{at, ends[empty], ends[empty + 2]};
}

/// The directions of a line in a chart.
Point2 seen_along(const geometry::Chart& chart, const CommonLine& line) {
  return {line.along.dot(chart.u()), line.along.dot(chart.v())};
}

Box3 common_box(const Setting& setting, const PolygonPart& a, const PolygonPart& b) {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(setting.largest_scale(a.box).lambda);
  return {a.box.min().cwiseMax(b.box.min()) - reach, a.box.max().cwiseMin(b.box.max()) + reach};
}

/// Looks for the places where a polygon touches itself in a vertex.
class PinchSearch {
 public:
  PinchSearch(const Complex& complex, const Segment& s)
      : complex_(complex), setting_(complex.setting()), s_(s), part_(*s.polygon) {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(setting_.largest_scale(part_.box).lambda);
    const Box3 around(part_.box.min() - reach, part_.box.max() + reach);
    for (const auto& [id, slot] : polygons_near(complex_, DirtyRegion(around), s_.slot)) {
      const PolygonPart& other = *complex_.at(slot).polygon;
      if (const Box3 both = common_box(setting_, part_, other); !both.isEmpty())
        others_.push_back({&other, other.plane(), both});
    }
  }

  /// By the identities of the two that cross the polygon; one of several at the same place.
  std::vector<Pinch> all() {
    for (auto first = others_.begin(); first != others_.end(); ++first)
      if (const auto line = line_between(setting_, part_, *first->part))
        for (auto second = first + 1; second != others_.end(); ++second) look_at(*first, line->line, *second);
    return std::move(found_);
  }

 private:
  /// A polygon near this one.
  struct Other {
    const PolygonPart* part;
    geometry::Plane plane;
    Box3 both;  ///< where both may be near, common_box()
  };

  void look_at(const Other& first, const CommonLine& line, const Other& second) {
    const auto at = common_point(line, second.plane);
    if (!at || !second.both.contains(*at) || !first.both.contains(*at) || is_known(*at)) return;
    if (!lies_near(setting_, *first.part, *at) || !lies_near(setting_, *second.part, *at) ||
        !lies_near(setting_, part_, *at))
      return;
    const auto other_line = common_line(part_.plane(), second.plane, *at);
    if (!other_line) return;
    const auto pinch =
        pinch_at(setting_, part_, *at, seen_along(part_.chart, line), seen_along(part_.chart, *other_line));
    if (pinch && ends_on_both_sides(*at, line) && ends_on_both_sides(*at, *other_line))
      found_.push_back(*pinch);
  }

  bool is_known(const Eigen::Vector3d& at) const {
    const double lambda2 = setting_.scale_at(at).lambda2;
    return std::any_of(found_.begin(), found_.end(),
                       [&](const Pinch& pinch) { return (pinch.at - at).squaredNorm() < lambda2; });
  }

  /// Are there others in a plane through the line, on both sides of the place? Where the polygon turns round
  /// the corner of a single other one, they are on one.
  bool ends_on_both_sides(const Eigen::Vector3d& at, const CommonLine& line) const {
    const Eigen::Vector3d arm = kPinchArm * setting_.scale_at(at).lambda * line.along;
    return ends_at(at, at + arm) && ends_at(at, at - arm);
  }
  bool ends_at(const Eigen::Vector3d& at, const Eigen::Vector3d& beside) const {
    const Turn near = polygons_near(complex_, DirtyRegion(Box3(beside)), s_.slot);
    const double close = setting_.scale_at(at).lambda / 4;
    return std::any_of(near.begin(), near.end(), [&](const auto& one) {
      const PolygonPart& other = *complex_.at(one.second).polygon;
      const geometry::Plane plane = other.plane();
      return sine_between(plane, part_.plane()) > setting_.sin_angle &&
             std::abs(plane.height_of(at)) < close && std::abs(plane.height_of(beside)) < close &&
             lies_near(setting_, other, beside);
    });
  }

  const Complex& complex_;
  const Setting& setting_;
  const Segment& s_;
  const PolygonPart& part_;
  std::vector<Other> others_;  ///< by identity
  std::vector<Pinch> found_;
};

/// A cut through the pinch; beside it, where that would meet a vertex, or a hole, or be rounded too much.
std::optional<geometry::Cut> cut_near(Complex& complex, const geometry::Polygon& perimeter,
                                      const Pinch& pinch, double gap) {
  const Point2 along = unit(pinch.to - pinch.from), across{-along.y, along.x};
  for (const double shift : {0., 1. / 256, -1. / 256, 1. / 32, -1. / 32, 1. / 8, -1. / 8, 1. / 4, -1. / 4}) {
    const Point2 by = shift * gap * across;
    auto cut = geometry::cut_off(perimeter, geometry::round_to_grid(pinch.from + by),
                                 geometry::round_to_grid(pinch.to + by), complex.edge_ids());
    if (cut && cut->length < kPinchWidth * gap) return cut;
  }
  return std::nullopt;
}

/// Cuts the polygon there. Returns the piece, or null.
const Segment* cut_at(Complex& complex, const Segment& s, const Pinch& pinch) {
  const PolygonPart& part = *s.polygon;
  const double gap = complex.setting().scale_at(pinch.at).gap;
  auto cut = cut_near(complex, part.perimeter, pinch, gap);
  if (!cut || cut->piece.area() < kLeastPart * gap * gap) return nullptr;
  geometry::Polygon rest = part.perimeter;
  geometry::EdgeIds unused = complex.edge_ids();
  rest.commit(cut->rest, unused);
  const auto portions = divided(complex.setting(), s, rest, cut->piece);
  if (!portions) return nullptr;
  auto piece = std::make_unique<PolygonPart>();
  piece->chart = part.chart;
  piece->published = part.published;
  piece->outward = part.outward;
  piece->initial = part.initial;
  piece->perimeter = std::move(cut->piece);
  return &complex.split(s, cut->rest, std::move(piece), *portions);
}

}  // namespace

bool cut_at_pinches(Complex& complex, Agenda& agenda) {
  if (!complex.rules().pinches) return false;
  Turn turn = polygons_of(complex, agenda.modified(), [&](const Segment& s) {
    return s.mature_polygon() && agenda.polygon(s.slot).no_pinch != s.polygon->shape;
  });
  bool any = false;
  for (std::size_t i = 0; i < turn.size() && !agenda.stopped(); ++i) {
    const Segment& s = complex.at(turn[i].second);
    agenda.polygon(s.slot).no_pinch = s.polygon->shape;
    for (const Pinch& pinch : PinchSearch(complex, s).all()) {
      const Segment* piece = cut_at(complex, s, pinch);
      if (!piece) continue;
      any = true;
      agenda.note_parting(pinch.at);
      turn.emplace_back(s.id, s.slot);  // each part may have another
      turn.emplace_back(piece->id, piece->slot);
      break;
    }
  }
  return any;
}

bool parted(const Setting& setting, const Agenda& agenda, const Segment& a, const Segment& b) {
  return std::any_of(agenda.partings().begin(), agenda.partings().end(), [&](const Eigen::Vector3d& at) {
    return lies_near(setting, *a.polygon, at) && lies_near(setting, *b.polygon, at);
  });
}

}  // namespace limpet::model::internal
