// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limpet/evaluation/region.hpp>

#include "judged_models.hpp"

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;

TEST(Compare, TheTruthHasNoDistanceFromItself) {
  for (const std::string name : {"cube", "step_hole", "octahedron", "city:9"}) {
    const simulation::Mesh truth = simulation::make_shape(name);
    const Comparison result = compare(planar_faces(truth), truth, 5000);
    EXPECT_LT(result.model_to_truth.max, 1e-9) << name;
    EXPECT_LT(result.truth_to_model.max, 1e-9) << name;
    EXPECT_EQ(result.polygons, result.true_faces);
    EXPECT_NEAR(result.model_area, result.true_area, 1e-9);
  }
}

TEST(Compare, AMissingFaceShowsFromTheTruthOnly) {
  const simulation::Mesh truth = simulation::make_shape("cube");
  std::vector<PlanarFace> model = planar_faces(truth);
  model.pop_back();
  const Comparison result = compare(model, truth, 50'000);
  EXPECT_LT(result.model_to_truth.max, 1e-9);
  EXPECT_NEAR(result.truth_to_model.max, 0.5, 0.02) << "from the middle of the missing side";
  EXPECT_NEAR(result.truth_to_model.mean, 1.0 / 6 / 6, 0.002)
      << "a sixth, on average a sixth of the side away";
  EXPECT_LT(result.truth_to_model.median, 1e-9);
  EXPECT_GT(result.truth_to_model.p99, 0.3);
}

TEST(Compare, AShiftShowsBothWays) {
  const simulation::Mesh truth = simulation::make_shape("cube");
  simulation::Mesh shifted = truth;
  for (Vector3d& v : shifted.vertices) v += Vector3d(0.03, 0.04, 0);
  const Comparison result = compare(planar_faces(shifted), truth, 20'000);
  EXPECT_NEAR(result.model_to_truth.max, 0.05, 1e-9);
  EXPECT_NEAR(result.truth_to_model.max, 0.05, 1e-9);
}

TEST(Compare, NothingIsInfinitelyFar) {
  const Comparison result = compare({}, simulation::make_shape("cube"), 100);
  EXPECT_TRUE(std::isinf(result.model_to_truth.max));
  EXPECT_TRUE(std::isinf(result.truth_to_model.mean));
}

TEST(Triangulated, HolesAreLeftOutAndNestingAlternates) {
  const auto square = [](double half) {
    return std::vector<Vector3d>{{-half, -half, 2}, {half, -half, 2}, {half, half, 2}, {-half, half, 2}};
  };
  const PlanarFace target{1, {square(3), square(2), square(1)}, Vector3d::UnitZ(), 0};
  double area = 0;
  for (const Triangle3& t : triangulated(target)) {
    const Vector3d twice = (t[1] - t[0]).cross(t[2] - t[0]);
    EXPECT_GT(twice.z(), 0);
    EXPECT_NEAR(t[0].z(), 2, 1e-12);
    area += twice.norm() / 2;
  }
  EXPECT_NEAR(area, 36 - 16 + 4, 1e-9);
  EXPECT_TRUE(triangulated({1, {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}, Vector3d::UnitZ(), 0}).empty());
  EXPECT_TRUE(triangulated({}).empty());
}

TEST(Triangulated, CrossingCyclesAreCut) {
  const PlanarFace bow{1, {{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}}, Vector3d::UnitZ(), 0};
  double area = 0;
  for (const Triangle3& t : triangulated(bow)) area += (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
  EXPECT_NEAR(area, 2, 1e-9);
}

TEST(SpreadOver, SamplesFollowTheArea) {
  const std::vector<Triangle3> triangles{{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)},
                                         {Vector3d(5, 0, 0), Vector3d(8, 0, 0), Vector3d(5, 3, 0)}};
  const std::vector<Vector3d> points = spread_over(triangles, 1000);
  ASSERT_EQ(points.size(), 1000u);
  Vector3d mean = Vector3d::Zero();
  int small = 0;
  for (const Vector3d& p : points) {
    if (p.x() <= 1)
      ++small;
    else
      mean += p / 900;
  }
  EXPECT_EQ(small, 100);
  EXPECT_LT((mean - Vector3d(6, 1, 0)).norm(), 0.02);
  EXPECT_EQ(points, spread_over(triangles, 1000));
}

TEST(PlanarFaces, AModelIsLiftedAsItsFormatSays) {
  model::ModelRecord record;
  record.grid_step = 0.25;
  model::PolygonSegmentRecord& segment = record.polygon_segments.emplace_back();
  segment.id = 12;
  segment.moments.count = 345;
  segment.chart_origin = Vector3d(10, 20, 30);
  segment.chart_u = Vector3d::UnitY();
  segment.chart_v = Vector3d::UnitZ();
  segment.chart_normal = Vector3d::UnitX();
  segment.height = {2, 0.5, 0};
  segment.cycles = {{{0, 0, 1, 0}, {4, 0, 2, 7}, {4, 8, 3, 0}}};
  const std::vector<PlanarFace> faces = planar_faces(record);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].id, 12u);
  EXPECT_EQ(faces[0].points, 345);
  const std::vector<Vector3d> expected{{10.5, 20, 30}, {11, 21, 30}, {11, 21, 32}};
  EXPECT_EQ(faces[0].cycles, (std::vector<std::vector<Vector3d>>{expected}));
  EXPECT_LT((faces[0].normal - Vector3d(1, -0.5, 0).normalized()).norm(), 1e-15);
  const Closedness closed = closedness(record);
  EXPECT_EQ(closed.edges, 3);
  EXPECT_EQ(closed.open_edges, 2);
  EXPECT_NEAR(closed.open_length, closed.length - 2, 1e-12) << "the shared edge is 2 long";
  EXPECT_FALSE(closed.closed());
  for (auto& vertex : record.polygon_segments[0].cycles[0]) vertex.partner = 9;
  EXPECT_TRUE(closedness(record).closed());
  EXPECT_FALSE(closedness({}).closed()) << "nothing is not closed";
}

