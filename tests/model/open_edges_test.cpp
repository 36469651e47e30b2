// Copyright the limpet authors. GPL-3.0-or-later.
//
// Open edges tell what refused them a neighbour (thesis §2.6, §2.7). Faces known beforehand are exactly what
// a test says they are, and leave no bay to chance.
#include <gtest/gtest.h>

#include <map>

#include "judged_scan.hpp"
#include "solids.hpp"

namespace limpet::model {
namespace {

using namespace testing;
using Loop = std::vector<Vector3d>;

constexpr double kResolution = 0.1;

Model of_faces(const std::vector<Loop>& faces) {
  Model model(of_resolution(kResolution));
  std::vector<InitialFace> initial;
  for (const Loop& loop : faces) initial.push_back({{loop}});
  model.add_initial(initial);
  model.finish();
  return model;
}

std::map<Refusal, int> refusals(const Model& model) {
  std::map<Refusal, int> count;
  for (const OpenEdge& open : model.open_edges()) ++count[open.refusal];
  return count;
}

/// z = 0, its interior on y > 0, seen from above.
const Loop kFloor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

/// What stands on the floor's edge at y = 0, leaning outwards by `degrees` from the floor's plane.
Loop leaning(double degrees) {
  const double y = -std::cos(radians(degrees)), z = std::sin(radians(degrees));
  return {{0, 0, 0}, {0, y, z}, {1, y, z}, {1, 0, 0}};
}

TEST(OpenEdges, AreAloneWhereNothingIsNear) {
  const auto open = of_faces({kFloor}).open_edges();
  ASSERT_EQ(open.size(), 4u);
  for (const OpenEdge& edge : open) {
    EXPECT_EQ(edge.refusal, Refusal::alone);
    EXPECT_FALSE(edge.other);
  }
}

TEST(OpenEdges, OfAFoldAreThoseAroundIt) {
  EXPECT_EQ(refusals(of_faces({kFloor, leaning(90)})), (std::map<Refusal, int>{{Refusal::alone, 6}}));
}

TEST(OpenEdges, TellOfAnglesBelowTheResolution) {
  // One after the other: those that come together share their edges at once, at any angle.
  Model model = of_faces({kFloor});
  model.add_initial(std::vector<InitialFace>{{{leaning(5)}}});
  EXPECT_EQ(refusals(model), (std::map<Refusal, int>{{Refusal::alone, 6}, {Refusal::angle, 2}}));
  for (const OpenEdge& open : model.open_edges())
    EXPECT_EQ(static_cast<bool>(open.other), open.refusal == Refusal::angle);
}

TEST(OpenEdges, TellOfLinesTooFarAway) {
  // Two sheets as near as 0.8 λ, whose planes meet far beyond both.
  Loop roof;
  for (const Vector3d& p : kFloor) roof.push_back({p.x(), p.y(), 0.8 * kResolution + 0.25 * p.y()});
  for (Vector3d& p : roof) p.y() += 2, p.z() += 0.4;  // the line is at y ≈ −1.6 from its edge
  Loop floor = kFloor;
  for (Vector3d& p : floor) p.y() += 1, p.z() += 0.4;
  EXPECT_EQ(refusals(of_faces({floor, roof})).count(Refusal::line_far), 1u);
}

TEST(OpenEdges, TellWhereNothingOpenLiesOpposite) {
  // A wall that stands in the middle of a floor without a hole.
  const Loop wall{{0.2, 0.5, 0}, {0.8, 0.5, 0}, {0.8, 0.5, 1}, {0.2, 0.5, 1}};
  const Model model = of_faces({kFloor, wall});
  EXPECT_EQ(refusals(model)[Refusal::nothing_opposite], 1);
  EXPECT_EQ(model.counts().shared_edges, 0);
}

TEST(OpenEdges, TellOfBays) {
  const double deep = 3 * kResolution;
  const Loop with_bay{{0, 0, 0},    {0.35, 0, 0}, {0.35, deep, 0}, {0.65, deep, 0},
                      {0.65, 0, 0}, {1, 0, 0},    {1, 1, 0},       {0, 1, 0}};
  const Model model = of_faces({with_bay, leaning(90)});
  EXPECT_EQ(model.counts().shared_edges, 2);
  EXPECT_EQ(refusals(model)[Refusal::bay], 4) << "three around the bay, and the one opposite to it";
}

/// Points of a third surface may leave a spur where it crosses the plane (rule `spurs`). What is wide goes
/// on.
TEST(OpenEdges, OfSpursGiveWayToTheLine) {
  const auto with_tab = [](double width, double depth) -> Loop {
    return {{0, 0, 0},           {0.5, 0, 0}, {0.5, -depth, 0}, {0.5 + width, -depth, 0},
            {0.5 + width, 0, 0}, {1, 0, 0},   {1, 1, 0},        {0, 1, 0}};
  };
  const double l = kResolution;
  for (const auto& [width, depth] : {std::pair(0.3 * l, 2.5 * l), std::pair(0.8 * l, 1.1 * l)}) {
    const Model model = of_faces({with_tab(width, depth), leaning(90)});
    EXPECT_EQ(model.counts().edges, 8) << width << " × " << depth;
    EXPECT_EQ(refusals(model), (std::map<Refusal, int>{{Refusal::alone, 6}}));
    EXPECT_EQ(broken_laws(model.record()), "");
  }
  const Model wide = of_faces({with_tab(1.5 * l, 2.5 * l), leaning(90)});
  EXPECT_EQ(wide.counts().shared_edges, 2);
  EXPECT_GE(refusals(wide)[Refusal::bay], 4);
}

TEST(OpenEdges, TellOfCornersCutOff) {
  const double cut = 3 * kResolution;
  const Loop along_xy{{cut, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, cut, 0}};
  Loop along_yz, along_zx;
  for (const Vector3d& p : along_xy)
    along_yz.push_back({p.z(), p.x(), p.y()}), along_zx.push_back({p.y(), p.z(), p.x()});
  const Model model = of_faces({along_xy, along_yz, along_zx});
  EXPECT_EQ(model.counts().shared_edges, 3);
  EXPECT_EQ(refusals(model)[Refusal::corner_far], 9) << "what was within λ of a line lies on it now";
  EXPECT_EQ(refusals(model)[Refusal::alone], 6);
}

/// Whatever is modelled: each open edge once, no other, and asking changes nothing.
TEST(OpenEdges, AreAllOpenEdgesOfTheRecord) {
  for (const std::string shape : {"open_box", "step_hole", "cube"}) {
    const JudgedScan scan = judged_shape(shape, 5'000, 0.002, Order::shuffled, 1, 6);
    for (const bool finished : {false, true}) {
      Model model(scan.parameters);
      feed(model, scan.points);
      if (finished) model.finish();
      const std::string before = bytes(model.record());
      std::map<std::uint64_t, std::uint64_t> told, expected;
      for (const OpenEdge& open : model.open_edges()) {
        EXPECT_TRUE(told.emplace(open.edge.value, open.segment.value).second);
        EXPECT_NE(open.other, open.segment);
        EXPECT_EQ(static_cast<bool>(open.other), open.refusal != Refusal::alone);
      }
      const ModelRecord record = model.record();
      for (const auto& s : record.polygon_segments)
        for (const auto& cycle : s.cycles)
          for (const auto& v : cycle)
            if (v.partner == 0) expected[v.edge] = s.id;
      EXPECT_EQ(told, expected) << shape;
      EXPECT_EQ(bytes(record), before);
    }
  }
}

/// The open rim of a box is alone but where it comes to a corner, whoever asks: the model, or one read from
/// its record.
TEST(OpenEdges, AreExplainedFromTheRecordAlone) {
  const JudgedScan scan = judged_shape("open_box", 6'000, 0, Order::sampled);
  const Model model = modelled(scan.parameters, scan.points);
  const auto open = model.open_edges();
  ASSERT_FALSE(open.empty());
  const auto alone = refusals(model)[Refusal::alone];
  EXPECT_GT(alone, 0.8 * static_cast<double>(open.size()));
  EXPECT_EQ(refusals(model)[Refusal::none], 0);
  const auto again = Model(model.record()).open_edges();
  ASSERT_EQ(again.size(), open.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    EXPECT_EQ(again[i].edge, open[i].edge);
    EXPECT_EQ(again[i].refusal, open[i].refusal);
  }
}

TEST(OpenEdges, AreNotExplainedWhereNeighboursAreNotAskedFor) {
  JudgedScan scan = judged_shape("cube", 2'000, 0, Order::sampled);
  scan.parameters.neighbours = false;
  EXPECT_TRUE(modelled(scan.parameters, scan.points).open_edges().empty());
}

TEST(Refusals, HaveNamesOfTheirOwn) {
  std::map<std::string, int> names;
  for (std::size_t i = 0; i < kRefusals; ++i) {
    ++names[name(static_cast<Refusal>(i))];
    ++names[words(static_cast<Refusal>(i))];
  }
  EXPECT_EQ(names.size(), 2 * kRefusals);
}

}  // namespace
}  // namespace limpet::model
