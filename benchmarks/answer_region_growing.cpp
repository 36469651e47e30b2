// Copyright the limpet authors. GPL-3.0-or-later.
#include <iterator>

#include <CGAL/Shape_detection/Region_growing/Region_growing.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing_on_point_set.h>

#include "cgal_cloud_internal.hpp"

namespace limpet::benchmarks {
namespace {

using namespace internal;

namespace growing = CGAL::Shape_detection::Point_set;
using NearestQuery = growing::K_neighbor_query<Kernel, OrientedPoints, PointMap>;
using SphereQuery = growing::Sphere_neighbor_query<Kernel, OrientedPoints, PointMap>;
using PlaneRegion = growing::Least_squares_plane_fit_region<Kernel, OrientedPoints, PointMap, NormalMap>;

constexpr double kMaxAngleDeg = 25;

template <class Query>
Regions grow(const ScanCase& scan_case, const OrientedPoints& points, Query&& query) {
  PlaneRegion region(points, max_distance(scan_case), kMaxAngleDeg, smallest_plane(scan_case));
  CGAL::Shape_detection::Region_growing<OrientedPoints, std::remove_cvref_t<Query>, PlaneRegion> grower(
      points, query, region);
  Regions regions;
  grower.detect(std::back_inserter(regions));
  return regions;
}

}  // namespace

Regions internal::grow_regions(const ScanCase& scan_case, const OrientedPoints& points) {
  return grow(scan_case, points, NearestQuery(points, kNeighbours));
}

Json answer_region_growing(const Json& request) {
  const ScanCase scan_case(request.at("spec").get<CloudSpec>());
  const double before = resident_megabytes();
  const std::string path = request.at("cloud");
  OrientedPoints points = read_oriented(scan_case, path);
  const CpuWatch watch;
  if (request.value("estimate", false)) estimate_normals(points);
  const Regions regions = request.value("sphere", false)
                              ? grow(scan_case, points, SphereQuery(points, scan_case.spacing))
                              : grow_regions(scan_case, points);
  const double seconds = watch.seconds();
  return answer_of(scan_case, path, regions, seconds, peak_megabytes() - before);
}

}  // namespace limpet::benchmarks
