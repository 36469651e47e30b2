// Copyright the limpet authors. GPL-3.0-or-later.
//
// Of a run over an L: what is told beside it is what would have been told at the set when it was asked.
#include <gtest/gtest.h>

#include <limpet/following/frontier/closing_watch_internal.hpp>
#include <map>
#include <set>
#include <vector>

#include "simulated_run.hpp"

namespace limpet::following::internal {
namespace {

RunOptions run_over_l_shape() {
  RunOptions options;
  options.shape = "L";
  options.most_sets = 160;
  options.strategy = Strategy::frontier;
  return options;
}

std::set<std::uint64_t> closing(const model::Outcome& outcome) {
  std::set<std::uint64_t> edges;
  for (const auto& edge : outcome.edges)
    if (edge.closes) edges.insert(edge.edge.value);
  return edges;
}

TEST(FinishForecast, IsOfTheModelAsItWasWhenAsked) {
  FinishForecast forecast;
  std::set<std::uint64_t> expected;
  std::size_t open = 0;
  long set = 0, asked = 0;
  int taken = 0;
  run_following(run_over_l_shape(), [&](const Observation& seen, const Motion&) {
    ++set;
    if (forecast.is_asked() && set - asked == 7) {
      EXPECT_EQ(forecast.asked(), asked);
      const model::Outcome outcome = forecast.take();
      EXPECT_EQ(closing(outcome), expected);
      EXPECT_EQ(outcome.open_edges, open);
      EXPECT_FALSE(forecast.is_asked());
      ++taken;
    }
    if (forecast.is_asked()) return;
    const model::Outcome outcome = seen.model.would_finish();
    expected = closing(outcome), open = outcome.open_edges;
    asked = set;
    forecast.ask(seen.model, set);
  });
  EXPECT_GE(taken, 20);
}

/// The parts of the map that would close, by edge.
std::map<std::uint64_t, bool> told(OpenEdgeMap& map, const model::View& view) {
  std::vector<OpenPart> parts;
  map.near({0.5, 0.5, 0.5}, 2, view, parts);
  std::map<std::uint64_t, bool> closes;
  for (const OpenPart& part : parts) closes[part.edge.value] = part.closes;
  return closes;
}

TEST(ClosingWatch, WithinTheStepItTellsEveryTwentySets) {
  const RunOptions options = run_over_l_shape();
  OpenEdgeMap map(options.resolution);
  ClosingWatch watch(map, false);
  std::int64_t sets = 0;
  run_following(options, [&](const Observation& seen, const Motion&) {
    map.apply(seen.changes, seen.model.view());
    watch.look(seen);
    ++sets;
    EXPECT_EQ(watch.asked(), sets / 20);
    if (sets % 20 != 0) return;
    const std::set<std::uint64_t> expected = closing(seen.model.would_finish());
    for (const auto& [edge, closes] : told(map, seen.model.view()))
      EXPECT_TRUE(!closes || expected.contains(edge));
  });
}

TEST(ClosingWatch, BesideTheRunItTellsTheSameLater) {
  const RunOptions options = run_over_l_shape();
  OpenEdgeMap map(options.resolution), again(options.resolution);
  ClosingWatch watch(map, true), same(again, true);
  std::set<std::uint64_t> expected;
  std::int64_t sets = 0, times = 0;
  run_following(options, [&](const Observation& seen, const Motion&) {
    for (OpenEdgeMap* m : {&map, &again}) m->apply(seen.changes, seen.model.view());
    const bool is_due = sets % 20 == 16 && sets > 20;
    watch.look(seen), same.look(seen);
    ++sets;
    if (sets % 20 == 0) expected = closing(seen.model.would_finish());
    if (is_due) {  // 17 sets after it was asked
      ++times;
      for (const auto& [edge, closes] : told(map, seen.model.view()))
        EXPECT_TRUE(!closes || expected.contains(edge));
    }
    EXPECT_EQ(told(map, seen.model.view()), told(again, seen.model.view()));
  });
  EXPECT_GE(times, 5);
}

TEST(ClosingWatch, WhatIsKnownOfThisSetIsNotAskedAgain) {
  const RunOptions options = run_over_l_shape();
  OpenEdgeMap map(options.resolution);
  ClosingWatch watch(map, true);
  run_following(options, [&](const Observation& seen, const Motion&) {
    map.apply(seen.changes, seen.model.view());
    watch.look(seen);
    const std::int64_t before = watch.asked();
    EXPECT_TRUE(watch.look_now(seen));
    EXPECT_FALSE(watch.look_now(seen));
    watch.look_before_leaving(seen);
    EXPECT_EQ(watch.asked(), before + 1);
  });
}

}  // namespace
}  // namespace limpet::following::internal
