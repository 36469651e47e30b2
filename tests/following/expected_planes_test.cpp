// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/frontier/expected_planes_internal.hpp>
#include <numbers>
#include <string>

#include "random_places.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

constexpr double kRange = 4 * kLambda, kLeastCosine = 0.34;

/// A ray from a place to another one, and on to its range.
Ray ray_to(const Vector3d& from, const Vector3d& to) { return {from, (to - from).normalized(), kRange}; }

/// A ray that meets `at` from the front of its plane.
Ray random_ray_to(survey::Random& random, const Vector3d& at, const Vector3d& normal) {
  for (;;) {
    const Vector3d axis = random_direction(random);
    if (-axis.dot(normal) < 1.01 * kLeastCosine) continue;
    return {at - random.uniform(0.1, 0.99) * kRange * axis, axis, kRange};
  }
}

double worth(ExpectedPlanes& planes, const std::vector<Ray>& rays) {
  planes.look_along(rays, kLeastCosine);
  return planes.worth(Vector3d(0, 0, 0));
}
double worth(const Outlook& outlook, const std::vector<Ray>& rays) {
  ExpectedPlanes planes(kLambda, outlook);
  return worth(planes, rays);
}

Outlook with_targets(const std::vector<Target>& targets) {
  Outlook outlook;
  outlook.targets = targets;
  return outlook;
}

/// The right side of a square of 4 λ at z = 0, as a border.
Border right_side(bool goes_on) {
  return {{0, -2 * kLambda, 0}, {0, 2 * kLambda, 0}, {1, 0, 0}, kUp, goes_on};
}

/// Planes in all directions and close to each other, with targets, borders, points and empty places.
Outlook random_outlook(survey::Random& random) {
  Outlook outlook;
  for (std::size_t i = 0, planes = 1 + random.below(3); i < planes; ++i) {
    const Vector3d normal = random_direction(random), origin = random_place(random, kLambda);
    const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
    const auto place = [&] {
      const double x = random.uniform(-3, 3) * kLambda;
      return Vector3d(origin + x * u + random.uniform(-3, 3) * kLambda * v);
    };
    for (std::size_t k = random.below(5); k > 0; --k)
      outlook.targets.push_back({place(), normal, random.below(3) ? 1 : random.uniform(0, 1)});
    for (std::size_t k = random.below(4); k > 0; --k) {
      const Vector3d from = place(), to = random.below(8) ? place() : from;
      outlook.borders.push_back({from, to, (to - from).cross(normal).normalized(), normal, true});
    }
    for (std::size_t k = random.below(3); k > 0; --k) outlook.points.push_back(place());
  }
  return outlook;
}

std::vector<Ray> random_rays(survey::Random& random) {
  std::vector<Ray> rays;
  for (std::size_t k = random.below(27); k > 0; --k) {
    const Vector3d from = random_place(random, 3 * kLambda);
    rays.push_back({from, random_direction(random), random.below(8) ? kRange : -kLambda});
  }
  return rays;
}

TEST(Crossing, LiesOnTheRayAndThePlane) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    const Vector3d normal = random_direction(random), from = random_place(random, 1);
    const Ray ray{from, random_direction(random), random.uniform(-0.2, 1)};
    const double height = random.uniform(-1, 1), cosine = -ray.axis.dot(normal);
    const double above = normal.dot(ray.from) - height;
    const auto meets = crossing(ray, normal, height, kLeastCosine);
    const bool expected = cosine >= kLeastCosine && above >= 0 && above <= ray.range * cosine;
    if (std::abs(above - ray.range * cosine) < 1e-12) continue;
    ASSERT_EQ(meets.has_value(), expected);
    if (!meets) continue;
    ++found;
    EXPECT_NEAR(normal.dot(*meets), height, 1e-12);
    EXPECT_NEAR((*meets - ray.from).dot(ray.axis), (*meets - ray.from).norm(), 1e-12);
  }
  EXPECT_GT(found, 100);
}

TEST(ExpectedPlanes, ARayStraightAtATargetIsWorthItsWeight) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    const Target target{random_place(random, 1), random_direction(random), random.uniform(0, 1)};
    const Ray ray = random_ray_to(random, target.at, target.normal);
    ExpectedPlanes planes(kLambda, with_targets({target}));
    EXPECT_NEAR(worth(planes, {ray}), target.weight, 1e-9);
    EXPECT_NEAR(worth(planes, {ray}), target.weight, 1e-9) << "from one place after another";
    EXPECT_NEAR(worth(planes, {ray, random_ray_to(random, target.at, target.normal)}), target.weight, 1e-9)
        << "a target counts once";
  }
}

TEST(ExpectedPlanes, ARayBesideATargetIsWorthLess) {
  ExpectedPlanes planes(kLambda, with_targets({{{0, 0, 0}, kUp, 1}}));
  double before = 1;
  for (double off = kLambda / 50; off < 0.49 * kLambda; off += kLambda / 50) {
    const double now = worth(planes, {{{off, 0, kLambda}, -kUp, kRange}});
    EXPECT_LT(now, before);
    EXPECT_GT(now, 0);
    before = now;
  }
  EXPECT_EQ(worth(planes, {{{0.51 * kLambda, 0, kLambda}, -kUp, kRange}}), 0);
}

