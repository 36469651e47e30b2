// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limpet/simulation/initial_faces.hpp>
#include <limpet/simulation/range_image.hpp>
#include <limpet/simulation/shapes.hpp>
#include <limpet/survey/random.hpp>
#include <optional>

#include "../not_finite.hpp"

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

Vector3d random_place(survey::Random& random, double reach) {
  const double x = random.uniform(-reach, reach);
  const double y = random.uniform(-reach, reach);
  const double z = random.uniform(-reach, reach);
  return {x, y, z};
}

Vector3d random_axis(survey::Random& random) { return random_place(random, 1).normalized(); }

/// Places anywhere, or on a sheet, as a scanner finds them.
Points random_points(survey::Random& random, std::size_t count, bool sheet) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(random_place(random, 1));
    if (sheet) points.back().z() = 0.2 * points.back().x() * points.back().y();
  }
  return points;
}

TEST(ImageEpsilon, IsTheLargestOfTheNearestDistances) {
  EXPECT_EQ(image_epsilon({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, 2, 0.5}}), 1);
  survey::Random random(1);
  for (const std::size_t count : {2, 3, 50, 400}) {
    const Points points = random_points(random, count, count == 400);
    double expected = 0;
    for (std::size_t i = 0; i < count; ++i) {
      double nearest = kInfinity;
      for (std::size_t j = 0; j < count; ++j)
        if (j != i) nearest = std::min(nearest, (points[i] - points[j]).norm());
      expected = std::max(expected, nearest);
    }
    EXPECT_DOUBLE_EQ(image_epsilon(points), expected);
  }
}

TEST(ImageEpsilon, PointsThatMakeNoImageAreRefused) {
  const Vector3d there(1, 2, 3);
  EXPECT_THROW(image_epsilon({}), MeshError);
  EXPECT_THROW(image_epsilon({there}), MeshError);
  EXPECT_THROW(image_epsilon({there, there, there}), MeshError);
  EXPECT_THROW(image_epsilon({there, Vector3d(0, kInfinity, 0)}), MeshError);
  EXPECT_THROW(make_range_image_world({there}), MeshError);
  EXPECT_THROW(make_range_image_world({there, -there}, 0.0), MeshError);
  EXPECT_THROW(make_range_image_world({there, -there}, 0.1, Vector3d(0, 0, 0)), MeshError);
}

/// The definition of thesis §4.2, by trying all points.
std::optional<double> first_by_hand(const Points& points, double epsilon, const Vector3d& from,
                                    const Vector3d& axis, double range) {
  std::optional<double> first;
  for (const Vector3d& p : points) {
    const double along = (p - from).dot(axis);
    if (along < 0 || along > range || (p - from - along * axis).norm() > epsilon) continue;
    if (!first || along < *first) first = along;
  }
  return first;
}

TEST(RangeImageWorld, SeesTheFirstPointNearTheAxis) {
  survey::Random random(2);
  int seen = 0, unseen = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Points points = random_points(random, 2 + random.below(600), trial % 2 == 0);
    const std::optional<double> given =
        trial % 3 == 0 ? std::nullopt : std::optional(random.uniform(0.001, 0.3));
    const double epsilon = given ? *given : image_epsilon(points);
    const auto world = make_range_image_world(points, given);
    for (int query = 0; query < 200; ++query) {
      const Vector3d from = random_place(random, query % 2 ? 1.0 : 3.0);
      // Also axes that run along the walls of cells, and towards a point.
      Vector3d axis = random_axis(random);
      if (query % 5 == 0) axis = Vector3d::Unit(query % 3) * (query % 2 ? 1 : -1);
      if (query % 5 == 1) axis = (points[random.below(points.size())] - from).normalized();
      const double range = query % 7 == 0 ? 1000 : random.uniform(0.05, 4);
      const auto expected = first_by_hand(points, epsilon, from, axis, range);
      const auto sighting = world->sight(from, axis, range);
      ASSERT_EQ(sighting.has_value(), expected.has_value()) << "trial " << trial << ", query " << query;
      ++(sighting ? seen : unseen);
      if (!sighting) continue;
      EXPECT_NEAR(sighting->distance, *expected, 1e-12);
      EXPECT_EQ(sighting->incidence_cosine, 1);
      EXPECT_LE(sighting->aside.norm(), epsilon * (1 + 1e-9));
      EXPECT_NEAR(sighting->aside.dot(axis), 0, 1e-12);
      const Vector3d point = from + sighting->distance * axis + sighting->aside;
      const bool is_point = std::any_of(points.begin(), points.end(),
                                        [&](const Vector3d& p) { return (p - point).norm() < 1e-12; });
      EXPECT_TRUE(is_point);
    }
  }
  EXPECT_GT(seen, 1000);
  EXPECT_GT(unseen, 1000);
}

