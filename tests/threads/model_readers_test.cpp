// Copyright the limpet authors. GPL-3.0-or-later.
//
// What a const Model is asked, by several threads at once.
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
  for (const auto n : {c.points, c.refused, c.expired, c.loose, c.sets, c.point_segments, c.polygons, c.holes,
                       c.edges, c.shared_edges, c.redundant_by_count, c.redundant_by_position})
    answer.push_back(static_cast<double>(n));
  return answer;
}

void expect_readers_agree(const Model& model) {
  threads::expect_same_answers({[&] { return open_edges(model); }, [&] { return record(model); },
                                [&] { return surfaces(model); }, [&] { return counts(model); }});
}

/// In the middle of a stream, with much still to do, and at its end.
TEST(ModelReaders, OfACity) {
  const testing::Scan scan =
      testing::scanned("city:4", 6000, 0.0005, simulation::ScanOptions::Order::shuffled);
  Model model(scan.parameters);
  testing::feed(model, scan.points);
  expect_readers_agree(model);
  model.finish();
  ASSERT_GT(model.counts().shared_edges, 0);
  ASSERT_FALSE(model.open_edges().empty());
  expect_readers_agree(model);
}

}  // namespace
}  // namespace limpet::model
