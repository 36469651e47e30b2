// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/transit/visited_internal.hpp>

#include "initial_model.hpp"
#include "random_places.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

/// A robot that has gone along the x axis from 0 to 1, with nothing near.
Visited gone_along_x(const model::Model& model) {
  Visited visited(kLambda);
  for (int i = 0; i <= 20; ++i) visited.arrive(model.view(), Clearance(kLambda), {i * kLambda, 0, 0});
  return visited;
}

TEST(Visited, TheWayLeadsBackOverVisitedPlaces) {
  const model::Model model = initial_model({{rectangle(0, 0, 1, 1, 10)}});
  const Visited visited = gone_along_x(model);
  const auto way = visited.way_to([](const Vector3d& p) { return p.x() < 0.3; });
  ASSERT_GT(way.size(), 2u);
  EXPECT_NEAR(way.front().x(), 1, kLambda);
  EXPECT_NEAR(way.back().x(), 0.25, kLambda);
  for (std::size_t i = 1; i < way.size(); ++i) EXPECT_LE((way[i] - way[i - 1]).norm(), 2 * kLambda);
}

TEST(Visited, ThereIsNoWayToWhatNobodyWants) {
  const model::Model model = initial_model({{rectangle(0, 0, 1, 1, 10)}});
  EXPECT_TRUE(gone_along_x(model).way_to([](const Vector3d&) { return false; }).empty());
}

TEST(Visited, ABlockedWayIsTakenLast) {
  const model::Model model = initial_model({{rectangle(0, 0, 1, 1, 10)}});
  Visited visited(kLambda);
  const Clearance clearance(kLambda);
  const auto go = [&](double x, double y) { visited.arrive(model.view(), clearance, {x, y, 0}); };
  // A square of side 2 λ: from one corner there are two ways to the opposite one.
  for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, {0, 0}})
    go(x * kLambda, y * kLambda);
  const auto wanted = [](const Vector3d& p) { return p.x() > 1.9 * kLambda && p.y() < 0.1 * kLambda; };
  const auto before = visited.way_to(wanted);
  ASSERT_GE(before.size(), 2u);
  visited.block(before[1]);
  const auto after = visited.way_to(wanted);
  ASSERT_GE(after.size(), 2u);
  EXPECT_NE(before[1], after[1]);
}

}  // namespace
}  // namespace limpet::following::internal