TEST(RangeImageWorld, ABallMeetsItWhereAPointIsInIt) {
  survey::Random random(5);
  int met = 0, missed = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Points points = random_points(random, 2 + random.below(600), trial % 2 == 0);
    const auto world = make_range_image_world(points, random.uniform(0.001, 0.3));
    for (int query = 0; query < 200; ++query) {
      const Vector3d centre = random_place(random, query % 2 ? 1.0 : 3.0);
      const double radius = query % 9 == 0 ? 1e30 : random.uniform(0, query % 2 ? 0.3 : 3.0);
      const bool expected = std::any_of(points.begin(), points.end(),
                                        [&](const Vector3d& p) { return (p - centre).norm() <= radius; });
      ASSERT_EQ(world->meets(centre, radius), expected) << "trial " << trial << ", query " << query;
      ++(expected ? met : missed);
    }
    EXPECT_TRUE(world->meets(points[0], 0));
  }
  EXPECT_GT(met, 1000);
  EXPECT_GT(missed, 1000);
}

TEST(RangeImageWorld, NeitherRangeNorEpsilonIsOverstepped) {
  const auto world = make_range_image_world({{0, 0, 1}, {0, 0, 2}}, 0.25);
  const Vector3d up = Vector3d::UnitZ();
  EXPECT_EQ(world->sight(Vector3d(0, 0, 0), up, 1)->distance, 1);
  EXPECT_FALSE(world->sight(Vector3d(0, 0, 0), up, 0.999));
  EXPECT_EQ(world->sight(Vector3d(0.25, 0, 0), up, 5)->distance, 1);
  EXPECT_FALSE(world->sight(Vector3d(0.2500001, 0, 0), up, 5));
  EXPECT_EQ(world->sight(Vector3d(0, 0, 1), up, 5)->distance, 0);
  EXPECT_EQ(world->sight(Vector3d(0, 0, 1.001), up, 5)->distance, 2 - 1.001);
  EXPECT_FALSE(world->sight(Vector3d(0, 0, 2.001), up, 5));
}

TEST(RangeImageWorld, APointFarFromAllOthersCostsNoMoreThanItsPoints) {
  // A grid as fine as ε over this extent would have 10¹⁵ cells.
  Points points{{0, 0, 0}, {0, 0, 1e-3}, {1e2, 1e2, 1e2}};
  const auto world = make_range_image_world(points, 1e-3);
  EXPECT_NEAR(world->sight(Vector3d(99, 100, 100), Vector3d::UnitX(), 5)->distance, 1, 1e-12);
  EXPECT_FALSE(world->sight(Vector3d(50, 50, 50), Vector3d::UnitX(), 1e6));
}

TEST(RangeImageWorld, WithAFrontPointsMetFromBehindHideAndAreNotSeen) {
  const Mesh cube = make_shape("cube");
  const Vector3d direction(-1, -2, -3);  // three faces are seen
  const RangeImage image = take_range_image(cube, direction, 0.02);
  const auto plain = make_range_image_world(image.points);
  const auto with_front = make_range_image_world(image.points, std::nullopt, direction);
  const std::vector<Face> faces = faces_of(cube);
  const Vector3d middle = bounds_of(cube).centre();
  int fronts = 0;
  for (const Face& face : faces) {
    if (face.normal.dot(direction) > 0) continue;
    ++fronts;
    const Vector3d outside = face.centroid + 0.1 * face.normal;
    const auto sighting = with_front->sight(outside, -face.normal, 0.2);
    ASSERT_TRUE(sighting);
    EXPECT_NEAR(sighting->distance, 0.1, 1e-9);
    EXPECT_NEAR(sighting->incidence_cosine, 1, 1e-6);
    EXPECT_TRUE(plain->sight(middle, face.normal, 1));
    EXPECT_FALSE(with_front->sight(middle, face.normal, 1));
    // From below, through the object: the first point is the back of this face.
    EXPECT_FALSE(with_front->sight(middle - 2 * face.normal, face.normal, 5));
    const Vector3d slanted = (-face.normal + 0.75 * face.normal.unitOrthogonal()).normalized();
    const auto at_angle = with_front->sight(outside, slanted, 0.4);
    ASSERT_TRUE(at_angle);
    EXPECT_NEAR(at_angle->incidence_cosine, 0.8, 1e-6);
  }
  EXPECT_EQ(fronts, 3);
}

