// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include <limpet/audit/document.hpp>
#include <limpet/audit/laws.hpp>
#include <limpet/io/native.hpp>
#include <limpet/model/model.hpp>
#include <limpet/simulation/mesh.hpp>
#include <limpet/simulation/scan.hpp>
#include <limpet/simulation/scene.hpp>
#include <limpet/survey/random.hpp>

/// What the tests of models have in common: streams of readings, and what is asked of a model.
namespace limpet::model::testing {

using Eigen::Vector3d;
using survey::Random;
using Points = std::vector<SensorPoint>;

/// How many runs a test makes: as the environment says, else so many.
inline std::uint64_t wanted(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

inline Parameters of_resolution(double resolution) {
  Parameters p;
  p.resolution = resolution;
  return p;
}

inline void feed(Model& model, const Points& points, std::size_t set_size = 26) {
  for (std::size_t i = 0; i < points.size(); i += set_size)
    model.update(std::span(points).subspan(i, std::min(set_size, points.size() - i)));
}

/// The finished model of a stream.
inline Model modelled(const Parameters& parameters, const Points& points, std::size_t set_size = 26) {
  Model model(parameters);
  feed(model, points, set_size);
  model.finish();
  return model;
}

/// The native file, byte for byte.
inline std::string bytes(const ModelRecord& record) {
  std::ostringstream text;
  io::write_native(text, record);
  return text.str();
}

inline std::vector<audit::Violation> violations(const ModelRecord& record) {
  return audit::judge(audit::parse_document(bytes(record)));
}

/// What the oracle has against a model, one law a line; empty when nothing is broken.
inline std::string broken_laws(const ModelRecord& record) {
  std::string all;
  for (const auto& v : violations(record)) all += v.law + " (" + v.where + "): " + v.what + "\n";
  return all;
}

/// Points at random, evenly over a rectangle of the plane z = 0, seen from above.
inline Points plate(Random& random, int count, double x0, double y0, double x1, double y1, double noise = 0) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(x0, x1), y = random.uniform(y0, y1);
    points.push_back({{x, y, noise * random.normal()}, {0, 0, -1}});
  }
  return points;
}

/// The points farther than `radius` from the z axis.
inline Points bored(const Points& points, double radius) {
  Points rest;
  std::copy_if(points.begin(), points.end(), std::back_inserter(rest),
               [&](const auto& p) { return p.position.template head<2>().norm() > radius; });
  return rest;
}

inline void shuffle(Points& points, auto& random) {
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
}

/// A simulated scan and the parameters that suit it; `noise` as a fraction of the largest extent.
struct Scan {
  Points points;
  Parameters parameters;
};
inline Scan scanned(const std::string& shape, std::int64_t count, double noise,
                    simulation::ScanOptions::Order order, std::uint64_t seed = 1) {
  const auto scene = simulation::make_scene(shape);
  const auto bounds = simulation::bounds_of(scene.mesh);
  double area = 0;
  for (const auto& face : simulation::faces_of(scene.mesh)) area += face.area;
  Scan result;
  result.parameters.resolution =
      std::max(scene.feature / 20, 2.2 * std::sqrt(area / static_cast<double>(count)));
  result.parameters.noise = noise * (bounds.high - bounds.low).maxCoeff();
  simulation::ScanOptions options;
  options.points = count;
  options.order = order;
  options.noise = result.parameters.noise;
  options.seed = seed;
  options.viewpoints = scene.viewpoints;
  simulation::scan(scene.mesh, options,
                   [&](const simulation::LabelledPoint& p) { result.points.push_back(p.point); });
  return result;
}

/// Vertices of a record's polygon in the world, cycle by cycle.
inline std::vector<std::vector<Vector3d>> world_cycles(const PolygonSegmentRecord& s, double step) {
  std::vector<std::vector<Vector3d>> cycles;
  for (const auto& cycle : s.cycles) {
    auto& vertices = cycles.emplace_back();
    for (const auto& v : cycle) {
      const double h = s.height[0] + s.height[1] * v.x + s.height[2] * v.y;
      vertices.push_back(s.chart_origin + step * (v.x * s.chart_u + v.y * s.chart_v + h * s.chart_normal));
    }
  }
  return cycles;
}

/// Vertices of the outer perimeter in the world.
inline std::vector<Vector3d> world_perimeter(const PolygonSegmentRecord& s, double step) {
  return world_cycles(s, step)[0];
}

/// Outward normal of the published plane.
inline Vector3d normal_of(const PolygonSegmentRecord& s) {
  return (s.chart_normal - s.height[1] * s.chart_u - s.height[2] * s.chart_v).normalized();
}

inline std::size_t holes_of(const ModelRecord& record) {
  std::size_t holes = 0;
  for (const auto& s : record.polygon_segments) holes += s.cycles.size() - 1;
  return holes;
}

/// Sensor points in segments of either kind.
inline std::int64_t points_in_segments(const ModelRecord& record) {
  std::int64_t points = 0;
  for (const auto& s : record.point_segments) points += s.moments.count;
  for (const auto& s : record.polygon_segments) points += s.moments.count;
  return points;
}

}  // namespace limpet::model::testing
