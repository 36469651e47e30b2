// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/thesis/perimeter_internal.hpp>

#include "initial_model.hpp"

namespace limpet::following::internal {
namespace {

using Edge = model::View::Edge;

TEST(Perimeter, IsClosedInBothDirections) {
  const auto model =
      initial_model({{rectangle(0, 0, 3, 1), hole(0.5, 0.3, 0.9, 0.7), hole(1.5, 0.3, 2.5, 0.7)}});
  const auto edges = edges_of(model, segments_of(model).front());
  ASSERT_EQ(edges.size(), 12u);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_EQ(edges[beside(edges, i, true)].id, edges[i].next);
    EXPECT_EQ(edges[beside(edges, i, false)].id, edges[i].previous);
  }
}

TEST(Perimeter, RouteIsTheShorterOfTheTwo) {
  const auto model = initial_model({{rectangle(0, 0, 3, 1)}});
  const auto id = segments_of(model).front();
  const auto edges = edges_of(model, id);
  const auto index = [&](const Eigen::Vector3d& p) { return nearest_edge(edges, p); };
  const auto to = [&](std::size_t from, std::size_t wanted) {
    return shortest_route(edges, from, [&](const Edge& e) { return e.id == edges[wanted].id; });
  };
  const std::size_t low = index({1, 0, 0}), right = index({3, 0.5, 0}), high = index({1, 1, 0});
  EXPECT_TRUE(to(low, right)->forwards);
  EXPECT_FALSE(to(right, low)->forwards);
  EXPECT_NEAR(to(low, high)->length, 1, 1e-9);  // over one of the short sides
  EXPECT_EQ(to(low, low)->to, low);
}

TEST(Perimeter, NoRouteLeadsToAnotherCycle) {
  const auto model = initial_model({{rectangle(0, 0, 3, 1), hole(0.5, 0.3, 0.9, 0.7)}});
  const auto edges = edges_of(model, segments_of(model).front());
  EXPECT_FALSE(shortest_route(edges, 0, [](const Edge& e) { return e.hole; }));
}

}  // namespace
}  // namespace limpet::following::internal
