// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <limpet/simulation/mesh.hpp>
#include <limpet/simulation/shapes.hpp>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;

double enclosed_area(const std::vector<Vector3d>& loop, const Vector3d& normal) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i) sum += loop[i].cross(loop[(i + 1) % loop.size()]);
  return sum.dot(normal) / 2;
}

TEST(Mesh, CoplanarTrianglesMakeOneFaceOnlyThroughSharedEdges) {
  // Two squares in one plane that touch in a corner, and one that shares an edge with the first.
  const Mesh mesh = make_mesh(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {-1, 0, 0}, {-1, 1, 0}},
      {{0, 1, 2, 3}, {2, 4, 5, 6}, {7, 0, 3, 8}});
  EXPECT_EQ(mesh.face_count, 2);
  const std::vector<Face> faces = faces_of(mesh);
  EXPECT_DOUBLE_EQ(faces[0].area, 2);
  EXPECT_DOUBLE_EQ(faces[1].area, 1);
  EXPECT_EQ(faces[0].loops.size(), 1u);
  EXPECT_EQ(faces[0].loops[0].size(), 4u) << "vertices in the middle of a side are left out";
}

TEST(Mesh, TwoSidesOfASheetAreTwoFaces) {
  const Mesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}});
  EXPECT_EQ(mesh.face_count, 2);
  const std::vector<Face> faces = faces_of(mesh);
  EXPECT_DOUBLE_EQ(faces[0].normal.dot(faces[1].normal), -1);
}

TEST(Mesh, ASmallAngleIsAnEdgeAndRoundingIsNot) {
  const auto folded = [](double lift) {
    return make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, lift}, {2, 1, lift}},
                     {{0, 1, 2, 3}, {1, 4, 5, 2}})
        .face_count;
  };
  EXPECT_EQ(folded(0), 1);
  EXPECT_EQ(folded(1e-6), 1);
  EXPECT_EQ(folded(1e-3), 2);
}

TEST(Mesh, EqualPositionsAreWeldedAlsoMinusZero) {
  const Mesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-0.0, 0, -0.0}, {1, 1, 0}, {0, 1, 0}},
                              {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.face_count, 1);
  EXPECT_EQ(count_edges(mesh).open, 4);
}

TEST(Mesh, ConcavePolygonsAreCutInside) {
  // A comb with three teeth: its triangles must cover its area, all facing its way.
  const std::vector<Vector3d> comb{{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {4, 3, 0}, {4, 1, 0}, {3, 1, 0},
                                   {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  const Mesh mesh = make_mesh(comb, {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}});
  double area = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    EXPECT_GT(area_vector(mesh, t).z(), 0);
    area += area_vector(mesh, t).norm() / 2;
  }
  EXPECT_DOUBLE_EQ(area, 11);
  EXPECT_EQ(mesh.face_count, 1);
  EXPECT_EQ(faces_of(mesh)[0].loops[0].size(), 12u);
}

TEST(Mesh, LoopsBoundTheFaceWithTheInteriorOnTheLeft) {
  for (const std::string& name : shape_names()) {
    const Mesh mesh = make_shape(name);
    double triangles = 0, faces = 0;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
      triangles += area_vector(mesh, t).norm() / 2;
    for (const Face& face : faces_of(mesh)) {
      double area = 0;
      for (std::size_t i = 0; i < face.loops.size(); ++i) {
        const double enclosed = enclosed_area(face.loops[i], face.normal);
        EXPECT_EQ(enclosed > 0, i == 0) << name << ": outer loop anticlockwise and first, holes clockwise";
        area += enclosed;
      }
      EXPECT_NEAR(area, face.area, 1e-9) << name;
      faces += face.area;
    }
    EXPECT_NEAR(faces, triangles, 1e-9) << name;
  }
}

TEST(Mesh, AFaceThatTouchesItselfInACornerHasSimpleLoops) {
  // A 3 × 3 board without two squares that meet in a corner: one hole each, or one of both, never a figure
  // eight that walks over the interior.
  std::vector<Vector3d> vertices;
  for (int y = 0; y <= 3; ++y)
    for (int x = 0; x <= 3; ++x) vertices.emplace_back(x, y, 0);
  std::vector<std::vector<int>> quads;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x)
      if (!(x == 1 && y == 1) && !(x == 2 && y == 2))
        quads.push_back({4 * y + x, 4 * y + x + 1, 4 * y + x + 5, 4 * y + x + 4});
  const std::vector<Face> faces = faces_of(make_mesh(vertices, quads));
  ASSERT_EQ(faces.size(), 1u);
  double area = 0;
  for (const auto& loop : faces[0].loops) area += enclosed_area(loop, Vector3d::UnitZ());
  EXPECT_DOUBLE_EQ(area, 7);
}

TEST(Mesh, CentroidLeavesHolesOut) {
  const std::vector<Face> faces = faces_of(make_shape("step_hole"));
  for (const Face& face : faces) {
    if (face.normal.z() > -0.5) continue;  // the underside: 2 × 1 with a hole about (1.375, 0.5)
    EXPECT_NEAR(face.centroid.x(), (2 * 1 - 0.25 * 1.375) / 1.75, 1e-12);
    EXPECT_NEAR(face.centroid.y(), 0.5, 1e-12);
    EXPECT_EQ(face.loops.size(), 2u);
  }
}

TEST(Mesh, KnowsItsNarrowestPlace) {
  EXPECT_DOUBLE_EQ(narrowest_place(make_shape("cube")), 1);
  EXPECT_DOUBLE_EQ(narrowest_place(make_shape("step_hole")), feature_size("step_hole"));
  EXPECT_NEAR(narrowest_place(make_shape("pyramid")), std::sqrt(5.0 / 6), 1e-12);
  // A frame 3 wide around a hole 1 wide that is 0.25 from one side.
  const std::vector<Vector3d> corners{{0, 0, 0}, {3, 0, 0},    {3, 3, 0},    {0, 3, 0},
                                      {1, 1, 0}, {1, 2.75, 0}, {2, 2.75, 0}, {2, 1, 0}};
  const std::vector<std::vector<int>> frame{{0, 1, 7, 4}, {1, 2, 6, 7}, {2, 3, 5, 6}, {3, 0, 4, 5}};
  EXPECT_DOUBLE_EQ(narrowest_place(make_mesh(corners, frame)), 0.25);
}

TEST(Mesh, EdgesAreCounted) {
  const EdgeCounts sheet =
      count_edges(make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}));
  EXPECT_EQ(sheet.edges, 5);
  EXPECT_EQ(sheet.open, 4);
  EXPECT_EQ(sheet.crowded, 0);
  const EdgeCounts book = count_edges(
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  EXPECT_EQ(book.crowded, 1);
}

TEST(Mesh, RefusesWhatIsNoMesh) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}), MeshError);
  EXPECT_THROW(make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, -1}}), MeshError);
  EXPECT_THROW(make_mesh({{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}, {{0, 1, 2}}), MeshError);
  EXPECT_THROW(make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}), MeshError);
  EXPECT_THROW(make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}), MeshError);
}

}  // namespace
}  // namespace limpet::simulation
