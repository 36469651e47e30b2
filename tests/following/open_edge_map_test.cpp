// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/frontier/open_edge_map_internal.hpp>
#include <set>

#include "initial_model.hpp"
#include "simulated_run.hpp"

namespace limpet::following::internal {
namespace {

std::set<std::uint64_t> edges_in(OpenEdgeMap& map, const model::View& view) {
  std::vector<OpenPart> parts;
  map.near({0.5, 0.5, 0.5}, 2, view, parts);
  std::set<std::uint64_t> edges;
  for (const OpenPart& part : parts) edges.insert(part.edge.value);
  return edges;
}

TEST(OpenEdgeMap, KeptByTheChangesItHoldsTheOpenEdgesOfTheModel) {
  RunOptions options;
  options.shape = "L";
  options.noise = 0.002;
  options.most_sets = 500;
  options.strategy = Strategy::frontier;
  OpenEdgeMap map(options.resolution);
  run_following(options, [&](const Observation& seen, const Motion&) {
    const model::View view = seen.model.view();
    map.apply(seen.changes, view);
    std::vector<model::View::Edge> open;
    view.open_edges(open);
    std::set<std::uint64_t> expected;
    for (const auto& edge : open) expected.insert(edge.id.value);
    ASSERT_EQ(edges_in(map, view), expected);
  });
}

TEST(OpenEdgeMap, PartsAreAtMostTwoResolutionsLongAndMakeUpTheEdge) {
  const model::Model model = initial_model({{rectangle(0, 0, 1, 0.3)}});
  OpenEdgeMap map(0.05);
  map.read(model.view());
  std::vector<OpenPart> parts;
  map.near({0.5, 0, 0}, 2, model.view(), parts);
  double length = 0;
  for (const OpenPart& part : parts) {
    EXPECT_LE((part.to - part.from).norm(), 0.1 + 1e-6);
    length += (part.to - part.from).norm();
  }
  EXPECT_NEAR(length, 2.6, 1e-3) << "up to the rounding of the grid";
}

TEST(OpenEdgeMap, EdgesThatWouldCloseAreLeftAloneUnlessSomethingIsLeftNearThem) {
  const model::Model model = initial_model({{rectangle(0, 0, 0.1, 0.1)}});
  OpenEdgeMap map(0.05);
  map.read(model.view());
  const auto edges = edges_of(model, segments_of(model)[0]);
  model::Outcome outcome;
  for (const auto& edge : edges) outcome.edges.push_back({edge.segment, edge.id, true, {}, {}});
  const auto left_alone = [&] {
    std::vector<OpenPart> parts;
    map.near({0, 0, 0}, 1, model.view(), parts);
    EXPECT_FALSE(parts.empty());
    std::set<std::uint64_t> closing;
    for (const OpenPart& part : parts)
      if (part.closes) closing.insert(part.edge.value);
    return closing;
  };
  EXPECT_TRUE(left_alone().empty());
  map.note(outcome);
  EXPECT_EQ(left_alone(), edges_in(map, model.view()));
  EXPECT_FALSE(map.any_wanted({0, 0, 0}, 1));
  EXPECT_TRUE(map.edges(PartState::wanted).empty());
  outcome.left.push_back({edges[0].segment, edges[0].from, edges[0].to});
  map.note(outcome);
  EXPECT_FALSE(left_alone().count(edges[0].id.value));
  EXPECT_TRUE(map.any_wanted({0, 0, 0}, 1));
}

TEST(OpenEdgeMap, WhatWasUnreachableCanBeTriedAgain) {
  const model::Model model = initial_model({{rectangle(0, 0, 0.1, 0.1)}});
  OpenEdgeMap map(0.05);
  map.read(model.view());
  EXPECT_FALSE(map.retry()) << "nothing is unreachable";
  map.give_up({0, 0, 0}, 1);
  EXPECT_FALSE(map.any_wanted({0, 0, 0}, 1));
  EXPECT_EQ(map.edges(PartState::unreachable).size(), 4u);
  EXPECT_TRUE(map.retry());
  EXPECT_TRUE(map.any_wanted({0, 0, 0}, 1));
  EXPECT_TRUE(map.edges(PartState::unreachable).empty());
}

TEST(OpenEdgeMap, WhatSeemedDoneIsInsistedOnOnce) {
  const model::Model model = initial_model({{rectangle(0, 0, 0.05, 0.05)}});
  OpenEdgeMap map(0.05);
  map.read(model.view());
  std::vector<OpenPart> parts;
  const auto all_are = [&](PartState state) {
    map.near({0, 0, 0}, 1, model.view(), parts);
    for (const OpenPart& part : parts) map.set(part, state);
  };
  all_are(PartState::done);
  EXPECT_FALSE(map.any_wanted({0, 0, 0}, 1));
  EXPECT_TRUE(map.insist());
  EXPECT_TRUE(map.any_wanted({0, 0, 0}, 1));
  all_are(PartState::done);
  EXPECT_FALSE(map.insist());
}

}  // namespace
}  // namespace limpet::following::internal
