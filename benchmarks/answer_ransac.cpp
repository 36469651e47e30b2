// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <numeric>

#include <CGAL/Random.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>

#include "cgal_cloud_internal.hpp"

namespace limpet::benchmarks {
namespace {

using namespace internal;

/// RANSAC leaves the points in another order than they came in: makes indices those of the file again.
void restore_order(const ScanCase& scan_case, const std::string& path, const OrientedPoints& points,
                   std::vector<std::vector<std::size_t>>& planes) {
  const OrientedPoints as_read = read_oriented(scan_case, path);
  const auto by_position = [](const OrientedPoints& of) {
    std::vector<std::size_t> order(of.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return of[i].first < of[j].first; });
    return order;
  };
  const std::vector<std::size_t> from = by_position(points), to = by_position(as_read);
  std::vector<std::size_t> index_in_file(points.size());
  for (std::size_t k = 0; k < from.size(); ++k) index_in_file[from[k]] = to[k];
  for (auto& plane : planes)
    for (std::size_t& i : plane) i = index_in_file[i];
}

}  // namespace

Json answer_ransac(const Json& request) {
  using Traits = CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, OrientedPoints, PointMap, NormalMap>;
  using Ransac = CGAL::Shape_detection::Efficient_RANSAC<Traits>;

  const ScanCase scan_case(request.at("spec").get<CloudSpec>());
  const double before = resident_megabytes();
  const std::string path = request.at("cloud");
  OrientedPoints points = read_oriented(scan_case, path);
  CGAL::get_default_random() = CGAL::Random(1);
  const CpuWatch watch;
  if (request.value("estimate", false)) estimate_normals(points);
  Ransac ransac;
  ransac.set_input(points);
  ransac.add_shape_factory<CGAL::Shape_detection::Plane<Traits>>();
  Ransac::Parameters parameters;  // the others as CGAL has them: 25°, and a chance of 1 % to miss a plane
  parameters.min_points = smallest_plane(scan_case);
  parameters.epsilon = max_distance(scan_case);
  parameters.cluster_epsilon = scan_case.spacing;
  ransac.detect(parameters);
  const double seconds = watch.seconds();
  const double megabytes = peak_megabytes() - before;
  std::vector<std::vector<std::size_t>> planes;
  for (const auto& plane : ransac.planes()) planes.push_back(plane->indices_of_assigned_points());
  restore_order(scan_case, path, points, planes);
  return answer_of(scan_case, path, planes, seconds, megabytes);
}

}  // namespace limpet::benchmarks
