// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/frontier/targets_internal.hpp>

#include "initial_model.hpp"
#include "random_places.hpp"

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;

/// The part of a face's edge in the middle of its side towards +x.
OpenPart right_side(const model::Model& model, model::SegmentId id, double x) {
  const auto edge = edge_at(model, id, {x, 0.5, 0});
  OpenPart part;
  part.edge = edge.id, part.segment = id;
  const Vector3d middle = (edge.from + edge.to) / 2, along = (edge.to - edge.from).normalized();
  part.from = middle - kLambda * along, part.to = middle + kLambda * along;
  return part;
}

struct Finder {
  PlaceMemory memory{kLambda};
  Parameters parameters = usual_parameters(kLambda);
  Outlook outlook;
  const std::vector<Target>& targets = outlook.targets;

  PartState add(const model::Model& model, const OpenPart& part) {
    outlook.clear();
    return TargetFinder(parameters, memory).add(model.view(), part, outlook);
  }
};

TEST(Targets, LieOutsideTheEdgeOnThePlane) {
  const model::Model model = initial_model({{rectangle(0, 0, 1, 1)}});
  Finder finder;
  EXPECT_EQ(finder.add(model, right_side(model, segments_of(model)[0], 1)), PartState::wanted);
  ASSERT_FALSE(finder.targets.empty());
  for (const Target& target : finder.targets) {
    EXPECT_GT(target.at.x(), 1);
    EXPECT_LT(target.at.x(), 1 + 3 * kLambda);
    EXPECT_NEAR(target.at.y(), 0.5, 1e-6);
    EXPECT_NEAR(target.at.z(), 0, 1e-6);
    EXPECT_NEAR((target.normal - Vector3d(0, 0, 1)).norm(), 0, 1e-6);
  }
}

TEST(Targets, ComeWithTheBorderThatThePartIs) {
  const model::Model model = initial_model({{rectangle(0, 0, 1, 1)}});
  OpenPart part = right_side(model, segments_of(model)[0], 1);
  Finder finder;
  const auto border = [&] {
    finder.add(model, part);
    EXPECT_EQ(finder.outlook.borders.size(), 1u);
    const Border found = finder.outlook.borders.at(0);
    EXPECT_EQ(found.from, part.from);
    EXPECT_EQ(found.to, part.to);
    EXPECT_NEAR((found.outward - Vector3d(1, 0, 0)).norm(), 0, 1e-6);
    EXPECT_NEAR((found.normal - Vector3d(0, 0, 1)).norm(), 0, 1e-6);
    return found;
  };
  EXPECT_TRUE(border().goes_on);
  const Target first = finder.targets.at(0);
  for (int i = 0; i < PlaceMemory::kEmpty; ++i) finder.memory.note_empty(first.at, first.normal);
  EXPECT_FALSE(border().goes_on) << "the surface is expected folded round the edge";
  part.closes = true;
  EXPECT_FALSE(border().goes_on);
  EXPECT_TRUE(finder.targets.empty()) << "what would close is left";
}

TEST(Targets, EndAtThePlaneOfAWall) {
  const Cycle wall{{1.02, 0, 0}, {1.02, 0, 1}, {1.02, 1, 1}, {1.02, 1, 0}};  // faces −x
  const model::Model model = initial_model({{rectangle(0, 0, 1, 1)}, {wall}});
  Finder finder;
  EXPECT_EQ(finder.add(model, right_side(model, segments_of(model)[0], 1)), PartState::done);
  EXPECT_TRUE(finder.targets.empty());
}

TEST(Targets, FoldRoundAnEdgeBeyondWhichThereIsNothing) {
  const model::Model model = initial_model({{rectangle(0, 0, 1, 1)}});
  const OpenPart part = right_side(model, segments_of(model)[0], 1);
  Finder finder;
  double lowest = 2;
  for (int fold = 0; fold < 4; ++fold) {
    ASSERT_EQ(finder.add(model, part), PartState::wanted) << "fold " << fold;
    const Target target = finder.targets.front();
    EXPECT_LT(target.normal.z(), lowest);
    EXPECT_NEAR((target.at - part.middle()).norm(), 0.85 * kLambda, 1e-6);
    EXPECT_NEAR((target.at - part.middle()).dot(target.normal), 0, 1e-6);
    lowest = target.normal.z() - 0.1;
    for (int i = 0; i < PlaceMemory::kEmpty; ++i) finder.memory.note_empty(target.at, target.normal);
  }
  EXPECT_EQ(finder.add(model, part), PartState::unclosable) << "all folds are empty";
}

