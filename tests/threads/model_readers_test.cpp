// Copyright the limpet authors. GPL-3.0-or-later.
//
// What a const Model is asked, by several threads at once.
#include <algorithm>
#include <future>
#include <limpet/model/view.hpp>
#include <limpet/survey/random.hpp>

#include "../model/streams.hpp"
#include "readers.hpp"

namespace limpet::model {
namespace {

using threads::Answer;
using threads::Question;

Answer open_edges(const Model& model) {
  Answer answer;
  for (const OpenEdge& e : model.open_edges())
    answer.insert(answer.end(), {static_cast<double>(e.segment.value), static_cast<double>(e.edge.value),
                                 static_cast<double>(e.refusal), static_cast<double>(e.other.value)});
  return answer;
}

Answer record(const Model& model) {
  const std::string text = testing::bytes(model.record());
  return {text.begin(), text.end()};
}

Answer surfaces(const Model& model) {
  Answer answer;
  for (const auto& surface : model.surfaces()) {
    answer.push_back(static_cast<double>(surface.size()));
    for (const SegmentId id : surface) answer.push_back(static_cast<double>(id.value));
  }
  return answer;
}

Answer counts(const Model& model) {
  const Counts c = model.counts();
  Answer answer;
  for (const auto n :
       {c.points, c.refused, c.expired, c.loose, c.confirmed, c.sets, c.point_segments, c.polygons, c.holes,
        c.edges, c.shared_edges, c.redundant_by_count, c.redundant_by_position})
    answer.push_back(static_cast<double>(n));
  return answer;
}

Answer labels(const Model& model) {
  Answer answer;
  for (const SegmentId id : model.labels()) answer.push_back(static_cast<double>(id.value));
  return answer;
}

Answer state(const Model& model) {
  const std::string bytes = model.state();
  return {bytes.begin(), bytes.end()};
}

Answer outcome(const Model& model) {
  Answer answer;
  for (const Outcome::Edge& e : model.would_finish().edges)
    answer.insert(answer.end(), {static_cast<double>(e.edge.value), static_cast<double>(e.closes),
                                 static_cast<double>(e.refusal)});
  return answer;
}

/// Of the window: places and links all over the model, rays through it, and every edge.
Answer view(const Model& model) {
  const View view = model.view();
  Answer answer;
  survey::Random random(7);
  std::vector<View::Edge> edges;
  view.open_edges(edges);
  for (const View::Edge& e : edges)
    answer.insert(answer.end(), {e.from.x(), e.to.y(), static_cast<double>(e.next.value)});
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d p(random.uniform(-1, 4), random.uniform(-1, 4), random.uniform(-0.5, 1.5));
    const Eigen::Vector3d axis(random.uniform(-1, 1), random.uniform(-1, 1), -1);
    if (const auto found = view.nearest(p, 5)) {
      answer.insert(answer.end(), {found->distance, static_cast<double>(found->edge.value)});
      answer.push_back(static_cast<double>(view.surface_of(found->segment).value));
    }
    if (const auto found = view.nearest(Capsule{p, p + axis, 0.05}, 5)) answer.push_back(found->distance);
    if (const auto hit = view.first_hit(p, axis, 5)) answer.push_back(hit->range);
  }
  return answer;
}

void expect_readers_agree(const Model& model) {
  threads::expect_same_answers({[&] { return open_edges(model); }, [&] { return record(model); },
                                [&] { return surfaces(model); }, [&] { return counts(model); },
                                [&] { return labels(model); }, [&] { return state(model); },
                                [&] { return view(model); }, [&] { return outcome(model); }});
}

/// In the middle of a stream, with much still to do, and at its end.
TEST(ModelReaders, OfACity) {
  const testing::Scan scan =
      testing::scanned("city:4", 6000, 0.0005, simulation::ScanOptions::Order::shuffled);
  Model model(scan.parameters);
  model.keep_labels();
  testing::feed(model, scan.points);
  expect_readers_agree(model);
  model.finish();
  ASSERT_GT(model.counts().shared_edges, 0);
  ASSERT_FALSE(model.open_edges().empty());
  expect_readers_agree(model);
}

/// A copy is asked what finishing would close while the model that it was made of goes on: neither notices.
TEST(ModelReaders, OfACopyWhileTheModelGoesOn) {
  const testing::Scan scan =
      testing::scanned("city:4", 6000, 0.0005, simulation::ScanOptions::Order::shuffled);
  Model alone(scan.parameters), with_copies(scan.parameters);
  constexpr std::ptrdiff_t kSet = 500;
  for (std::size_t first = 0; first < scan.points.size(); first += kSet) {
    const auto begin = scan.points.begin() + static_cast<std::ptrdiff_t>(first);
    const testing::Points set(begin, begin + std::min(kSet, scan.points.end() - begin));
    const Answer expected = outcome(with_copies);
    auto answer = std::async(std::launch::async,
                             [bytes = with_copies.state()] { return outcome(Model::from_state(bytes)); });
    for (Model* model : {&alone, &with_copies}) testing::feed(*model, set);
    EXPECT_EQ(answer.get(), expected);
  }
  EXPECT_EQ(record(with_copies), record(alone));
}

}  // namespace
}  // namespace limpet::model
