// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/thesis/path_internal.hpp>

#include "initial_model.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;
using model::SegmentId;

constexpr double kRim = 0.1;

SegmentId face_towards(const model::Model& model, const Vector3d& normal) {
  for (const SegmentId id : segments_of(model))
    if (model.view().segment(id)->plane.normal.dot(normal) > 0.9) return id;
  return {};
}

double length_between_first_and_last(const Path& path) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < path.legs.size(); ++i) sum += (path.legs[i].to - path.legs[i].from).norm();
  return sum;
}

void expect_connected(const Path& path) {
  for (std::size_t i = 1; i < path.legs.size(); ++i)
    EXPECT_LT((path.legs[i - 1].to - path.legs[i].from).norm(), 1e-3) << i;
}

TEST(ShortestPath, IsTheNearestEdgeWhereThatBelongsToTheGoal) {
  const auto model = shared_cube();
  const auto top = face_towards(model, Vector3d::UnitZ());
  const auto path = shortest_path(model.view(), {0.5, 0.1, 1.1}, {top}, {}, kRim);
  ASSERT_TRUE(path);
  ASSERT_EQ(path->legs.size(), 1u);
  EXPECT_EQ(path->goal, top);
  EXPECT_EQ(model.view().edge(path->legs[0].edge)->segment, top);
}

TEST(ShortestPath, LeadsOverSharedEdgesToTheOppositeFace) {
  const auto model = shared_cube();
  const auto bottom = face_towards(model, -Vector3d::UnitZ());
  const auto path = shortest_path(model.view(), {0.3, -0.1, 1.1}, {bottom}, {}, kRim);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->goal, bottom);
  expect_connected(*path);
  // Along the top edge to its nearer corner, down, and on the bottom.
  ASSERT_EQ(path->legs.size(), 3u);
  EXPECT_NEAR(length_between_first_and_last(*path), 1, 1e-3);
  EXPECT_LT(path->legs[0].to.x(), 0.01);
  EXPECT_EQ(model.view().edge(path->legs.back().edge)->segment, bottom);
}

TEST(ShortestPath, GoesRoundWhatIsBarred) {
  const auto model = shared_cube();
  const auto bottom = face_towards(model, -Vector3d::UnitZ());
  const Vector3d start(0.3, -0.1, 1.1);
  const auto first = shortest_path(model.view(), start, {bottom}, {}, kRim);
  const auto second = shortest_path(model.view(), start, {bottom}, {first->legs[1].edge}, kRim);
  ASSERT_TRUE(second);
  expect_connected(*second);
  EXPECT_GT(second->legs[0].to.x(), 0.99);  // down at the other corner
}

TEST(ShortestPath, HopsToTheRimOfAHole) {
  // The goal's outer perimeter is barred, so that the rim of its hole is all that is left.
  const auto model =
      initial_model({{rectangle(0, 0, 1, 1)}, {rectangle(1.3, 0, 3, 1), hole(2, 0.25, 2.5, 0.75)}});
  const auto goal = segments_of(model)[1];
  std::set<geometry::EdgeId> outer;
  for (const auto& e : edges_of(model, goal))
    if (!e.hole) outer.insert(e.id);
  const auto path = shortest_path(model.view(), {0.9, 0.5, 0.1}, {goal}, outer, kRim);
  ASSERT_TRUE(path);
  expect_connected(*path);
  EXPECT_TRUE(model.view().edge(path->legs.back().edge)->hole);
}

TEST(ShortestPath, HopsToASurfaceThatIsNotJoined) {
  const auto model =
      initial_model({{rectangle(0, 0, 1, 1)}, {rectangle(1.3, 0, 2, 1)}, {rectangle(5, 0, 6, 1)}});
  const auto segments = segments_of(model);
  const auto path = shortest_path(model.view(), {0, 0.1, 0.1}, {segments[1]}, {}, kRim);
  ASSERT_TRUE(path);
  expect_connected(*path);
  EXPECT_EQ(path->goal, segments[1]);
  const auto hop =
      std::find_if(path->legs.begin(), path->legs.end(), [](const Path::Leg& l) { return !l.edge; });
  ASSERT_NE(hop, path->legs.end());
  EXPECT_NEAR((hop->to - hop->from).norm(), 0.3, 1e-3);
}

TEST(ShortestPath, DoesNotHopThroughTheBody) {
  // Two opposite faces of a thin plate and one of its sides: the way to the bottom leads over the side.
  const auto model = initial_model({{rectangle(0, 0, 1, 1, 0.4)},
                                    {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}},
                                    {{{1.0, 0, 0}, {1.0, 1, 0}, {1.0, 1, 0.4}, {1.0, 0, 0.4}}}});
  const auto bottom = segments_of(model)[1];
  const auto path = shortest_path(model.view(), {0.1, 0.5, 0.5}, {bottom}, {}, kRim);
  ASSERT_TRUE(path);
  for (const auto& leg : path->legs)
    EXPECT_TRUE(leg.edge || (leg.to - leg.from).norm() < 0.1)
        << leg.from.transpose() << " to " << leg.to.transpose();
}

TEST(ShortestPath, IsNoneInAnEmptyModel) {
  const model::Model model(model::Parameters{});
  EXPECT_FALSE(shortest_path(model.view(), {0, 0, 0}, {{1}}, {}, kRim));
}

}  // namespace
}  // namespace limpet::following::internal
