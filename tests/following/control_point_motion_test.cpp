// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limpet/following/thesis/control_point_motion.hpp>
#include <limpet/survey/random.hpp>

#include "random_places.hpp"

namespace limpet::following {
namespace {

using Eigen::Vector3d;

TEST(ControlPointMotion, KeepsItsLawsForAnySituation) {
  survey::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const ClosestPoint closest{random.uniform(0, 0.4), random_vector(random).normalized()};
    const double delta = random.uniform(0.05, 0.2), step = random.uniform(0, 0.2);
    const Vector3d along = random_vector(random);
    const Vector3d motion = control_point_motion(closest, delta, step, along);
    const double sigma = std::min(step, closest.distance);
    const double corrective = std::clamp(delta - closest.distance, -sigma, sigma);
    EXPECT_LE(motion.norm(), sigma + 1e-12);
    EXPECT_NEAR(motion.dot(closest.away), corrective, 1e-12);
    EXPECT_NEAR(motion.norm(), sigma, 1e-12);
    // The rest goes along the surface following direction, as far as that lies in the plane.
    EXPECT_GE(motion.dot(along - along.dot(closest.away) * closest.away), -1e-12);
    EXPECT_NEAR(motion.dot(closest.away.cross(along)), 0, 1e-12);
  }
}

TEST(ControlPointMotion, CorrectsOnlyWhereThereIsNoDirectionAlongTheSurface) {
  const ClosestPoint closest{0.12, Vector3d::UnitZ()};
  for (const Vector3d& along : {Vector3d(0, 0, 0), Vector3d(0, 0, -3)})
    EXPECT_TRUE(control_point_motion(closest, 0.1, 0.1, along).isApprox(Vector3d(0, 0, -0.02)));
}

TEST(ControlPointMotion, CorrectionComesFirst) {
  const ClosestPoint closest{0.4, Vector3d::UnitZ()};
  EXPECT_TRUE(control_point_motion(closest, 0.1, 0.1, Vector3d::UnitX()).isApprox(Vector3d(0, 0, -0.1)));
}

TEST(ControlPointMotion, StandsStillOnTheModel) {
  EXPECT_EQ(control_point_motion({0, Vector3d::UnitZ()}, 0.1, 0.1, Vector3d::UnitX()).norm(), 0);
}

}  // namespace
}  // namespace limpet::following
