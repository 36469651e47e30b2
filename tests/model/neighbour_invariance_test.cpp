// Copyright the limpet authors. GPL-3.0-or-later.
//
// What the neighbour relation does not depend on.
#include <gtest/gtest.h>

#include <limpet/io/polygon_mesh.hpp>
#include <optional>
#include <set>

#include "judged_scan.hpp"
#include "solids.hpp"

namespace limpet::model {
namespace {

using namespace testing;

JudgedScan moved(JudgedScan scan, const Vector3d& by) {
  for (auto& p : scan.truth.vertices) p += by;
  for (auto& p : scan.labelled) p.point.position += by;
  for (auto& p : scan.points) p.position += by;
  return scan;
}

TEST(Topology, IsTheSameFarAway) {
  for (const std::string name : {"cube", "L", "octahedron"}) {
    const JudgedScan here = judged_shape(name, 6'000, 0.002, Order::shuffled);
    const JudgedScan there = moved(here, {1e6, -1e6, 1e3});
    const auto a = here.topology(watched(here.parameters, here.points).record());
    const auto b = there.topology(watched(there.parameters, there.points).record());
    EXPECT_TRUE(a.closed && a.isomorphic) << name << "\n" << faults_of(a);
    EXPECT_TRUE(b.closed && b.isomorphic) << name << "\n" << faults_of(b);
    EXPECT_LT(b.vertex_distance, there.parameters.resolution / 4) << name;
  }
}

TEST(Topology, IsTheSameInAnyUnit) {
  for (const double scale : {1e-3, 25.4, 1e5}) {
    JudgedScan scan = judged_shape("cube", 5'000, 0.002, Order::shuffled);
    for (auto& p : scan.truth.vertices) p *= scale;
    for (auto& p : scan.labelled) p.point.position *= scale;
    for (auto& p : scan.points) p.position *= scale;
    scan.parameters.resolution *= scale;
    scan.parameters.noise *= scale;
    const auto topology = scan.topology(watched(scan.parameters, scan.points).record());
    EXPECT_TRUE(topology.closed && topology.isomorphic) << scale << "\n" << faults_of(topology);
  }
}

TEST(Topology, IsTheSameTurned) {
  Random random(5);
  for (int i = 0; i < 4; ++i) {
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal())
            .normalized()
            .toRotationMatrix();
    JudgedScan scan = judged_shape("L", 6'000, 0.001, Order::sampled);
    for (auto& p : scan.truth.vertices) p = turn * p;
    for (auto& p : scan.labelled) p.point.position = turn * p.point.position;
    for (auto& p : scan.points) p = {turn * p.position, turn * p.axis};
    const auto topology = scan.topology(watched(scan.parameters, scan.points).record());
    EXPECT_TRUE(topology.closed && topology.isomorphic) << i << "\n" << faults_of(topology);
  }
}

TEST(Topology, IsTheSameForSetsOfAnySize) {
  for (const Order order : {Order::raster, Order::sampled}) {
    const JudgedScan scan = judged_shape("cube", 6'000, 0.001, order);
    for (const std::size_t size : {1u, 26u, 1000u}) {
      const Model model = watched(scan.parameters, scan.points, 520 / std::min<std::size_t>(size, 520), size);
      const auto topology = scan.topology(model.record());
      EXPECT_TRUE(topology.closed && topology.isomorphic) << "sets of " << size << "\n"
                                                          << faults_of(topology);
    }
  }
}

TEST(Topology, OfTheSameStreamIsTheSameBytes) {
  const JudgedScan scan = judged_shape("step_hole", 10'000, 0.002, Order::shuffled);
  const ModelRecord a = modelled(scan.parameters, scan.points).record(),
                    b = modelled(scan.parameters, scan.points).record();
  EXPECT_GT(partners_of(a).size(), 20u);
  EXPECT_EQ(bytes(a), bytes(b));
}

/// Vertices less edges plus faces of a mesh whose every edge has two faces, in opposite directions; nothing
/// of any other.
std::optional<int> euler_characteristic(const io::PolygonMesh& mesh) {
  std::set<std::pair<int, int>> halves;
  std::set<int> vertices;
  for (const auto& face : mesh.faces)
    for (std::size_t i = 0; i < face.vertices.size(); ++i) {
      vertices.insert(face.vertices[i]);
      if (!halves.insert({face.vertices[i], face.vertices[(i + 1) % face.vertices.size()]}).second)
        return std::nullopt;
    }
  for (const auto& [from, to] : halves)
    if (!halves.count({to, from})) return std::nullopt;
  return static_cast<int>(vertices.size()) - static_cast<int>(halves.size() / 2) +
         static_cast<int>(mesh.faces.size());
}

TEST(ClosedModels, AreExportedAsClosedManifolds) {
  struct Known {
    std::string name;
    std::int64_t points;
    int characteristic;
  };
  for (const auto& [name, points, characteristic] :
       {Known{"cube", 6'000, 2}, Known{"pyramid", 6'000, 2}, Known{"plate3", 26'000, -4},
        Known{"step_hole", 31'000, 0}}) {
    const JudgedScan scan = judged_shape(name, points, 0, Order::shuffled, 1, 8);
    const ModelRecord record = modelled(scan.parameters, scan.points).record();
    ASSERT_TRUE(scan.topology(record).closed) << name;
    const auto lifted = io::lift(record);
    for (const bool triangles_only : {false, true}) {
      const auto mesh = io::make_mesh(lifted, record.parameters.resolution, triangles_only);
      EXPECT_EQ(euler_characteristic(mesh), characteristic) << name;
    }
  }
}

}  // namespace
}  // namespace limpet::model
