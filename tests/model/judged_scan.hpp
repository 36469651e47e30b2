// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <gtest/gtest.h>

#include <limpet/evaluation/judgement.hpp>
#include <limpet/evaluation/planar_face.hpp>
#include <limpet/evaluation/topology.hpp>
#include <map>

#include "streams.hpp"

/// Scans that know what was scanned, and models held against it.
namespace limpet::model::testing {

using Order = simulation::ScanOptions::Order;

/// A scan of a mesh, with the parameters that suit it.
struct JudgedScan {
  simulation::Mesh truth;
  std::vector<simulation::LabelledPoint> labelled;
  Points points;
  Parameters parameters;

  /// How a model's neighbour relation compares with the truth's.
  evaluation::TopologyReport topology(const ModelRecord& record) const {
    const auto faces =
        evaluation::judge_faces(evaluation::planar_faces(record), truth, labelled,
                                {.resolution = parameters.resolution, .noise = parameters.noise});
    return evaluation::judge_topology(record, truth, faces);
  }
};

/// `noise` is in the scan's unit.
inline JudgedScan judged_scan(simulation::Mesh mesh, double resolution, double noise,
                              simulation::ScanOptions options) {
  JudgedScan result;
  result.truth = std::move(mesh);
  result.parameters.resolution = resolution;
  result.parameters.noise = options.noise = noise;
  result.labelled = simulation::scan(result.truth, options);
  for (const auto& p : result.labelled) result.points.push_back(p.point);
  return result;
}

/// Sampled evenly, at about five points per λ².
inline JudgedScan sampled_scan(simulation::Mesh mesh, double resolution, double noise = 0,
                               std::uint64_t seed = 1) {
  double area = 0;
  for (const auto& face : simulation::faces_of(mesh)) area += face.area;
  simulation::ScanOptions options;
  options.order = Order::sampled;
  options.points = static_cast<std::int64_t>(5 * area / (resolution * resolution));
  options.seed = seed;
  return judged_scan(std::move(mesh), resolution, noise, options);
}

/// A named shape; `noise` is a fraction of its largest extent. λ is such that there are `density` points on
/// λ².
inline JudgedScan judged_shape(const std::string& shape, std::int64_t count, double noise, Order order,
                               std::uint64_t seed = 1, double density = 5) {
  auto scene = simulation::make_scene(shape);
  const auto bounds = simulation::bounds_of(scene.mesh);
  double area = 0;
  for (const auto& face : simulation::faces_of(scene.mesh)) area += face.area;
  simulation::ScanOptions options;
  options.points = count;
  options.order = order;
  options.seed = seed;
  options.viewpoints = scene.viewpoints;
  return judged_scan(std::move(scene.mesh),
                     std::max(scene.feature / 20, std::sqrt(density * area / static_cast<double>(count))),
                     noise * (bounds.high - bounds.low).maxCoeff(), options);
}

/// The finished model; after every `every`-th set the oracle has to find nothing.
inline Model watched(const Parameters& parameters, const Points& points, std::size_t every = 20,
                     std::size_t set_size = 26) {
  Model model(parameters);
  std::string broken;
  std::size_t set = 0;
  for (std::size_t i = 0; i < points.size() && broken.empty(); i += set_size) {
    model.update(std::span(points).subspan(i, std::min(set_size, points.size() - i)));
    if (++set % every == 0) broken = broken_laws(model.record());
    EXPECT_EQ(broken, "") << "set " << set;
  }
  model.finish();
  EXPECT_EQ(broken_laws(model.record()), "") << "finished";
  return model;
}

/// Faults of a topology, one a line.
inline std::string faults_of(const evaluation::TopologyReport& topology) {
  std::string all;
  for (const auto& fault : topology.faults) all += fault + "\n";
  return all;
}

/// Shared edges by identity, each under both of its copies.
inline std::map<std::uint64_t, std::uint64_t> partners_of(const ModelRecord& record) {
  std::map<std::uint64_t, std::uint64_t> partners;
  for (const auto& s : record.polygon_segments)
    for (const auto& cycle : s.cycles)
      for (const auto& v : cycle)
        if (v.partner != 0) partners[v.edge] = v.partner;
  return partners;
}

/// Identities of the segments that edges are on.
inline std::map<std::uint64_t, std::uint64_t> segments_of_edges(const ModelRecord& record) {
  std::map<std::uint64_t, std::uint64_t> segments;
  for (const auto& s : record.polygon_segments)
    for (const auto& cycle : s.cycles)
      for (const auto& v : cycle) segments[v.edge] = s.id;
  return segments;
}

}  // namespace limpet::model::testing
