// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <limpet/simulation/range_image.hpp>
#include <limpet/simulation/sensing.hpp>
#include <limpet/simulation/shapes.hpp>
#include <limpet/survey/random.hpp>
#include <stdexcept>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;

/// A world that shows the same to every sensor.
class Everywhere : public World {
 public:
  Everywhere(double distance, double cosine = 1) : sighting_{distance, cosine} {}
  std::optional<Sighting> sight(const Vector3d&, const Vector3d&, double) const override { return sighting_; }
  bool meets(const Vector3d&, double) const override { return true; }

 private:
  Sighting sighting_;
};

class Nothing : public World {
 public:
  std::optional<Sighting> sight(const Vector3d&, const Vector3d&, double) const override { return {}; }
  bool meets(const Vector3d&, double) const override { return false; }
};

struct Moments {
  double mean = 0, deviation = 0;
};

Moments moments_of(const std::vector<double>& values) {
  Moments moments;
  for (const double x : values) moments.mean += x / static_cast<double>(values.size());
  double sum = 0;
  for (const double x : values) sum += (x - moments.mean) * (x - moments.mean);
  moments.deviation = std::sqrt(sum / static_cast<double>(values.size()));
  return moments;
}

/// All distances read in so many steps at one place.
std::vector<double> distances(const World& world, const SensingErrors& errors, int steps) {
  const kinematics::Robot robot = kinematics::point_robot({});
  Sensing sensing(world, errors);
  std::vector<double> result;
  for (int i = 0; i < steps; ++i)
    for (const model::SensorPoint& p : sensing.sense(robot, Vector3d(1, 2, 3)).points)
      result.push_back(p.range);
  return result;
}

TEST(Sensing, WithoutErrorsThePointsAreThoseOfTheSurface) {
  const Mesh mesh = make_shape("L");
  const auto world = make_mesh_world(mesh);
  const std::vector<Face> faces = faces_of(mesh);
  Sensing sensing(*world, {});
  const kinematics::Robot robot = kinematics::point_robot({});
  survey::Random random(1);
  std::size_t points = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3d at = Vector3d(random.uniform(), random.uniform(), random.uniform()) * 1.4;
    const Sensed sensed = sensing.sense(robot, at);
    EXPECT_EQ(sensed.measured, at);
    ASSERT_EQ(sensed.points.size(), sensed.sensors.size());
    for (std::size_t i = 0; i < sensed.points.size(); ++i) {
      const model::SensorPoint& p = sensed.points[i];
      ++points;
      EXPECT_EQ(p.axis, robot.sensors[sensed.sensors[i]].axis);
      EXPECT_LE(p.range, 0.2);
      EXPECT_NEAR((p.position - at).norm(), p.range, 1e-12);
      double off = 1;
      for (const Face& face : faces)
        off = std::min(off, std::abs((p.position - face.centroid).dot(face.normal)));
      EXPECT_LT(off, 1e-12);
    }
  }
  EXPECT_GT(points, 200u);
}

TEST(Sensing, OfARangeImageGivesItsOwnPoints) {
  const Mesh cube = make_shape("cube");
  const RangeImage image = take_range_image(cube, Vector3d(-1, -2, -3), 0.02);
  const auto world = make_range_image_world(image.points);
  Sensing sensing(*world, {});
  const kinematics::Robot robot = kinematics::point_robot({});
  const Vector3d over = bounds_of(cube).centre() + Vector3d(0, 0, 0.6);
  const Sensed sensed = sensing.sense(robot, over);
  EXPECT_GE(sensed.points.size(), 5u);
  for (const model::SensorPoint& p : sensed.points) {
    double nearest = 1;
    for (const Vector3d& q : image.points) nearest = std::min(nearest, (p.position - q).norm());
    EXPECT_LT(nearest, 1e-12);
  }
}

