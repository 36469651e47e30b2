// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <limpet/following/frontier/new_ground_internal.hpp>
#include <limpet/following/nearest_on_internal.hpp>
#include <numbers>
#include <string>

#include "random_places.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kFar = 3.8 * kLambda;

/// What is known of a plane.
struct Ground {
  Vector3d origin{0, 0, 0}, normal = kUp;
  std::vector<Border> borders;
  std::vector<Vector3d> felt, empty;

  NewGround made() const {
    NewGround ground(kLambda, origin, normal);
    for (const Border& border : borders) ground.add(border);
    for (const Vector3d& p : felt) ground.add_felt(p);
    for (const Vector3d& p : empty) ground.add_empty(p);
    return ground;
  }
  Ground moved(const Isometry3d& by) const {
    Ground result{by * origin, by.linear() * normal, {}, {}, {}};
    for (const Border& b : borders)
      result.borders.push_back(
          {by * b.from, by * b.to, by.linear() * b.outward, by.linear() * b.normal, b.goes_on});
    for (const Vector3d& p : felt) result.felt.push_back(by * p);
    for (const Vector3d& p : empty) result.empty.push_back(by * p);
    return result;
  }
};

double ramp(double distance) { return std::clamp((distance / kLambda - 0.45) / 0.45, 0.0, 1.0); }

/// The x axis from −length/2 to length/2; what is felt lies below it.
Border x_axis(double length, bool goes_on = true) {
  return {{-length / 2, 0, 0}, {length / 2, 0, 0}, {0, 1, 0}, kUp, goes_on};
}

/// The definition in the header, by trying all, in space.
double by_definition(const Ground& ground, const Vector3d& place) {
  const Border* faced = nullptr;
  double least = std::numeric_limits<double>::infinity(), most_faced = 0;
  for (const Border& border : ground.borders)
    if (border.from != border.to)
      least = std::min(least, (nearest_on(border.from, border.to, place) - place).norm());
  for (const Border& border : ground.borders) {
    if (border.from == border.to) continue;
    const double distance = (nearest_on(border.from, border.to, place) - place).norm();
    const double facing = std::abs(border.outward.dot(place - border.from));
    if (distance > least + 1e-9 * kLambda || (faced && facing <= most_faced)) continue;
    faced = &border, most_faced = facing;
  }
  if (!faced || least > kFar || !faced->goes_on) return 0;
  if (faced->outward.dot(place - faced->from) <= 0) return 0;
  for (const Vector3d& p : ground.felt) least = std::min(least, (p - place).norm());
  for (const Vector3d& p : ground.empty)
    if ((p - place).norm() < std::numbers::sqrt2 * least) return 0;
  return ramp(least);
}

Vector3d random_flat(survey::Random& random, double size) {
  const double x = random.uniform(-size, size);
  return {x, random.uniform(-size, size), 0};
}

/// The sides of a polygon, anticlockwise, each from any end to the other.
std::vector<Border> sides(survey::Random& random, const std::vector<Vector3d>& corners, bool goes_on) {
  std::vector<Border> borders;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3d &from = corners[i], &to = corners[(i + 1) % corners.size()];
    borders.push_back({from, to, (to - from).cross(kUp).normalized(), kUp, goes_on});
    if (random.below(2)) std::swap(borders.back().from, borders.back().to);
  }
  return borders;
}

/// Corners about (0, 0) by angle: on an ellipse, the polygon is convex.
std::vector<Vector3d> random_polygon(survey::Random& random, bool convex) {
  std::vector<double> angles(3 + random.below(6));
  for (double& angle : angles) angle = random.uniform(0, 2 * std::numbers::pi);
  std::sort(angles.begin(), angles.end());
  const double width = random.uniform(0.02, 4) * kLambda, length = random.uniform(1, 4) * kLambda;
  std::vector<Vector3d> corners;
  for (const double angle : angles) {
    const double out = convex ? 1 : random.uniform(0.2, 1);
    corners.push_back({out * length * std::cos(angle), out * width * std::sin(angle), 0});
  }
  return corners;
}