TEST(Targets, AreGivenUpByPlace) {
  const model::Model model = initial_model({{rectangle(0, 0, 1, 1)}});
  const OpenPart part = right_side(model, segments_of(model)[0], 1);
  Finder finder;
  finder.add(model, part);
  const Target target = finder.targets.front();
  for (int i = 0; i < PlaceMemory::kBlocked; ++i) finder.memory.note_blocked(target.at, target.normal);
  EXPECT_EQ(finder.add(model, part), PartState::unreachable);
  EXPECT_TRUE(finder.targets.empty());
}

TEST(Targets, AreGivenUpWhenAimedAtForTooLong) {
  const model::Model model = initial_model({{rectangle(0, 0, 1, 1)}});
  const OpenPart part = right_side(model, segments_of(model)[0], 1);
  Finder finder;
  for (int i = 0; i < PlaceMemory::kAimed; ++i) {
    ASSERT_EQ(finder.add(model, part), PartState::wanted) << "step " << i;
    const Target target = finder.targets.at(0);
    finder.memory.note_aimed(target.at, target.normal);
  }
  EXPECT_EQ(finder.add(model, part), PartState::unreachable);
}

TEST(Targets, AreInsistedOnThoughThereIsAWall) {
  const Cycle wall{{1.02, 0, 0}, {1.02, 0, 1}, {1.02, 1, 1}, {1.02, 1, 0}};  // faces −x
  const model::Model model = initial_model({{rectangle(0, 0, 1, 1)}, {wall}});
  OpenPart part = right_side(model, segments_of(model)[0], 1);
  part.insist = true;
  Finder finder;
  EXPECT_EQ(finder.add(model, part), PartState::wanted);
  ASSERT_EQ(finder.targets.size(), 1u);
  EXPECT_LT((finder.targets[0].at - part.middle()).norm(), kLambda);
}

TEST(Targets, SurroundAPointSegment) {
  model::Model model(model::Parameters{});
  model.update(std::vector<model::SensorPoint>{{{0, 0, 0}, {0, 0, -1}, 0.1}});
  const PlaceMemory memory(kLambda);
  std::vector<Target> targets;
  TargetFinder(usual_parameters(kLambda), memory)
      .add_around_point(model.view(), {0, 0, 0}, {0, 0, 0.1}, targets);
  ASSERT_EQ(targets.size(), 4u);
  for (const Target& target : targets) EXPECT_NEAR(target.at.norm(), kLambda / 2, 1e-9);
  targets.clear();
  TargetFinder(usual_parameters(kLambda), memory)
      .add_around_point(model.view(), {0, 0, 0}, {0, 0, 0}, targets);
  EXPECT_TRUE(targets.empty()) << "it is not known which way it faces";
}

/// What could not be aimed at was not looked at in vain: it is out of reach, and may be reached otherwise.
TEST(Targets, WhatIsInsistedOnAndBlockedIsUnreachableNotUnclosable) {
  const model::Model model = initial_model({{rectangle(0, 0, 1, 1)}});
  OpenPart part = right_side(model, segments_of(model)[0], 1);
  part.insist = true;
  Finder blocked, failed;
  for (int i = 0; i < 100 && blocked.add(model, part) == PartState::wanted; ++i)
    blocked.memory.note_blocked(blocked.targets.back().at, blocked.targets.back().normal);
  EXPECT_EQ(blocked.add(model, part), PartState::unreachable);
  for (int i = 0; i < 100 && failed.add(model, part) == PartState::wanted; ++i)
    failed.memory.note_failed(failed.targets.back().at, failed.targets.back().normal);
  EXPECT_EQ(failed.add(model, part), PartState::unclosable);
}

}  // namespace
}  // namespace limpet::following::internal