TEST(Boundaries, DistanceIsHausdorff) {
  const auto rectangle = [](double x0, double x1) {
    return PlanarFace{1, {{{x0, 0, 0}, {x1, 0, 0}, {x1, 1, 0}, {x0, 1, 0}}}, Vector3d::UnitZ(), 0};
  };
  EXPECT_DOUBLE_EQ(boundary_distance(rectangle(0, 1), rectangle(0, 1), 0.1), 0);
  EXPECT_NEAR(boundary_distance(rectangle(0, 1), rectangle(0, 1.3), 0.1), 0.3, 1e-12);
  EXPECT_NEAR(boundary_distance(rectangle(0, 1.3), rectangle(0, 1), 0.1), 0.3, 1e-12) << "symmetric";
  PlanarFace pierced = rectangle(0, 1);
  pierced.cycles.push_back({{0.4, 0.4, 0}, {0.4, 0.6, 0}, {0.6, 0.6, 0}, {0.6, 0.4, 0}});
  EXPECT_NEAR(boundary_distance(rectangle(0, 1), pierced, 0.01), 0.4, 1e-9);
}

TEST(Boundaries, ModelsAreComparedPolygonByPolygon) {
  const std::vector<PlanarFace> a = planar_faces(simulation::make_shape("L"));
  std::vector<PlanarFace> b(a.rbegin(), a.rend());
  BoundaryComparison same = compare_boundaries(a, b, 0.1);
  EXPECT_EQ(same.pairs.size(), 8u);
  EXPECT_LT(same.max_distance, 1e-12);
  for (const BoundaryPair& pair : same.pairs) EXPECT_EQ(pair.a + pair.b, 7);
  b.erase(b.begin());  // the last of a
  for (Vector3d& p : b[0].cycles[0]) p += Vector3d(0, 0, 0.02);
  const BoundaryComparison other = compare_boundaries(a, b, 0.1);
  EXPECT_EQ(other.only_a, std::vector<int>{7});
  EXPECT_TRUE(other.only_b.empty());
  EXPECT_NEAR(other.max_distance, 0.02, 1e-12);
}

}  // namespace
}  // namespace limpet::evaluation