/// By the number of sides that a ray crosses.
bool is_inside(const std::vector<Vector3d>& corners, const Vector3d& p) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3d &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

double distance_to(const std::vector<Border>& borders, const Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Border& b : borders) least = std::min(least, (nearest_on(b.from, b.to, p) - p).norm());
  return least;
}

/// Borders with and without a common corner, felt and empty places, also twice and at one place.
Ground random_ground(survey::Random& random) {
  Ground ground;
  for (int i = 0, count = static_cast<int>(random.below(4)); i < count; ++i) {
    const Vector3d from = random_flat(random, 3 * kLambda), to = random_flat(random, 3 * kLambda);
    const double side = random.below(2) ? 1 : -1;
    ground.borders.push_back(
        {from, to, side * (to - from).cross(kUp).normalized(), kUp, random.below(2) == 0});
  }
  const auto corners = random_polygon(random, true);
  for (const Border& side : sides(random, corners, random.below(2) == 0)) ground.borders.push_back(side);
  const Vector3d at = ground.borders.front().from;
  if (random.below(3) == 0) ground.borders.push_back({at, at, {1, 0, 0}, kUp, true});
  if (random.below(3) == 0) ground.borders.push_back(ground.borders.front());
  for (auto* places : {&ground.felt, &ground.empty})
    for (int i = 0, count = static_cast<int>(random.below(4)); i < count; ++i)
      places->push_back(random_flat(random, 4 * kLambda));
  if (!ground.felt.empty() && random.below(4) == 0) ground.empty.push_back(ground.felt.front());
  return ground;
}

TEST(NewGround, IsNowhereWithoutABorder) {
  Ground ground;
  EXPECT_EQ(ground.made().at({0, 0, 0}), 0);
  ground.felt = {{0, 0, 0}}, ground.empty = {{kLambda, 0, 0}};
  ground.borders = {{{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, kUp, true}};
  EXPECT_EQ(ground.made().at({0, kLambda, 0}), 0) << "a border without length has no outside";
}

TEST(NewGround, RisesOutwardFromABorderThatGoesOn) {
  const NewGround ground = Ground{{}, kUp, {x_axis(2)}, {}, {}}.made();
  const NewGround ended = Ground{{}, kUp, {x_axis(2, false)}, {}, {}}.made();
  double before = 0;
  for (int i = -100; i <= 100; ++i) {
    const double height = (i + 0.5) * kLambda / 20;
    SCOPED_TRACE("at " + std::to_string(height / kLambda) + " λ");
    const double now = ground.at({0.3, height, 0});
    EXPECT_EQ(ended.at({0.3, height, 0}), 0);
    if (height <= 0.45 * kLambda) {
      EXPECT_EQ(now, 0);
    } else if (height < 0.999 * kFar) {
      EXPECT_GE(now, before);
      EXPECT_EQ(now == 1, height > 0.9 * kLambda);
    } else if (height > 1.001 * kFar) {
      EXPECT_EQ(now, 0) << "too far to be expected";
    }
    before = now;
  }
}

TEST(NewGround, RisesWithTheDistanceFromWhatIsFelt) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    Ground ground{{}, kUp, {x_axis(4)}, {{0, 1.9 * kLambda, 0}}, {}};
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    const Vector3d way(std::cos(angle), std::sin(angle), 0);
    const NewGround made = ground.made();
    double before = 0;
    for (double off = 0; off < 0.95 * kLambda; off += kLambda / 50) {
      const double now = made.at(ground.felt[0] + off * way);
      EXPECT_NEAR(now, ramp(off), 1e-12);
      EXPECT_GE(now, before);
      before = now;
    }
  }
}

