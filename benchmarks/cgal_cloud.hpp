// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/property_map.h>

#include "contestants.hpp"

/// A cloud as CGAL's plane detectors take it, whole and with normals, and what they are all told.
namespace limpet::benchmarks {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using PointMap = CGAL::First_of_pair_property_map<Oriented>;
using NormalMap = CGAL::Second_of_pair_property_map<Oriented>;
using OrientedPoints = std::vector<Oriented>;

inline constexpr unsigned kNeighbours = 12;

inline OrientedPoints read_oriented(const ScanCase& scan_case, const std::string& path) {
  OrientedPoints points;
  points.reserve(static_cast<std::size_t>(1.06 * static_cast<double>(scan_case.spec.points)));
  CloudReader reader(path);
  for (auto some = reader.next(4096); !some.empty(); some = reader.next(4096)) {
    for (const auto& p : some) {
      const Eigen::Vector3d n = p.face >= 0 ? scan_case.faces[static_cast<std::size_t>(p.face)].normal
                                            : Eigen::Vector3d(-p.point.axis);
      const Eigen::Vector3d& at = p.point.position;
      points.emplace_back(Kernel::Point_3(at.x(), at.y(), at.z()), Kernel::Vector_3(n.x(), n.y(), n.z()));
    }
  }
  return points;
}

/// How far a point may be from its plane.
inline double max_distance(const ScanCase& s) { return std::max(3 * s.noise, s.resolution / 20); }

/// The least points of a plane: a quarter of what the smallest face has, but for the least that counts. A
/// gift: who knows that of a real scan?
inline std::size_t smallest_plane(const ScanCase& s) {
  return static_cast<std::size_t>(std::max(50.0, s.smallest_face_points / 4));
}

/// `planes`: containers of indices of points. What judging needs comes after the peak was taken.
template <class Planes>
Json answer_of(const ScanCase& scan_case, const std::string& path, const Planes& planes, double seconds,
               double megabytes) {
  std::vector<int> face_of, plane_of;
  CloudReader reader(path);
  for (auto some = reader.next(4096); !some.empty(); some = reader.next(4096))
    for (const auto& p : some) face_of.push_back(p.face);
  plane_of.resize(face_of.size(), -1);
  std::int64_t in_planes = 0;
  int plane = 0;
  for (const auto& members : planes) {
    for (const std::size_t i : members) plane_of[i] = plane, ++in_planes;
    ++plane;
  }
  const RightFaces faces = faces_right_by_points(scan_case, face_of, plane_of);
  return {{"points", face_of.size()},  {"seconds", seconds},     {"megabytes", megabytes},
          {"planes", plane},           {"in_planes", in_planes}, {"faces_counted", faces.counted},
          {"faces_right", faces.right}};
}

}  // namespace limpet::benchmarks