TEST(Sensing, NoiseHasItsMomentsAndIsAlongTheAxis) {
  const Everywhere world(0.1);
  const auto found = moments_of(distances(world, {.noise = 0.003}, 2000));
  EXPECT_NEAR(found.mean, 0.1, 4 * 0.003 / std::sqrt(52000.0));
  EXPECT_NEAR(found.deviation, 0.003, 0.00005);
  Sensing sensing(world, {.noise = 0.003});
  for (const model::SensorPoint& p : sensing.sense(kinematics::point_robot({}), Vector3d(1, 2, 3)).points)
    EXPECT_LT((p.position - Vector3d(1, 2, 3) - p.range * p.axis).norm(), 1e-12);
}

TEST(Sensing, NoiseGrowsWithTheAngleUpToABound) {
  const double sigma = 0.001, k = 2;
  for (const double cosine : {1.0, 0.8, 0.5, 0.1, 0.0}) {
    const double tan2 = cosine > 0 ? (1 - cosine * cosine) / (cosine * cosine) : 1e9;
    const double expected = sigma * std::min(1 + k * tan2, kMostGrazingNoise);
    const Everywhere world(0.1, cosine);
    const auto found = moments_of(distances(world, {.noise = sigma, .noise_at_angle = k}, 1000));
    EXPECT_NEAR(found.deviation / expected, 1, 0.03) << cosine;
    EXPECT_NEAR(moments_of(distances(world, {.noise = sigma}, 1000)).deviation / sigma, 1, 0.03);
  }
}

TEST(Sensing, DropoutsAndOutliersAreTheirFractions) {
  const Everywhere world(0.125);
  const double all = 26 * 2000;
  EXPECT_NEAR(static_cast<double>(distances(world, {.dropouts = 0.1}, 2000).size()) / all, 0.9, 0.006);
  EXPECT_TRUE(distances(world, {.dropouts = 1}, 10).empty());

  std::vector<double> outliers;
  for (const double d : distances(world, {.outliers = 0.2}, 2000))
    if (d != 0.125) outliers.push_back(d);
  EXPECT_NEAR(static_cast<double>(outliers.size()) / all, 0.2, 0.008);
  const Moments uniform = moments_of(outliers);
  EXPECT_NEAR(uniform.mean, 0.1, 0.002);
  EXPECT_NEAR(uniform.deviation, 0.2 / std::sqrt(12.0), 0.002);
  EXPECT_LE(*std::max_element(outliers.begin(), outliers.end()), 0.2);
  EXPECT_GE(*std::min_element(outliers.begin(), outliers.end()), 0);
}

TEST(Sensing, WhereNothingIsThereIsNoReadingButOfAStuckSensor) {
  const Nothing world;
  EXPECT_TRUE(distances(world, {.noise = 0.01, .outliers = 1}, 10).empty());
  EXPECT_EQ(distances(world, {.dropouts = 1, .stuck = {{3, 0.15}}}, 2), std::vector<double>(2, 0.15));
  Sensing sensing(world, {.stuck = {{3, 0.15}}});
  const kinematics::Robot robot = kinematics::point_robot({});
  const Sensed sensed = sensing.sense(robot, Vector3d(1, 2, 3));
  ASSERT_EQ(sensed.sensors, std::vector<std::size_t>{3});
  EXPECT_EQ(sensed.points[0].position, Vector3d(1, 2, 3) + 0.15 * robot.sensors[3].axis);
}

TEST(Sensing, NoisyReadingsMayBeBeyondTheRangeButNotBehindTheSensor) {
  const auto far = distances(Everywhere(0.2), {.noise = 0.01}, 100);
  EXPECT_EQ(far.size(), 2600u);
  EXPECT_GT(*std::max_element(far.begin(), far.end()), 0.2);
  const auto near = distances(Everywhere(0.005), {.noise = 0.01}, 100);
  EXPECT_EQ(near.size(), 2600u);
  EXPECT_EQ(*std::min_element(near.begin(), near.end()), 0);
}

