// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <limpet/simulation/scan.hpp>
#include <limpet/simulation/scene.hpp>
#include <limpet/simulation/shapes.hpp>
#include <stdexcept>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;
using Order = ScanOptions::Order;

constexpr Order kOrders[] = {Order::raster, Order::shuffled, Order::sampled};

struct Exposure {
  Scene scene;
  ScanOptions options;
  std::vector<LabelledPoint> points() const { return scan(scene.mesh, options); }
};

Exposure run_of(const std::string& name, Order order, long points) {
  Exposure run{make_scene(name), {}};
  run.options.points = points;
  run.options.order = order;
  run.options.viewpoints = run.scene.viewpoints;
  return run;
}

auto as_tuple(const LabelledPoint& p) {
  return std::tuple(p.face, p.point.position.x(), p.point.position.y(), p.point.position.z(),
                    p.point.axis.x(), p.point.axis.y(), p.point.axis.z());
}

/// Distance from the face's boundary if the point is in the face's plane but outside it; 0 inside.
double outside(const Vector3d& p, const Face& face, const Mesh& mesh) {
  double least = std::numeric_limits<double>::max();
  for (const int t : face.triangles) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vector3d corners[3] = {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    double out = 0;
    for (int k = 0; k < 3; ++k) {
      const Vector3d side = (corners[(k + 1) % 3] - corners[k]).normalized();
      out = std::max(out, -face.normal.cross(side).dot(p - corners[k]));
    }
    least = std::min(least, out);
  }
  return least;
}

TEST(Scan, HitsLieOnTheirFaceAndAxesPointIntoIt) {
  for (const std::string& name : shape_names()) {
    for (const Order order : kOrders) {
      const Exposure run = run_of(name, order, 1500);
      const std::vector<Face> faces = faces_of(run.scene.mesh);
      for (const LabelledPoint& p : run.points()) {
        ASSERT_GE(p.face, 0);
        const Face& face = faces.at(p.face);
        ASSERT_NEAR((p.point.position - face.centroid).dot(face.normal), 0, 1e-9) << name;
        ASSERT_LT(p.point.axis.dot(face.normal), 0) << name;
        ASSERT_NEAR(p.point.axis.norm(), 1, 1e-12);
        ASSERT_LE(outside(p.point.position, face, run.scene.mesh), 1e-9) << name;
      }
    }
  }
}

