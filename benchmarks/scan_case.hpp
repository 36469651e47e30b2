// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <limpet/simulation/mesh.hpp>

/// What a benchmark asks of a shape and a number of points, the same in all of them.
namespace limpet::benchmarks {

/// "0.2 % of the object's size": the object's largest extent; in a city that of one box, which is about 1
/// wide; in a room the width of what stands in it.
inline double size_of(const std::string& shape, const simulation::Mesh& mesh, double feature) {
  if (shape.starts_with("city")) return 1;
  if (shape.starts_with("room")) return feature;
  const auto bounds = simulation::bounds_of(mesh);
  return (bounds.high - bounds.low).maxCoeff();
}

inline double area_of(const simulation::Mesh& mesh) {
  double area = 0;
  for (const auto& face : simulation::faces_of(mesh)) area += face.area;
  return area;
}

/// A sphere of this radius about a point of the surface holds about 15 points; λ² about 5.
inline double spacing(double area, std::int64_t points) {
  return 2.2 * std::sqrt(area / static_cast<double>(points));
}

/// λ: fine enough for the shape's features, and not finer than the points can show.
inline double resolution(double feature, double area, std::int64_t points) {
  return std::max(feature / 20, spacing(area, points));
}

}  // namespace limpet::benchmarks