TEST(NewGround, IsNotNearAnEmptyPlace) {
  Ground ground{{}, kUp, {x_axis(4)}, {}, {}};
  const Vector3d place(0, 1.5 * kLambda, 0);
  EXPECT_EQ(ground.made().at(place), 1);
  ground.empty = {place + Vector3d(2.2 * kLambda, 0, 0)};
  EXPECT_EQ(ground.made().at(place), 1) << "the border is nearer by far";
  ground.empty = {place + Vector3d(2 * kLambda, 0, 0)};
  EXPECT_EQ(ground.made().at(place), 0);
  ground.felt = {place + Vector3d(-kLambda, 0, 0)};
  EXPECT_EQ(ground.made().at(place), 1) << "surface is felt nearer still";
}

TEST(NewGround, IsAsItsDefinitionHasIt) {
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    const Ground ground = random_ground(random);
    const NewGround made = ground.made();
    for (int i = 0; i < 20; ++i) {
      const Vector3d place = random_flat(random, 5 * kLambda);
      const double value = made.at(place);
      ASSERT_NEAR(value, by_definition(ground, place), 1e-9) << place.transpose();
      sum += value;
    }
  }
  EXPECT_GT(sum, 1000);
}

TEST(NewGround, IsTheSameWhereverThePlaneLiesAndInAnyOrder) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    const Ground ground = random_ground(random);
    const Isometry3d by = random_rigid_motion(random, 1);
    Ground moved = ground.moved(by);
    shuffle(random, moved.borders), shuffle(random, moved.felt), shuffle(random, moved.empty);
    for (Border& border : moved.borders)
      if (random.below(2)) std::swap(border.from, border.to);
    moved.origin += by.linear() * random_flat(random, 1);
    const NewGround made = ground.made(), elsewhere = moved.made();
    for (int i = 0; i < 20; ++i) {
      const Vector3d place = random_flat(random, 5 * kLambda);
      ASSERT_NEAR(made.at(place), elsewhere.at(by * place), 1e-9) << place.transpose();
    }
  }
}

TEST(NewGround, LiesOutsideAPolygonRoundEveryCorner) {
  int near_corners = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    const bool convex = seed % 2 == 0;
    SCOPED_TRACE("seed " + std::to_string(seed) + (convex ? ", convex" : ", star-shaped"));
    survey::Random random(seed);
    const auto corners = random_polygon(random, convex);
    if (!convex && !is_inside(corners, {0, 0, 0})) continue;  // no star about (0, 0), and maybe not simple
    Ground ground;
    ground.borders = sides(random, corners, true);
    shuffle(random, ground.borders);
    const NewGround made = ground.made();
    for (int i = 0; i < 30; ++i) {
      const Vector3d& corner = corners[random.below(corners.size())];
      const Vector3d place = i % 3 == 0 ? random_flat(random, 5 * kLambda)
                                        : Vector3d(corner + random_flat(random, 1.2 * kLambda));
      const double distance = distance_to(ground.borders, place);
      if (std::abs(distance - kFar) < 1e-9) continue;
      const double expected = is_inside(corners, place) || distance > kFar ? 0 : ramp(distance);
      ASSERT_NEAR(made.at(place), expected, 1e-9) << place.transpose();
      near_corners += i % 3 != 0 && expected > 0;
    }
  }
  EXPECT_GT(near_corners, 5000);
}

TEST(NewGround, IsNeverRaisedByWhatIsFeltOrEmpty) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    survey::Random random(seed);
    Ground ground = random_ground(random);
    const std::vector<Vector3d> empty = std::exchange(ground.empty, {}),
                                felt = std::exchange(ground.felt, {});
    const NewGround bare = ground.made();
    ground.felt = felt;
    const NewGround with_felt = ground.made();
    ground.empty = empty;
    const NewGround with_both = ground.made();
    for (int i = 0; i < 20; ++i) {
      const Vector3d place = random_flat(random, 5 * kLambda);
      ASSERT_LE(with_felt.at(place), bare.at(place));
      ASSERT_LE(with_both.at(place), with_felt.at(place));
      ASSERT_GE(with_both.at(place), 0);
      ASSERT_LE(bare.at(place), 1);
    }
  }
}

}  // namespace
}  // namespace limpet::following::internal