TEST(TakeRangeImage, ShowsWhatFacesTheScannerAtItsDensity) {
  const Mesh cube = make_shape("cube");
  const Vector3d direction = Vector3d(-1, -2, -3).normalized();
  const double pitch = 0.01;
  const RangeImage image = take_range_image(cube, direction, pitch);
  ASSERT_EQ(image.points.size(), image.faces.size());
  const std::vector<Face> faces = faces_of(cube);
  std::vector<double> count(faces.size());
  for (std::size_t i = 0; i < image.points.size(); ++i) {
    const Face& face = faces[static_cast<std::size_t>(image.faces[i])];
    ++count[static_cast<std::size_t>(image.faces[i])];
    ASSERT_NEAR((image.points[i] - face.centroid).dot(face.normal), 0, 1e-12);
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const double expected = std::max(0.0, -faces[f].normal.dot(direction)) * faces[f].area / (pitch * pitch);
    EXPECT_NEAR(count[f], expected, 4 / pitch * 0.5) << "face " << f;
    EXPECT_EQ(count[f] == 0, expected == 0) << "face " << f;
  }
  const double epsilon = image_epsilon(image.points);
  EXPECT_GT(epsilon, 0.999 * pitch);
  EXPECT_LT(epsilon, 2 * pitch);
}

TEST(TakeRangeImage, OfTheConcaveKeepsOneReadingARay) {
  const Mesh mesh = make_shape("step_hole");
  const RangeImage image = take_range_image(mesh, Vector3d(1, 0.4, -0.7), 0.02);
  const Vector3d axis = Vector3d(1, 0.4, -0.7).normalized();
  for (std::size_t i = 1; i < image.points.size(); ++i) {
    const Vector3d way = image.points[i] - image.points[i - 1];
    EXPECT_GT((way - way.dot(axis) * axis).norm(), 0.019);
  }
}

TEST(TakeRangeImage, BadWishesAreRefused) {
  const Mesh cube = make_shape("cube");
  EXPECT_THROW(take_range_image(cube, Vector3d(0, 0, 0), 0.1), MeshError);
  EXPECT_THROW(take_range_image(cube, Vector3d(0, 0, 1), 0), MeshError);
  EXPECT_THROW(take_range_image(cube, Vector3d(0, 0, 1), 1e-6), MeshError);
  EXPECT_THROW(take_range_image(make_shape("open_box"), Vector3d(0, 0, 1), 10), MeshError);
}

TEST(OccludedFaces, AreThoseThatTheImageDoesNotShow) {
  const double pitch = 0.02;
  for (const std::string name : {"cube", "L", "step_hole", "octahedron"}) {
    const Mesh mesh = make_shape(name);
    const Vector3d direction(-1, -2, -3);
    const RangeImage image = take_range_image(mesh, direction, pitch);
    const std::vector<int> occluded = occluded_faces(mesh, image, pitch);
    const std::vector<Face> faces = faces_of(mesh);
    for (int f = 0; f < mesh.face_count; ++f) {
      const bool is = std::count(occluded.begin(), occluded.end(), f) > 0;
      const auto points = static_cast<double>(std::count(image.faces.begin(), image.faces.end(), f));
      const Face& face = faces[static_cast<std::size_t>(f)];
      EXPECT_TRUE(is || face.normal.dot(direction) < 0) << name << ", face " << f;
      EXPECT_FALSE(is && points * pitch * pitch > 0.06 * face.area) << name << ", face " << f;
    }
    EXPECT_EQ(initial_faces(mesh, occluded).size(), occluded.size());
  }
  const Mesh cube = make_shape("cube");
  EXPECT_EQ(occluded_faces(cube, take_range_image(cube, Vector3d(0, 0, -1), pitch), pitch).size(), 5u);
}

TEST(InitialFaces, SomeOfAMeshAreTheFacesOfTheseNumbers) {
  const Mesh mesh = make_shape("step_hole");
  const auto all = initial_faces(mesh);
  ASSERT_EQ(static_cast<int>(all.size()), mesh.face_count);
  const auto some = initial_faces(mesh, {7, 2});
  ASSERT_EQ(some.size(), 2u);
  EXPECT_EQ(some[0].cycles, all[7].cycles);
  EXPECT_EQ(some[1].cycles, all[2].cycles);
  EXPECT_THROW(initial_faces(mesh, {mesh.face_count}), MeshError);
  EXPECT_THROW(initial_faces(mesh, {-1}), MeshError);
}

}  // namespace
}  // namespace limpet::simulation
