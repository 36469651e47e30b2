// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limpet/simulation/box_world.hpp>
#include <limpet/simulation/scene.hpp>
#include <limpet/simulation/shapes.hpp>
#include <set>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;

struct Expected {
  std::string name;
  int faces, holes;
  double area;
  bool closed;
  long euler;  ///< of the surface: vertices − edges + triangles
};

class Shape : public ::testing::TestWithParam<Expected> {};

TEST_P(Shape, HasItsFacesHolesAreaAndTopology) {
  const Expected& expected = GetParam();
  const Mesh mesh = make_shape(expected.name);
  double area = 0;
  int holes = 0;
  for (const Face& face : faces_of(mesh)) {
    area += face.area;
    holes += static_cast<int>(face.loops.size()) - 1;
  }
  const EdgeCounts edges = count_edges(mesh);
  EXPECT_EQ(mesh.face_count, expected.faces);
  EXPECT_EQ(holes, expected.holes);
  EXPECT_NEAR(area, expected.area, 1e-6);
  EXPECT_EQ(edges.open == 0, expected.closed);
  EXPECT_EQ(edges.crowded, 0);
  EXPECT_EQ(static_cast<long>(mesh.vertices.size()) - edges.edges + static_cast<long>(mesh.triangles.size()),
            expected.euler);
}

INSTANTIATE_TEST_SUITE_P(
    All, Shape,
    ::testing::Values(Expected{"cube", 6, 0, 6, true, 2}, Expected{"L", 8, 0, 5.5, true, 2},
                      Expected{"step_hole", 12, 2, 9.25, true, 0}, Expected{"plate3", 18, 6, 8, true, -4},
                      Expected{"open_box", 5, 0, 5, false, 1},
                      Expected{"thin_plate:0.02", 6, 0, 2.08, true, 2},
                      Expected{"pyramid", 5, 0, 1 + std::sqrt(5.0), true, 2},
                      Expected{"octahedron", 8, 0, 4 * std::sqrt(3.0), true, 2},
                      Expected{"icosahedron", 20, 0, 5 * std::sqrt(3.0), true, 2},
                      Expected{"box", 6, 0, 5.5, true, 2}, Expected{"step", 10, 0, 9, true, 2},
                      Expected{"notch", 10, 0, 8.5, true, 2}, Expected{"cross", 14, 0, 5.5, true, 2},
                      Expected{"sphere:8", 32, 0, 2.753359769, true, 2},
                      Expected{"drum:8", 15, 1, 4.456708581, true, 2}),
    [](const auto& tested) { return "shape" + std::to_string(tested.index); });

TEST(Shapes, NormalsPointOutOfTheSolid) {
  EXPECT_NEAR(signed_volume(make_shape("cube")), 1, 1e-12);
  EXPECT_NEAR(signed_volume(make_shape("L")), 0.75, 1e-12);
  EXPECT_NEAR(signed_volume(make_shape("step_hole")), 1 + 0.375 - 0.125, 1e-12);
  EXPECT_NEAR(signed_volume(make_shape("plate3")), 0.25 * (3 - 0.75), 1e-12);
  EXPECT_NEAR(signed_volume(make_shape("pyramid")), 1.0 / 3, 1e-12);
  EXPECT_NEAR(signed_volume(make_shape("octahedron")), 4.0 / 3, 1e-12);
  EXPECT_NEAR(signed_volume(make_shape("sphere:128")), std::acos(-1) / 6, 1e-3);
  EXPECT_NEAR(signed_volume(make_shape("drum:1024")), 0.375 + 0.5 * 0.3125 * 0.3125 * std::acos(-1), 1e-4);
  EXPECT_LT(signed_volume(make_shape("room:1")), 0) << "a room is seen from inside";
}

TEST(Shapes, EveryNameWorksAndHasAFeature) {
  EXPECT_EQ(shape_names().size(), 18u);
  for (const std::string& name : shape_names()) {
    EXPECT_TRUE(is_shape(name));
    EXPECT_GT(make_shape(name).face_count, 0) << name;
    EXPECT_GT(feature_size(name), 0) << name;
    EXPECT_FALSE(make_scene(name).viewpoints.empty()) << name;
  }
  EXPECT_EQ(feature_size("thin_plate:0.03"), 0.03);
}

TEST(Shapes, WrongNamesAreRefused) {
  for (const std::string name :
       {"", "ball", "sphere:6", "sphere:10", "drum:1028", "drum:8:8", "cube:1", "thin_plate:0",
        "thin_plate:2", "thin_plate:nan", "thin_plate:x", "city:0", "city:100001", "city:3:4:5", "cells:0",
        "cells:1001", "room:-1", "room:1.5", "city:"}) {
    EXPECT_THROW(make_shape(name), MeshError) << name;
    EXPECT_THROW(feature_size(name), MeshError) << name;
  }
  EXPECT_FALSE(is_shape("ball"));
  EXPECT_THROW(make_scene("ball"), MeshError);
}