TEST(Sensing, EncoderNoiseMovesTheWholeSetTogether) {
  const auto world = make_mesh_world(make_shape("cube"));
  const kinematics::Robot robot = kinematics::point_robot({});
  const Vector3d at = bounds_of(make_shape("cube")).high + Vector3d(0.05, 0.05, 0.05);
  const Sensed exact = Sensing(*world, {}).sense(robot, at);
  ASSERT_FALSE(exact.points.empty());
  Sensing sensing(*world, {.encoder_noise = 0.02});
  std::vector<double> errors;
  for (int step = 0; step < 3000; ++step) {
    const Sensed sensed = sensing.sense(robot, at);
    const Vector3d shift = sensed.measured - at;
    errors.insert(errors.end(), shift.begin(), shift.end());
    ASSERT_EQ(sensed.sensors, exact.sensors);
    for (std::size_t i = 0; i < sensed.points.size(); ++i) {
      EXPECT_LT((sensed.points[i].position - exact.points[i].position - shift).norm(), 1e-12);
      EXPECT_EQ(sensed.points[i].range, exact.points[i].range);
    }
  }
  EXPECT_NEAR(moments_of(errors).mean, 0, 4 * 0.02 / std::sqrt(9000.0));
  EXPECT_NEAR(moments_of(errors).deviation, 0.02, 0.0006);
}

TEST(Sensing, EachKindOfJointHasItsOwnEncoderNoise) {
  kinematics::Robot robot;
  robot.links.resize(3);
  robot.links[0].joint.kind = kinematics::Joint::Kind::revolute;
  robot.links[1].parent = 0;
  robot.links[2].parent = 1;
  robot.links[2].joint.kind = kinematics::Joint::Kind::prismatic;
  const Nothing world;
  Sensing sensing(world, {.encoder_noise = 0.5, .encoder_noise_rad = 0.01});
  std::vector<double> turns, slides;
  for (int i = 0; i < 5000; ++i) {
    const kinematics::Configuration measured = sensing.sense(robot, Eigen::Vector2d(1, 2)).measured;
    turns.push_back(measured[0]);
    slides.push_back(measured[1]);
  }
  EXPECT_NEAR(moments_of(turns).deviation, 0.01, 0.0004);
  EXPECT_NEAR(moments_of(slides).deviation, 0.5, 0.02);
}

TEST(Sensing, APointAsideOfItsAxisTurnsWithTheMeasuredLink) {
  kinematics::Robot robot;
  robot.links.resize(1);
  robot.links[0].joint = {kinematics::Joint::Kind::revolute, Vector3d::UnitZ()};
  robot.sensors.push_back({0, Vector3d(1, 0, 0), Vector3d::UnitX(), 5});
  const auto world = make_range_image_world({{3, 0.1, 0}, {3, 0.1, 9}}, 0.2);
  Sensing sensing(*world, {.encoder_noise_rad = 0.3});
  const Eigen::VectorXd truth = Eigen::VectorXd::Zero(1);
  for (int i = 0; i < 20; ++i) {
    const Sensed sensed = sensing.sense(robot, truth);
    ASSERT_EQ(sensed.points.size(), 1u);
    const Vector3d expected = Eigen::AngleAxisd(sensed.measured[0], Vector3d::UnitZ()) * Vector3d(3, 0.1, 0);
    EXPECT_LT((sensed.points[0].position - expected).norm(), 1e-12);
  }
}

