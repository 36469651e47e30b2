// Copyright the limpet authors. GPL-3.0-or-later.
#include <fstream>
#include <tuple>

#include <CGAL/GLPK_mixed_integer_program_traits.h>
#include <CGAL/Polygonal_surface_reconstruction.h>
#include <CGAL/Surface_mesh.h>

#include "cgal_cloud_internal.hpp"

namespace limpet::benchmarks {
namespace {

using namespace internal;

/// Point, normal, index of the plane (−1: none).
using Planar = std::tuple<Kernel::Point_3, Kernel::Vector_3, int>;
using PlanarPoints = std::vector<Planar>;
using PolyFit = CGAL::Polygonal_surface_reconstruction<Kernel>;
using Solver = CGAL::GLPK_mixed_integer_program_traits<double>;
using Polyhedron = CGAL::Surface_mesh<Kernel::Point_3>;

PlanarPoints with_planes(const OrientedPoints& points, const Regions& planes) {
  PlanarPoints result;
  result.reserve(points.size());
  for (const auto& [at, normal] : points) result.emplace_back(at, normal, -1);
  for (std::size_t plane = 0; plane < planes.size(); ++plane)
    for (const std::size_t i : planes[plane]) std::get<2>(result[i]) = static_cast<int>(plane);
  return result;
}

void save(const Polyhedron& polyhedron, const std::string& path) {
  std::ofstream file(path);
  file.precision(17);
  if (!CGAL::IO::write_OFF(file, polyhedron) || !file.flush())
    throw std::runtime_error("cannot write " + path);
}

}  // namespace

Json answer_polyfit(const Json& request) {
  const ScanCase scan_case(request.at("spec").get<CloudSpec>());
  const double before = resident_megabytes();
  OrientedPoints points = read_oriented(scan_case, request.at("cloud"));
  Json answer{{"points", points.size()}};
  double seconds = 0;
  const auto tell = [&](const std::string& stage, const CpuWatch& watch) {
    seconds += watch.seconds();
    answer[stage + "_seconds"] = watch.seconds();
    answer["seconds"] = seconds;
    answer["megabytes"] = peak_megabytes() - before;
    tell_so_far(answer);
  };

  const CpuWatch detecting;
  const Regions planes = grow_regions(scan_case, points);
  const PlanarPoints planar_points = with_planes(points, planes);
  OrientedPoints().swap(points);
  answer["planes"] = planes.size();
  tell("detecting", detecting);

  const CpuWatch generating;
  PolyFit polyfit(planar_points, CGAL::Nth_of_tuple_property_map<0, Planar>(),
                  CGAL::Nth_of_tuple_property_map<1, Planar>(), CGAL::Nth_of_tuple_property_map<2, Planar>());
  tell("generating", generating);
  Polyhedron polyhedron;
  polyfit.output_candidate_faces(polyhedron);
  answer["candidates"] = polyhedron.number_of_faces();
  tell_so_far(answer);

  const CpuWatch solving;
  const bool is_solved = polyfit.reconstruct<Solver>(polyhedron);
  tell("solving", solving);
  if (!is_solved) return {{"failed", polyfit.error_message()}, {"so_far", answer}};
  answer["faces"] = polyhedron.number_of_faces();
  save(polyhedron, request.at("mesh"));
  return answer;
}

}  // namespace limpet::benchmarks