/// One closed sheet round as many cells; shearing keeps volumes.
TEST(Cells, AreOneSheetRoundTheirCells) {
  for (const int seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
    SCOPED_TRACE(seed);
    const Mesh mesh = make_shape("cells:12:" + std::to_string(seed));
    EXPECT_NEAR(signed_volume(mesh), 12, 1e-9);
    const EdgeCounts edges = count_edges(mesh);
    EXPECT_EQ(edges.open, 0);
    EXPECT_EQ(edges.crowded, 0);
    EXPECT_GE(mesh.face_count, 8);
  }
  EXPECT_EQ(make_shape("cells:1:3").face_count, 6);
}

TEST(City, GroundIsOneFaceWithAHoleForEachBox) {
  for (const int boxes : {1, 2, 7, 100}) {
    const Mesh mesh = make_shape("city:" + std::to_string(boxes) + ":5");
    const std::vector<Face> faces = faces_of(mesh);
    ASSERT_EQ(mesh.face_count, 5 * boxes + 1);
    int grounds = 0, tops = 0, sides = 0;
    for (const Face& face : faces) {
      ASSERT_GE(face.normal.z(), -1e-12) << "seen from above";
      const bool is_ground = face.normal.z() > 0.5 && face.centroid.z() == 0;
      grounds += is_ground;
      tops += face.normal.z() > 0.5 && !is_ground;
      sides += face.normal.z() < 0.5;
      EXPECT_EQ(face.loops.size(), is_ground ? static_cast<std::size_t>(boxes) + 1 : 1u);
      const Vector3d size = faces[0].loops[0][1] - faces[0].loops[0][0];
      EXPECT_GT(size.norm(), 0);
    }
    EXPECT_EQ(grounds, 1);
    EXPECT_EQ(tops, boxes);
    EXPECT_EQ(sides, 4 * boxes);
  }
}

TEST(City, FootprintsKeepTheirDistance) {
  std::vector<std::pair<Vector3d, Vector3d>> boxes;
  for (const Face& face : faces_of(make_shape("city:60:9"))) {
    if (face.normal.z() < 0.5 || face.loops.size() > 1) continue;  // the tops
    boxes.emplace_back(face.loops[0][0], face.loops[0][0]);
    for (const Vector3d& p : face.loops[0]) {
      boxes.back().first = boxes.back().first.cwiseMin(p);
      boxes.back().second = boxes.back().second.cwiseMax(p);
    }
  }
  ASSERT_EQ(boxes.size(), 60u);
  std::set<double> heights;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vector3d size = boxes[i].second - boxes[i].first;
    EXPECT_GE(size.head<2>().minCoeff(), 0.8);
    EXPECT_LE(size.head<2>().maxCoeff(), 1.2);
    heights.insert(boxes[i].first.z());
    for (std::size_t j = 0; j < i; ++j) {
      const double gap_x =
          std::max(boxes[i].first.x() - boxes[j].second.x(), boxes[j].first.x() - boxes[i].second.x());
      const double gap_y =
          std::max(boxes[i].first.y() - boxes[j].second.y(), boxes[j].first.y() - boxes[i].second.y());
      EXPECT_GE(std::max(gap_x, gap_y), feature_size("city:60:9"));
    }
  }
  EXPECT_GE(*heights.begin(), 0.5);
  EXPECT_LE(*heights.rbegin(), 1.5);
  EXPECT_GT(heights.size(), 20u);
}

TEST(Room, IsAClosedRoomWithAboutTwoHundredFaces) {
  for (int seed = 0; seed < 6; ++seed) {
    const Mesh mesh = make_shape("room:" + std::to_string(seed));
    const EdgeCounts edges = count_edges(mesh);
    EXPECT_EQ(edges.open, 0);
    EXPECT_EQ(edges.crowded, 0);
    EXPECT_NEAR(mesh.face_count, 200, 40) << seed;
    const Bounds bounds = bounds_of(mesh);
    EXPECT_EQ(bounds.low, Vector3d(0, 0, 0));
    EXPECT_EQ(bounds.high, Vector3d(12, 8, 3));
  }
}

TEST(Room, NoEdgeIsShorterThanItsFeature) {
  for (int seed = 0; seed < 6; ++seed) {
    const std::string name = "room:" + std::to_string(seed);
    double shortest = 1e9;
    for (const Face& face : faces_of(make_shape(name)))
      for (const auto& loop : face.loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
          shortest = std::min(shortest, (loop[(i + 1) % loop.size()] - loop[i]).norm());
    EXPECT_GE(shortest, feature_size(name)) << name;
  }
}

TEST(Shapes, SameSeedSameMeshOtherSeedOtherMesh) {
  for (const std::string kind : {"room", "city:20"}) {
    const Mesh a = make_shape(kind + ":3"), b = make_shape(kind + ":3"), c = make_shape(kind + ":4");
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.triangles, b.triangles);
    EXPECT_EQ(a.face_of_triangle, b.face_of_triangle);
    EXPECT_NE(a.vertices, c.vertices);
  }
}

TEST(BoxWorld, LaterBoxesWin) {
  BoxWorld world;
  world.add({0, 0, 0}, {3, 3, 3});
  world.carve({1, 1, 1}, {2, 2, 2});
  EXPECT_EQ(world.surface().face_count, 12) << "a cavity has its own six faces";
  EXPECT_NEAR(signed_volume(world.surface()), 26, 1e-12);
  world.add({1, 1, 1}, {2, 2, 2});
  EXPECT_EQ(world.surface().face_count, 6);
}

}  // namespace
}  // namespace limpet::simulation