TEST(Scan, GivesAboutAsManyPointsAsAskedFor) {
  for (const std::string& name : shape_names()) {
    for (const long points : {1000L, 20'000L}) {
      long raster = 0, sampled = 0;
      const Exposure run = run_of(name, Order::raster, points);
      scan(run.scene.mesh, run.options, [&](const LabelledPoint&) { ++raster; });
      const Exposure other = run_of(name, Order::sampled, points);
      scan(other.scene.mesh, other.options, [&](const LabelledPoint&) { ++sampled; });
      EXPECT_NEAR(static_cast<double>(raster), static_cast<double>(points),
                  0.05 * static_cast<double>(points))
          << name;
      EXPECT_EQ(sampled, points) << name;
    }
  }
  const Exposure many = run_of("cube", Order::raster, 300'000);
  EXPECT_NEAR(static_cast<double>(many.points().size()), 300'000, 15'000);
}

TEST(Scan, EveryFaceIsSeen) {
  for (const std::string name : {"cube", "L", "step_hole", "plate3", "open_box", "thin_plate:0.1", "pyramid",
                                 "octahedron", "room:1", "room:2", "city:40:2"}) {
    const Exposure run = run_of(name, Order::raster, 30'000);
    std::vector<int> seen(run.scene.mesh.face_count, 0);
    for (const LabelledPoint& p : run.points()) ++seen[p.face];
    EXPECT_GE(*std::min_element(seen.begin(), seen.end()), 2) << name;
  }
}

TEST(Scan, AnOpenSheetIsNotReadFromItsBack) {
  Exposure run = run_of("open_box", Order::raster, 2000);
  run.options.viewpoints = {Vector3d(0.55, 0.45, 6)};  // looks through the missing lid
  EXPECT_THROW(run.points(), MeshError);
}

TEST(Scan, WhatIsHiddenIsNotRead) {
  Exposure run = run_of("cube", Order::raster, 2000);
  run.options.viewpoints = {Vector3d(5, 0.4, 0.6)};
  for (const LabelledPoint& p : run.points()) EXPECT_NEAR(p.point.position.x(), 1, 1e-12);
}

TEST(Scan, RasterRowsGoBackAndForth) {
  Exposure run = run_of("cube", Order::raster, 5000);
  run.options.viewpoints = {Vector3d(5, 0.5, 0.5)};
  const std::vector<LabelledPoint> points = run.points();
  int turns = 0, forth = 0, back = 0;
  double longest_step = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vector3d step = points[i].point.position - points[i - 1].point.position;
    longest_step = std::max(longest_step, step.norm());
    forth += step.y() > 1e-6;
    back += step.y() < -1e-6;
    turns += std::abs(step.y()) < 1e-6;
  }
  EXPECT_LT(longest_step, 0.05) << "neighbours in time are neighbours on the surface";
  EXPECT_NEAR(forth, back, 100);
  EXPECT_NEAR(turns, 70, 5);
}

TEST(Scan, NoiseRunsAlongTheAxisWithItsStandardDeviation) {
  for (const Order order : kOrders) {
    Exposure run = run_of("cube", order, 20'000);
    const std::vector<LabelledPoint> clean = run.points();
    run.options.noise = 0.01;
    const std::vector<LabelledPoint> noisy = run.points();
    ASSERT_EQ(clean.size(), noisy.size());
    double sum = 0, square = 0;
    for (std::size_t i = 0; i < clean.size(); ++i) {
      ASSERT_EQ(clean[i].face, noisy[i].face);
      ASSERT_EQ(clean[i].point.axis, noisy[i].point.axis);
      const Vector3d error = noisy[i].point.position - clean[i].point.position;
      const double along = error.dot(clean[i].point.axis);
      ASSERT_NEAR(error.norm(), std::abs(along), 1e-12);
      sum += along;
      square += along * along;
    }
    const double n = static_cast<double>(clean.size());
    EXPECT_NEAR(sum / n, 0, 0.0003);
    EXPECT_NEAR(std::sqrt(square / n), 0.01, 0.0002);
  }
}

TEST(Scan, NoiseMayGrowWithRange) {
  Exposure run = run_of("cube", Order::raster, 20'000);
  const Vector3d viewpoint(11, 0.5, 0.5);
  run.options.viewpoints = {viewpoint};
  run.options.noise = 0.01;
  run.options.noise_per_range = 0.001;
  double square = 0;
  long n = 0;
  for (const LabelledPoint& p : run.points()) {
    square += std::pow(p.point.position.x() - 1, 2);
    ++n;
  }
  EXPECT_NEAR(std::sqrt(square / static_cast<double>(n)), 0.01 + 0.001 * 10, 0.0005);
}

TEST(Scan, OutliersAreAFractionAnywhereInTheGrownBox) {
  for (const Order order : kOrders) {
    Exposure run = run_of("L", order, 20'000);
    const std::vector<LabelledPoint> clean = run.points();
    run.options.outliers = 0.1;
    const std::vector<LabelledPoint> points = run.points();
    ASSERT_EQ(clean.size(), points.size());
    long outliers = 0, beyond = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(points[i].point.axis, clean[i].point.axis) << "an outlier keeps its axis";
      if (points[i].face >= 0) continue;
      ++outliers;
      const Vector3d& p = points[i].point.position;
      EXPECT_GE(p.minCoeff(), -0.1);
      EXPECT_LE(p.maxCoeff(), 1.1);
      beyond += p.minCoeff() < 0 || p.maxCoeff() > 1;
    }
    EXPECT_NEAR(static_cast<double>(outliers) / static_cast<double>(points.size()), 0.1, 0.01);
    EXPECT_NEAR(static_cast<double>(beyond) / static_cast<double>(outliers), 1 - 1 / 1.728, 0.04);
  }
}

TEST(Scan, OutliersOfAFlatMeshLeaveItsPlane) {
  const Mesh sheet = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  ScanOptions options;
  options.points = 100;
  options.order = Order::sampled;
  options.outliers = 1;
  for (const LabelledPoint& p : scan(sheet, options)) {
    EXPECT_EQ(p.face, -1);
    EXPECT_NE(p.point.position.z(), 0);
    EXPECT_LE(std::abs(p.point.position.z()), 0.1 * std::sqrt(2.0));
  }
}

TEST(Scan, SampledPointsAreSpreadByArea) {
  const Exposure run = run_of("step_hole", Order::sampled, 100'000);
  const std::vector<Face> faces = faces_of(run.scene.mesh);
  std::vector<double> points(faces.size(), 0);
  std::vector<Vector3d> sum(faces.size(), Vector3d::Zero());
  double steepest = 1;
  for (const LabelledPoint& p : run.points()) {
    ++points[p.face];
    sum[p.face] += p.point.position;
    steepest = std::min(steepest, -p.point.axis.dot(faces[p.face].normal));
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    EXPECT_NEAR(points[f] / 100'000, faces[f].area / 9.25, 0.005);
    EXPECT_LT((sum[f] / points[f] - faces[f].centroid).norm(), 0.03);
  }
  EXPECT_NEAR(steepest, std::cos(std::acos(-1.0) / 6), 1e-4) << "axes tilt by up to 30°";
  EXPECT_GE(steepest, std::cos(std::acos(-1.0) / 6) - 1e-12);
}

TEST(Scan, SameSeedSameBytesOtherSeedOtherNoise) {
  for (const Order order : kOrders) {
    Exposure run = run_of("L", order, 3000);
    run.options.noise = 0.01;
    run.options.outliers = 0.05;
    run.options.seed = 42;
    const std::vector<LabelledPoint> a = run.points(), b = run.points();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(as_tuple(a[i]), as_tuple(b[i]));
    run.options.seed = 43;
    const std::vector<LabelledPoint> c = run.points();
    std::size_t equal = 0;
    for (std::size_t i = 0; i < std::min(a.size(), c.size()); ++i) equal += as_tuple(a[i]) == as_tuple(c[i]);
    EXPECT_LT(equal, 5u);
  }
}

TEST(Scan, AShuffledScanIsAPermutationOfTheRasterScan) {
  Exposure run = run_of("L", Order::raster, 3000);
  run.options.noise = 0.01;
  run.options.outliers = 0.05;
  std::vector<LabelledPoint> raster = run.points();
  run.options.order = Order::shuffled;
  std::vector<LabelledPoint> shuffled = run.points();
  ASSERT_EQ(raster.size(), shuffled.size());
  std::size_t in_place = 0;
  for (std::size_t i = 0; i < raster.size(); ++i) in_place += as_tuple(raster[i]) == as_tuple(shuffled[i]);
  EXPECT_LT(in_place, 20u);
  const auto less = [](const LabelledPoint& a, const LabelledPoint& b) { return as_tuple(a) < as_tuple(b); };
  std::sort(raster.begin(), raster.end(), less);
  std::sort(shuffled.begin(), shuffled.end(), less);
  for (std::size_t i = 0; i < raster.size(); ++i) ASSERT_EQ(as_tuple(raster[i]), as_tuple(shuffled[i]));
}

TEST(Scan, RefusesSenselessOptions) {
  const Mesh cube = make_shape("cube");
  const auto refused = [&cube](auto change) {
    ScanOptions options;
    options.points = 100;
    change(options);
    EXPECT_THROW(scan(cube, options), std::invalid_argument);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](ScanOptions& o) { o.points = 0; });
  refused([](ScanOptions& o) { o.noise = -1; });
  refused([&](ScanOptions& o) { o.noise = nan; });
  refused([](ScanOptions& o) { o.noise_per_range = -1; });
  refused([](ScanOptions& o) { o.outliers = 1.5; });
  refused([&](ScanOptions& o) { o.outliers = nan; });
}

TEST(Scan, WithoutViewpointsTheMeshIsSeenFromAllAround) {
  ScanOptions options;
  options.points = 5000;
  std::vector<int> seen(6, 0);
  for (const LabelledPoint& p : scan(make_shape("cube"), options)) ++seen.at(p.face);
  for (const int count : seen) EXPECT_NEAR(count, 5000.0 / 6, 300);
}

}  // namespace
}  // namespace limpet::simulation