TEST(ExpectedPlanes, ARayThatDoesNotMeetThePlaneIsWorthNothing) {
  Outlook outlook = with_targets({{{0, 0, 0}, kUp, 1}});
  outlook.borders = {right_side(true)};
  ExpectedPlanes planes(kLambda, outlook);
  const Vector3d target = outlook.targets[0].at;
  EXPECT_EQ(worth(planes, {}), 0);
  EXPECT_EQ(worth(planes, {ray_to({kRange / 2, 0, 0.3 * kRange / 2}, target)}), 0) << "grazes";
  EXPECT_GT(worth(planes, {ray_to({kRange / 2, 0, 0.4 * kRange / 2}, target)}), 0.99);
  EXPECT_EQ(worth(planes, {ray_to({0, 0, 1.01 * kRange}, target)}), 0) << "is too short";
  EXPECT_EQ(worth(planes, {ray_to({0, 0, -kLambda}, target)}), 0) << "comes from behind";
  EXPECT_EQ(worth(planes, {{{0, 0, kLambda}, kUp, kRange}}), 0) << "leads away";
  EXPECT_EQ(worth(planes, {{{0, 0, kLambda}, -kUp, -kLambda}}), 0) << "has no range";
}

TEST(ExpectedPlanes, ARayServesOneTarget) {
  // Two planes, one close behind the other; the first ray goes through a target in each.
  const Target front{{0, 0, 0.6 * kLambda}, kUp, 1}, behind{{0, 0, 0}, kUp, 1};
  ExpectedPlanes planes(kLambda, with_targets({front, behind}));
  const Ray straight = ray_to({0, 0, 2 * kLambda}, behind.at),
            slant = ray_to({kRange / 2, 0, kRange / 2}, behind.at);
  EXPECT_NEAR(worth(planes, {straight}), 1, 1e-9);
  EXPECT_NEAR(worth(planes, {straight, slant}), 2, 1e-9);
}

TEST(ExpectedPlanes, ARayOnNewGroundIsWorthWhatTheGroundIs) {
  Outlook outlook;
  outlook.borders = {right_side(true)};
  NewGround ground(kLambda, {0, 0, 0}, kUp);
  ground.add(outlook.borders[0]);
  ExpectedPlanes planes(kLambda, outlook);
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    const Vector3d at(random.uniform(-1, 3) * kLambda, random.uniform(-2, 2) * kLambda, 0);
    const Ray ray = random_ray_to(random, at, kUp);
    EXPECT_NEAR(worth(planes, {ray}), ground.at(at), 1e-9);
    std::vector<Vector3d> places;
    planes.add_new_ground(ray, kLeastCosine, places);
    ASSERT_EQ(places.size(), ground.at(at) > 1e-9 ? 1u : 0u);
    for (const Vector3d& place : places) EXPECT_NEAR((place - at).norm(), 0, 1e-12);
  }
}

TEST(ExpectedPlanes, WhatIsFarFromAPlaneTellsNothingOfIt) {
  Outlook outlook;
  outlook.borders = {right_side(true)};
  const std::vector<Ray> rays{ray_to({1.5 * kLambda, 0, kLambda}, {1.5 * kLambda, 0, 0})};
  for (auto* places : {&outlook.points, &outlook.empty}) {
    *places = {{1.5 * kLambda, 0, 1.1 * kLambda}};
    EXPECT_EQ(worth(outlook, rays), 1);
    *places = {{1.5 * kLambda, 0, 0.9 * kLambda}};
    EXPECT_EQ(worth(outlook, rays), 0);
    places->clear();
  }
}

TEST(ExpectedPlanes, AWorthGoesWithThePlace) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    ExpectedPlanes planes(kLambda, random_outlook(random));
    auto rays = random_rays(random);
    const Vector3d place = random_place(random, kLambda);
    planes.look_along(rays, kLeastCosine);
    const double from_place = planes.worth(place);
    for (Ray& ray : rays) ray.from += place;
    EXPECT_NEAR(worth(planes, rays), from_place, 1e-6);
  }
}

TEST(ExpectedPlanes, AWorthIsAtMostTheNumberOfRaysAndNoEmptyPlaceRaisesIt) {
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    Outlook outlook = random_outlook(random);
    ExpectedPlanes planes(kLambda, outlook);
    const auto rays = random_rays(random);
    const double found = worth(planes, rays);
    ASSERT_GE(found, 0);
    ASSERT_LE(found, static_cast<double>(rays.size()));
    ASSERT_EQ(found, worth(planes, rays)) << "it depends on earlier questions";
    for (std::size_t i = 0; i < 5; ++i) outlook.empty.push_back(random_place(random, 3 * kLambda));
    ASSERT_LE(worth(outlook, rays), found + 1e-12);
    sum += found;
  }
  EXPECT_GT(sum, 1000);
}

}  // namespace
}  // namespace limpet::following::internal
