// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/following/thesis/marks_internal.hpp>

#include "initial_model.hpp"

namespace limpet::following::internal {
namespace {

model::View::Nearest nearest(const model::View::Edge& edge) {
  model::View::Nearest found;
  found.segment = edge.segment, found.edge = edge.id;
  return found;
}

TEST(Completeness, OfASegmentIsThatOfItsEdges) {
  const auto model = initial_model({{rectangle(0, 0, 1, 1)}});
  const auto id = segments_of(model).front();
  Completeness completeness;
  bool unreachable = false;
  for (const auto& edge : edges_of(model, id)) {
    EXPECT_FALSE(completeness.is_complete(model.view(), id));
    if (unreachable)
      completeness.mark_unreachable(edge.id);
    else
      completeness.mark_unclosable(edge.id);
    unreachable = !unreachable;
  }
  EXPECT_TRUE(completeness.is_complete(model.view(), id));
  EXPECT_EQ(completeness.marks().unreachable_edges.size(), 2u);
  EXPECT_EQ(completeness.marks().unclosable_edges.size(), 2u);
}

TEST(Completeness, UnreachableThingsAreTriedOnceMoreWhenTheyComeClosest) {
  const auto model = initial_model({{rectangle(0, 0, 1, 1)}});
  const auto edge = edges_of(model, segments_of(model).front()).front();
  Completeness completeness;
  for (const bool tried_again : {true, false}) {
    completeness.mark_unreachable(edge.id);
    completeness.mark_unreachable(edge.segment);
    completeness.came_closest(nearest(edge));
    EXPECT_EQ(completeness.is_complete(edge), !tried_again);
    EXPECT_EQ(completeness.is_unreachable(edge.segment), !tried_again);
  }
}

TEST(Completeness, EdgesThatFinishingWouldCloseAreComplete) {
  model::Model model(model::Parameters{});
  // One by one: those that come together share their edges at once.
  for (const model::InitialFace& face : simulation::initial_faces(simulation::make_shape("cube")))
    model.add_initial(std::vector{face});
  const auto id = segments_of(model).front();
  Completeness completeness;
  completeness.take(Changes(model, {}));
  EXPECT_FALSE(completeness.is_complete(model.view(), id));
  EXPECT_FALSE(completeness.ask_what_would_close(model, false));  // too soon
  EXPECT_TRUE(completeness.ask_what_would_close(model, true));
  EXPECT_TRUE(completeness.is_complete(model.view(), id));
  EXPECT_FALSE(completeness.ask_what_would_close(model, true));  // just asked
}

}  // namespace
}  // namespace limpet::following::internal
