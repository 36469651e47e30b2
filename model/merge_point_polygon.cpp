// Copyright the limpet authors. GPL-3.0-or-later.
//
// Merging a point segment and a planar polygon segment (thesis §2.4.2).
#include <cmath>

#include <limpet/geometry/extend.hpp>

#include "merging_internal.hpp"
#include "publish_internal.hpp"
#include "young_internal.hpp"

namespace limpet::model::internal {
namespace {

/// The conditions on the merged moments: the variance (thesis, and where the fit could not be published); and
/// the initial plane while the polygon is young (later, the fit moves too little between two refits).
template <class Data>  // Moments, or a single GridPoint
bool merged_moments_accepted(const Setting& setting, const Segment& polygon, const Data& added) {
  const bool check_variance = !setting.rules().residual;
  Moments merged = polygon.data.moments();
  merged.add(added);
  if (!variance_allowed(setting, *polygon.polygon, merged)) return false;
  if (!check_variance && !polygon.young()) return true;
  const Fit fit = fit_to(merged, setting.step, -polygon.fit.normal);
  if (check_variance && fit.u3 >= setting.scale_at(fit.centroid).lambda2) return false;
  return !differs_from_initial(setting, *polygon.polygon, fit);
}

/// May the polygon's plane be that of the merged data, too? The normal still faces outside; and where moments
/// are asked, they are accepted. Of most points they are not.
template <class Data>
inline bool merged_fit_accepted(const Setting& setting, const Segment& polygon, const Data& added,
                                const Eigen::Vector3d& axis) {
  if (!faces_outside(polygon.polygon->outward, polygon.data.axis_sum() + axis)) return false;
  const bool settled = setting.rules().residual && !polygon.young() && !polygon.polygon->stale;
  return settled || merged_moments_accepted(setting, polygon, added);
}

/// Does the perimeter grow by the projected point? Not if that is inside, or so near that it adds nothing.
bool adds_area(const Setting& setting, const Standing& st) {
  return st.outside && !(setting.rules().near && std::sqrt(st.nearest.squared_distance) < st.gap / 4);
}

/// Makes the projected point a vertex. False if the extension was refused.
bool extend_perimeter(Complex& complex, const Segment& polygon, const Standing& st) {
  const auto at_new_edges = [&](const BoundaryDifference& difference) {
    Box3 box;
    for (const auto& [slot, edge] : difference.put) box.extend(polygon.polygon->position(slot));
    return box;
  };
  const auto extension = complex.change_perimeter(
      polygon, false, at_new_edges, [&](geometry::Polygon& perimeter, geometry::EdgeIds& ids) {
        return geometry::extend_from(st.nearest, perimeter, st.chart_point, st.gap, ids);
      });
  if (extension == geometry::Extension::refused) return false;
  if (polygon.polygon->felt) complex.felt_at(polygon, polygon.polygon->at(st.chart_point));
  return true;
}

inline void joined(Complex& complex, Agenda& agenda, const Segment& polygon) {
  agenda.mark_modified(polygon.slot);
  refit_if_due(complex, agenda, polygon);
}

}  // namespace

bool merge_point_into_polygon(Complex& complex, Agenda& agenda, const Segment& polygon, const RawPoint& raw,
                              const Standing& st) {
  if (!merged_fit_accepted(complex.setting(), polygon, raw.at, raw.axis) ||
      (adds_area(complex.setting(), st) && !extend_perimeter(complex, polygon, st)))
    return false;
  complex.absorb(polygon, raw);
  joined(complex, agenda, polygon);
  return true;
}

bool merge_segment_into_polygon(Complex& complex, Agenda& agenda, const Segment& polygon,
                                const Segment& other, const Standing& st) {
  const Setting& setting = complex.setting();
  if (!merged_fit_accepted(setting, polygon, other.data.moments(), other.data.axis_sum()) ||
      (adds_area(setting, st) && !extend_perimeter(complex, polygon, st)))
    return false;
  const bool young =
      polygon.young() && other.young() && may_be_young(setting, polygon.count() + other.count(), polygon.fit);
  complex.absorb(polygon, other, young);
  joined(complex, agenda, polygon);
  return true;
}

}  // namespace limpet::model::internal