TEST(Sensing, TheSameSeedGivesTheSameErrorsOnAnotherWay) {
  const Everywhere full(0.1);
  const Nothing empty;
  const kinematics::Robot robot = kinematics::point_robot({});
  const SensingErrors errors{
      .noise = 0.01, .dropouts = 0.2, .outliers = 0.2, .encoder_noise = 0.01, .seed = 9};
  Sensing a(full, errors), b(full, errors);
  for (int i = 0; i < 50; ++i) {
    const Sensed one = a.sense(robot, Vector3d(1, 2, 3)), other = b.sense(robot, Vector3d(4, 5, 6));
    EXPECT_LT((one.measured - other.measured + Vector3d(3, 3, 3)).norm(), 1e-12);
    ASSERT_EQ(one.sensors, other.sensors);
    for (std::size_t k = 0; k < one.points.size(); ++k) EXPECT_EQ(one.points[k].range, other.points[k].range);
  }
  // Having met nothing for a while changes nothing of what follows.
  Sensing c(empty, errors), d(full, errors);
  EXPECT_EQ(c.sense(robot, Vector3d(1, 2, 3)).measured, d.sense(robot, Vector3d(1, 2, 3)).measured);
  EXPECT_EQ(c.sense(robot, Vector3d(1, 2, 3)).measured, d.sense(robot, Vector3d(1, 2, 3)).measured);
  // Nor does another kind of error.
  SensingErrors without = errors;
  without.encoder_noise = 0;
  EXPECT_EQ(distances(full, errors, 20), distances(full, without, 20));
  without = errors;
  without.seed = 10;
  EXPECT_NE(distances(full, errors, 20), distances(full, without, 20));
}

TEST(Sensing, ErrorsThatMakeNoSenseAreRefused) {
  const Nothing world;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(Sensing(world, {}));
  EXPECT_THROW(Sensing(world, {.noise = -1}), std::invalid_argument);
  EXPECT_THROW(Sensing(world, {.noise_at_angle = nan}), std::invalid_argument);
  EXPECT_THROW(Sensing(world, {.dropouts = 1.5}), std::invalid_argument);
  EXPECT_THROW(Sensing(world, {.outliers = -0.1}), std::invalid_argument);
  EXPECT_THROW(Sensing(world, {.stuck = {{0, -1}}}), std::invalid_argument);
  EXPECT_THROW(Sensing(world, {.encoder_noise = -1}), std::invalid_argument);
  EXPECT_THROW(Sensing(world, {.encoder_noise_rad = -1}), std::invalid_argument);
  Sensing stuck(world, {.stuck = {{26, 0.1}}});
  EXPECT_THROW(stuck.sense(kinematics::point_robot({}), Vector3d(0, 0, 0)), std::invalid_argument);
  Sensing fine(world, {});
  EXPECT_THROW(fine.sense(kinematics::point_robot({}), Eigen::Vector2d(0, 0)), std::invalid_argument);
}

/// A switch fires where some of the surface is in its field, whatever the errors of sensors and encoders; and
/// it takes none of their random numbers.
TEST(Sensing, SwitchesFireWhereTheirFieldsMeetTheSurface) {
  const Mesh mesh = make_shape("cube");
  const auto world = make_mesh_world(mesh);
  const SensingErrors errors{.noise = 0.01, .dropouts = 0.3, .outliers = 0.1, .encoder_noise = 0.02};
  kinematics::Robot plain = kinematics::point_robot({}), switched = plain;
  for (const kinematics::RangeSensor& s : plain.sensors)
    switched.switches.push_back({s.link, s.position, s.axis, 0.3});
  Sensing sensing(*world, errors), without(*world, errors);
  survey::Random random(9);
  std::size_t fired = 0, silent = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Vector3d at = Vector3d(random.uniform(), random.uniform(), random.uniform()) * 1.6;
    const Sensed sensed = sensing.sense(switched, at), expected = without.sense(plain, at);
    EXPECT_EQ(sensed.measured, expected.measured);
    EXPECT_EQ(sensed.sensors, expected.sensors);
    for (std::size_t i = 0; i < expected.points.size(); ++i)
      EXPECT_EQ(sensed.points[i].position, expected.points[i].position);
    EXPECT_TRUE(expected.seeing.empty());
    const kinematics::Posture truth(switched, at);
    std::vector<std::size_t> seeing;
    for (std::size_t i = 0; i < switched.switches.size(); ++i)
      if (world->meets(truth.proximity_switch(i).field_centre, 0.15)) seeing.push_back(i);
    EXPECT_EQ(sensed.seeing, seeing);
    fired += seeing.size(), silent += switched.switches.size() - seeing.size();
  }
  EXPECT_GT(fired, 300u);
  EXPECT_GT(silent, 300u);
}

}  // namespace
}  // namespace limpet::simulation
