// Copyright the limpet authors. GPL-3.0-or-later.
//
// Deleting redundant segments (thesis §2.9): small ones among others, which merge with none of these and find
// no edge to share. Their data goes to segments that it fits.
#include <algorithm>

#include "meeting_internal.hpp"
#include "merging_internal.hpp"
#include "redundancy_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::Slot;

/// Is a point of a segment with this normal within λ of the other polygon, and do both face about the same
/// way? By distance alone, the back of a thin plate would be redundant, or a small face of a box, whose
/// perimeter lies on the faces around it. The normal of a sliver across an edge differs by half of the angle
/// there.
bool lies_on(const Setting& setting, const Segment& other, const Eigen::Vector3d& p,
             const Eigen::Vector3d& normal) {
  return other.polygon->outward.dot(normal) > kSameWay && lies_near(setting, *other.polygon, p);
}

/// The area of a polygon in λ², and the diagonal of its box in λ.
std::pair<double, double> size_of(const Setting& setting, const PolygonPart& part) {
  const Scale scale = setting.scale_at(part.box.center());
  return {part.perimeter.area() / (scale.gap * scale.gap), part.box.diagonal().norm() / scale.lambda};
}

/// Is the polygon only a patch or a sliver? A larger and wider one is a surface of its own, however near
/// others are.
bool is_small(const Setting& setting, const PolygonPart& part) {
  const auto [area, length] = size_of(setting, part);
  return area < kYoungArea || area < 1.5 * length;
}

/// Is the polygon hardly wider than nothing? Then it may be a sliver across an edge, however many points it
/// has, and although it shares edges with the faces there.
bool is_thin(const Setting& setting, const PolygonPart& part) {
  const auto [area, length] = size_of(setting, part);
  return length > kLeastSliver && area < kSliverWidth * length;
}

bool is_narrow(const Setting& setting, const PolygonPart& part) {
  const auto [area, length] = size_of(setting, part);
  return length > kLeastSliver && area < kLeftOverWidth * length;
}

/// Was the polygon felt so much less densely than another that it got only what that left over?
bool is_felt_thinly(const Setting& setting, const Segment& s, const Segment& other) {
  const double own = size_of(setting, *s.polygon).first, theirs = size_of(setting, *other.polygon).first;
  return static_cast<double>(s.count()) * theirs < kLeftOverPart * static_cast<double>(other.count()) * own;
}

/// Did the narrow polygon get only the readings that another left over along its edge? Then it lies within
/// the tolerance of that.
bool is_left_over(const Setting& setting, const Segment& s, const std::vector<const Segment*>& others) {
  const double tolerance2 = setting.parameters.tolerance * setting.parameters.tolerance;
  return std::any_of(others.begin(), others.end(), [&](const Segment* other) {
    return is_felt_thinly(setting, s, *other) && other->polygon->outward.dot(s.polygon->outward) > kSameWay &&
           s.data.moments().squared_residual(other->fit.plane(), setting.step) <= tolerance2;
  });
}

/// Does the polygon lie across the edge of others, all of which were felt more densely? A true chamfer of
/// this width is felt about as densely as the faces beside it.
bool lies_across(const Setting& setting, const Segment& s, const std::vector<const Segment*>& under) {
  const auto [area, length] = size_of(setting, *s.polygon);
  return under.size() >= 2 && length > kLeastSliver && area < kAcrossWidth * length &&
         std::all_of(under.begin(), under.end(),
                     [&](const Segment* other) { return is_felt_thinly(setting, s, *other); });
}

/// Is a segment redundant by position: is it a patch, a sliver or what was left over, and do all its vertices
/// lie on segments of which each has more than twice as many points (kLargerPart)?
bool lies_on_others(const Complex& complex, const Segment& s) {
  const PolygonPart& part = *s.polygon;
  const Setting& setting = complex.setting();
  const bool patch_or_sliver = is_small(setting, part) && (part.shared.empty() || is_thin(setting, part));
  if (!patch_or_sliver && !is_narrow(setting, part)) return false;
  std::vector<std::uint32_t> found;
  complex.polygons().query(part.box, found);
  std::vector<const Segment*> others;
  for (const std::uint32_t slot : found)
    if (const Segment& other = complex.at(slot); other.count() > kLargerPart * s.count())
      others.push_back(&other);
  std::vector<const Segment*> under;  // those of them that a vertex lies on
  bool all = !others.empty();
  for_each_edge(part.perimeter, [&](Slot vertex) {
    if (!all) return;
    bool any = false;
    for (const Segment* other : others) {
      if (!lies_on(setting, *other, part.position(vertex), part.outward)) continue;
      any = true;
      if (std::find(under.begin(), under.end(), other) == under.end()) under.push_back(other);
    }
    all = any;
  });
  return all && (patch_or_sliver || is_left_over(setting, s, others) || lies_across(setting, s, under));
}

