// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "judged_models.hpp"

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using Lines = std::vector<std::string>;

const Vector3d kUp = Vector3d::UnitZ();

void move(PlanarFace& face, const Vector3d& by) {
  for (auto& cycle : face.cycles)
    for (Vector3d& p : cycle) p += by;
}

std::string face_name(int face) { return "face " + std::to_string(face) + ": "; }

TEST(JudgeFaces, TheTruthIsFaultless) {
  for (const std::string name :
       {"cube", "L", "step_hole", "plate3", "open_box", "pyramid", "octahedron", "city:9"}) {
    const Judged judged(name, 40'000);
    const FacesReport report = judged.report();
    EXPECT_EQ(judged.faults(), Lines{}) << name;
    EXPECT_EQ(report.counted, judged.truth.face_count) << name;
    EXPECT_EQ(report.represented, judged.truth.face_count) << name;
    EXPECT_EQ(report.extra + report.split + report.merged + report.missed + report.wrong_holes, 0) << name;
    EXPECT_LT(report.max_angle, 1e-9) << name;
    EXPECT_LT(report.max_overshoot, 1e-9) << name;
    EXPECT_LT(report.max_shortfall, 1e-9) << name;
    EXPECT_LT(report.max_unreached, 1e-9) << name;
    for (int f = 0; f < judged.truth.face_count; ++f)
      EXPECT_EQ(report.faces[f].polygons, std::vector<int>{f});
  }
}

TEST(JudgeFaces, NoiseTurnsTheFittedPlaneByAboutItsStandardError) {
  const Judged judged("cube", 20'000, 0.01);
  const FacesReport report = judged.report();
  EXPECT_EQ(judged.faults(), Lines{});
  // σ/√(m·u₂) with m ≈ 3333 and u₂ = 1/12; σ is along axes tilted by up to 30°.
  for (const PolygonJudgement& polygon : report.polygons) {
    EXPECT_NEAR(polygon.standard_error, 0.01 / std::sqrt(20'000.0 / 6 / 12), 5e-5);
    EXPECT_GT(polygon.angle, 0);
    EXPECT_LT(polygon.angle, 4 * polygon.standard_error);
    EXPECT_LT(polygon.true_angle, 1e-12);
    EXPECT_LT(std::abs(polygon.offset), 4 * 0.01 / std::sqrt(20'000.0 / 6));
  }
  EXPECT_GT(report.max_angle_excess, 0.2);
}

TEST(JudgeFaces, NoiseIsTakenFromThePointsIfNotGiven) {
  Judged judged("cube", 20'000, 0.01);
  const double given = judged.report().polygons[0].standard_error;
  judged.options.noise = 0;
  EXPECT_NEAR(judged.report().polygons[0].standard_error, given, 0.2 * given);
}

TEST(JudgeFaces, AMissingPolygonIsAMissedFace) {
  Judged judged("L");
  judged.model.erase(judged.model.begin() + 3);
  EXPECT_EQ(judged.faults(), Lines{face_name(3) + "missed"});
  EXPECT_EQ(judged.report().missed, 1);
  EXPECT_EQ(judged.report().represented, 7);
}

TEST(JudgeFaces, ASplitPolygonIsOneTooMany) {
  Judged judged("cube");
  const int top = judged.facing(kUp);
  judged.model[top].cycles = {{{0, 0, 1}, {0.7, 0, 1}, {0.7, 1, 1}, {0, 1, 1}}};
  judged.model.push_back({77, {{{0.7, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0.7, 1, 1}}}, kUp, 0});
  EXPECT_EQ(judged.faults(),
            (Lines{face_name(top) + "split into 2",
                   "polygon 77: second on " + face_name(top).substr(0, face_name(top).size() - 2)}));
  const FacesReport report = judged.report();
  EXPECT_EQ(report.split, 1);
  EXPECT_EQ(report.represented, 6) << "a split face is represented all the same";
  EXPECT_EQ(report.extra, 1);
  EXPECT_EQ(report.unmatched, 0);
  EXPECT_EQ(report.faces[top].polygons.front(), top) << "the largest comes first";
  EXPECT_NEAR(report.polygons[top].shortfall, 0.3, 1e-9);
  EXPECT_NEAR(report.polygons[top].unreached, 0.3, 0.01);
}

TEST(JudgeFaces, APolygonOverTwoFacesMergesThem) {
  // The tops of two boxes of equal height, a tenth apart, under one polygon.
  const auto box = [](double x0, double x1, std::vector<Vector3d>& vertices,
                      std::vector<std::vector<int>>& quads) {
    const int b = static_cast<int>(vertices.size());
    vertices.insert(vertices.end(), {{x0, 0, 1}, {x1, 0, 1}, {x1, 1, 1}, {x0, 1, 1}});
    quads.push_back({b, b + 1, b + 2, b + 3});
  };
  std::vector<Vector3d> vertices;
  std::vector<std::vector<int>> quads;
  box(0, 1, vertices, quads);
  box(1.1, 1.9, vertices, quads);
  Judged judged("cube");
  judged.truth = simulation::make_mesh(vertices, quads);
  simulation::ScanOptions options;
  options.points = 10'000;
  options.order = simulation::ScanOptions::Order::sampled;
  judged.points = simulation::scan(judged.truth, options);
  judged.model = {{5, {{{0, 0, 1}, {1.9, 0, 1}, {1.9, 1, 1}, {0, 1, 1}}}, kUp, 0}};
  EXPECT_EQ(judged.faults(), Lines{"face 1: merged into another face's polygon"});
  EXPECT_EQ(judged.report().merged, 1);
  EXPECT_NEAR(judged.report().max_overshoot, 0.9, 1e-9);
}

TEST(JudgeFaces, AShiftedPolygonOvershootsAndFallsShort) {
  Judged judged("cube");
  const int top = judged.facing(kUp);
  move(judged.model[top], {0.05, 0, 0});
  const FacesReport report = judged.report();
  EXPECT_EQ(judged.faults(), Lines{});
  EXPECT_NEAR(report.polygons[top].overshoot, 0.05, 1e-9);
  EXPECT_NEAR(report.polygons[top].shortfall, 0.05, 1e-9);
  EXPECT_NEAR(report.max_overshoot, 0.05, 1e-9);
  move(judged.model[top], {-0.05, 0, 0.02});
  EXPECT_NEAR(judged.report().polygons[top].offset, 0.02, 1e-9);
  EXPECT_LT(judged.report().polygons[top].overshoot, 1e-9) << "measured in the plane";
}

TEST(JudgeFaces, APolygonFarOffOrTurnedAwayIsOnNoFace) {
  Judged judged("cube");
  const int top = judged.facing(kUp);
  judged.model[top].id = 9;
  const Lines expected{face_name(top) + "missed", "polygon 9: on no face"};
  Judged high = judged, turned = judged, flipped = judged;
  move(high.model[top], 0.3 * kUp);
  EXPECT_EQ(high.faults(), expected);
  turned.model[top].normal = Vector3d(0.5, 0, 1).normalized();
  EXPECT_EQ(turned.faults(), expected);
  flipped.model[top].normal = -kUp;
  EXPECT_EQ(flipped.faults(), expected);
  EXPECT_EQ(flipped.report().unmatched, 1);
}

TEST(JudgeFaces, ATiltedNormalShowsInItsAngle) {
  Judged judged("cube");
  const int top = judged.facing(kUp);
  judged.model[top].normal = Vector3d(0.1, 0, 1).normalized();
  const FacesReport report = judged.report();
  EXPECT_NEAR(report.polygons[top].angle, std::atan(0.1), 1e-6);
  EXPECT_NEAR(report.max_angle, std::atan(0.1), 1e-6);
}

TEST(JudgeFaces, HolesAreCounted) {
  Judged judged("step_hole");
  const int under = judged.facing(-kUp);
  ASSERT_EQ(judged.model[under].cycles.size(), 2u);
  judged.model[under].cycles.pop_back();
  EXPECT_EQ(judged.faults(), Lines{face_name(under) + "0 holes for 1"});
  EXPECT_NEAR(judged.report().polygons[under].overshoot, 0, 1e-9) << "its boundary is right";
  Judged pierced("cube");
  const int top = pierced.facing(kUp);
  pierced.model[top].cycles.push_back({{0.4, 0.4, 1}, {0.4, 0.6, 1}, {0.6, 0.6, 1}, {0.6, 0.4, 1}});
  EXPECT_EQ(pierced.faults(), Lines{face_name(top) + "1 holes for 0"});
  EXPECT_NEAR(pierced.report().polygons[top].unreached, 0.1, 0.01) << "points in the hole are not reached";
}

TEST(JudgeFaces, FacesNearerToEachOtherThanTheResolutionKeepTheirPolygons) {
  Judged judged("plate3");
  judged.options.resolution = 0.6;  // wider than the holes
  EXPECT_EQ(judged.faults(), Lines{});
  EXPECT_EQ(judged.report().counted, 18);
}

TEST(JudgeFaces, OnlyWellScannedFacesAreAskedFor) {
  Judged judged("cube", 4000);
  const int top = judged.facing(kUp);
  std::erase_if(judged.points, [top](const simulation::LabelledPoint& p) { return p.face == top; });
  judged.model.erase(judged.model.begin() + top);
  FacesReport report = judged.report();
  EXPECT_EQ(report.counted, 5);
  EXPECT_FALSE(report.faces[top].counts);
  EXPECT_EQ(judged.faults(), Lines{});
  EXPECT_NEAR(report.faces[(top + 1) % 6].density, 4000.0 / 6 * 0.01, 1);
  judged.options.resolution = 0.05;  // now 1.7 points per λ²
  EXPECT_EQ(judged.report().counted, 0);
}

TEST(JudgeFaces, OutliersAreCountedApart) {
  Judged judged("cube");
  judged.points.push_back({{Vector3d(9, 9, 9), kUp}, -1});
  EXPECT_EQ(judged.report().outliers, 1);
  EXPECT_EQ(judged.faults(), Lines{});
}

TEST(JudgeFaces, FarFromTheOriginNothingIsLost) {
  Judged judged("cube", 20'000, 0.001);
  const double near = judged.report().polygons[0].angle;
  const Vector3d far(1e6, -2e6, 3e6);
  for (Vector3d& v : judged.truth.vertices) v += far;
  for (simulation::LabelledPoint& p : judged.points) p.point.position += far;
  judged.model = planar_faces(judged.truth);
  EXPECT_NEAR(judged.report().polygons[0].angle, near, 1e-6);
  EXPECT_EQ(judged.faults(), Lines{});
}

TEST(JudgeFaces, RefusesWrongInput) {
  Judged judged("cube", 100);
  judged.points[0].face = 6;
  EXPECT_THROW(judged.report(), std::invalid_argument);
  judged.points.clear();
  judged.options.resolution = 0;
  EXPECT_THROW(judged.report(), std::invalid_argument);
}

TEST(JudgeFaces, AnEmptyModelMissesEverything) {
  Judged judged("cube");
  judged.model.clear();
  EXPECT_EQ(judged.report().missed, 6);
  judged.model = {{1, {}, kUp, 0}, {2, {{{0, 0, 1}, {1, 0, 1}}}, kUp, 0}};
  EXPECT_EQ(judged.report().missed, 6);
  EXPECT_EQ(judged.report().unmatched, 2) << "polygons without area are on no face";
}

}  // namespace
}  // namespace limpet::evaluation
