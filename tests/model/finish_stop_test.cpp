// Copyright the limpet authors. GPL-3.0-or-later.
//
// finish() that is ended early leaves a valid model, which can be finished later.
#include <gtest/gtest.h>

#include "judged_scan.hpp"

namespace limpet::model {
namespace {

using namespace testing;

/// The scan's model before it is finished, as bytes.
std::string unfinished(const JudgedScan& scan) {
  Model model(scan.parameters);
  for (std::size_t i = 0; i < scan.points.size(); i += 26)
    model.update(std::span(scan.points).subspan(i, std::min<std::size_t>(26, scan.points.size() - i)));
  return model.state();
}

TEST(FinishStop, AtAnyMomentTheLawsHoldAndTheRestCanFollow) {
  for (const char* shape : {"cube", "step_hole", "plate3"}) {
    SCOPED_TRACE(shape);
    const JudgedScan scan = judged_shape(shape, 8'000, 0.002, Order::shuffled, 5);
    const std::string state = unfinished(scan);
    std::int64_t asks_in_all = 0;
    Model whole = Model::from_state(state);
    whole.finish([&] { return ++asks_in_all < 0; });
    ASSERT_GT(asks_in_all, 50);
    const Counts wanted = whole.counts();
    for (std::int64_t most = 0; most < asks_in_all; most += 1 + asks_in_all / 40) {
      SCOPED_TRACE("ended at " + std::to_string(most) + " of " + std::to_string(asks_in_all));
      Model model = Model::from_state(state);
      std::int64_t asks = 0, after = 0;
      model.finish([&] {
        after += asks > most;
        return ++asks > most;
      });
      ASSERT_LT(after, 100) << "it is ended soon: each loop that is left asks once";
      ASSERT_EQ(broken_laws(model.record()), "");
      ASSERT_EQ(model.counts().points, wanted.points) << "no reading is lost";
      model.finish();
      ASSERT_EQ(broken_laws(model.record()), "");
      EXPECT_EQ(model.counts().polygons, wanted.polygons);
      EXPECT_EQ(model.counts().edges == 2 * model.counts().shared_edges,
                wanted.edges == 2 * wanted.shared_edges);
    }
  }
}

TEST(FinishStop, APredicateThatNeverStopsChangesNothing) {
  const JudgedScan scan = judged_shape("step_hole", 8'000, 0.002, Order::raster, 5);
  const std::string state = unfinished(scan);
  Model one = Model::from_state(state), other = Model::from_state(state);
  one.finish();
  other.finish([] { return false; });
  EXPECT_EQ(one.state(), other.state());
}

}  // namespace
}  // namespace limpet::model