bool may_be_redundant_by_position(const Segment& s) { return s.polygon && s.count() > 0; }

/// The polygon, other than `but`, that the data fits best, and the data's standing to it.
std::pair<const Segment*, Standing> best_for(const Complex& complex, const Segment* but,
                                             const Eigen::Vector3d& p, const Eigen::Vector3d& axis,
                                             const Moments& data, double variance) {
  std::pair<const Segment*, Standing> best{nullptr, {}};
  std::vector<std::uint32_t> found;
  complex.polygons().query(p, found);
  std::sort(found.begin(), found.end(),
            [&](std::uint32_t a, std::uint32_t b) { return complex.at(a).id < complex.at(b).id; });
  for (const std::uint32_t slot : found) {
    const Segment& other = complex.at(slot);
    if (&other == but || other.initial()) continue;
    const double residual2 = data.squared_residual(other.fit.plane(), complex.setting().step);
    const Standing st = standing(complex.setting(), other, p, axis, residual2, variance);
    if (st.near && (!best.first || st.distance2 < best.second.distance2)) best = {&other, st};
  }
  return best;
}

}  // namespace

std::int64_t delete_segment(Complex& complex, Agenda& agenda, Labels& labels, const Segment& s) {
  complex.dissolve_all_neighbours(s);
  if (s.count() > 0)
    if (const auto [other, st] =
            best_for(complex, &s, s.fit.centroid, s.data.axis_sum(), s.data.moments(), s.data.variance());
        other && merge_segment_into_polygon(complex, agenda, *other, s, st))
      return 0;
  const std::vector<RawPoint> raw = s.data.raw();
  std::int64_t lost = s.count() - static_cast<std::int64_t>(raw.size());
  complex.remove(s);
  for (const RawPoint& point : raw) {
    const auto [other, st] = best_for(complex, nullptr, complex.setting().world(point.at), point.axis,
                                      Moments(point.at), point.variance);
    if (other && merge_point_into_polygon(complex, agenda, *other, point, st))
      labels.set(point, other->id);
    else
      ++lost;
  }
  return lost;
}

void note_if_redundant(const Setting& setting, Agenda& agenda, const Segment& a, const Segment& b) {
  const Segment& small = a.count() < b.count() ? a : b;
  const auto n1 = static_cast<double>(small.count()),
             n2 = static_cast<double>(std::max(a.count(), b.count()));
  if (n1 > 0 && n1 < setting.parameters.redundancy_count && n1 < setting.parameters.redundancy_ratio * n2)
    agenda.note_redundant(small.id);
}

bool delete_redundant(Complex& complex, Agenda& agenda, Labels& labels, Counts& counts) {
  std::vector<SegmentId> ids = agenda.take_redundant();
  const std::size_t by_count = ids.size();
  if (agenda.finishing && complex.rules().position)
    complex.segments().for_each([&](const Segment& s) {
      if (may_be_redundant_by_position(s)) ids.push_back(s.id);
    });
  std::sort(ids.begin() + static_cast<std::ptrdiff_t>(by_count), ids.end());
  bool any = false;
  for (std::size_t i = 0; i < ids.size() && !agenda.stopped(); ++i) {
    const Segment* s = complex.find(ids[i]);
    if (!s || !s->polygon) continue;
    const bool redundant = i < by_count ? s->polygon->shared.empty()
                                        : may_be_redundant_by_position(*s) && lies_on_others(complex, *s);
    if (!redundant) continue;
    ++(i < by_count ? counts.redundant_by_count : counts.redundant_by_position);
    counts.expired += delete_segment(complex, agenda, labels, *s);
    any = true;
  }
  return any;
}

}  // namespace limpet::model::internal
