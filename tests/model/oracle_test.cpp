// Copyright the limpet authors. GPL-3.0-or-later.
//
// The promise: after every set, whatever the input, the oracle finds nothing.
#include <gtest/gtest.h>

#include "ledger.hpp"
#include "random_streams.hpp"

namespace limpet::model {
namespace {

using namespace testing;

/// How many streams each test reads: LIMPET_STREAMS, else 200.
const std::uint64_t kJudgedStreams = wanted("LIMPET_STREAMS", 200);

TEST(Oracle, FindsNothingAfterAnySetOfAnyStream) {
  for (std::uint64_t seed = 1; seed <= kJudgedStreams; ++seed) {
    const Stream stream = random_stream(seed);
    Model model(stream.parameters);
    for (std::size_t i = 0; i < stream.sets.size(); ++i) {
      model.update(stream.sets[i]);
      ASSERT_EQ(broken_laws(model.record()), "") << "seed " << seed << " set " << i;
    }
    model.finish();
    ASSERT_EQ(broken_laws(model.record()), "") << "seed " << seed << " finished";
  }
}

TEST(Changes, TellAllThatHappenedInAnyStream) {
  for (std::uint64_t seed = 1; seed <= kJudgedStreams; ++seed) {
    const Stream stream = random_stream(seed);
    Model model(stream.parameters);
    Ledger ledger;
    for (std::size_t i = 0; i < stream.sets.size(); ++i) {
      const auto& changes = model.update(stream.sets[i]);
      ASSERT_EQ(ledger.read(changes, model.record()), "") << "seed " << seed << " set " << i;
    }
    const auto& changes = model.finish();
    ASSERT_EQ(ledger.read(changes, model.record()), "") << "seed " << seed << " finished";
  }
}

TEST(Readings, AreAllAccountedForInAnyStream) {
  for (std::uint64_t seed = 1; seed <= kJudgedStreams; ++seed) {
    const Stream stream = random_stream(seed);
    Model model(stream.parameters);
    model.keep_labels();
    std::int64_t readings = 0;
    for (const auto& set : stream.sets) {
      model.update(set);
      readings += static_cast<std::int64_t>(set.size());
      const Counts counts = model.counts();
      const ModelRecord record = model.record();
      ASSERT_EQ(counts.points + counts.refused, readings) << "seed " << seed;
      ASSERT_EQ(points_in_segments(record) + counts.expired, counts.points) << "seed " << seed;
    }
    model.finish();
    const ModelRecord record = model.record();
    std::map<std::uint64_t, std::int64_t> labelled, held;
    for (const SegmentId id : model.labels()) ++labelled[id.value];
    for (const auto& s : record.point_segments) held[s.id] = s.moments.count;
    for (const auto& s : record.polygon_segments) held[s.id] = s.moments.count;
    if (record.expired + record.refused > 0) held[0] = record.expired + record.refused;
    ASSERT_EQ(labelled, held) << "seed " << seed;
  }
}

TEST(Record, OfAnyStreamIsGoneOnFrom) {
  for (std::uint64_t seed = 1; seed <= kJudgedStreams; ++seed) {
    const Stream stream = random_stream(seed);
    Model model(stream.parameters);
    const std::size_t half = stream.sets.size() / 2;
    for (std::size_t i = 0; i < half; ++i) model.update(stream.sets[i]);
    const std::string before = bytes(model.record());
    std::istringstream text(before);
    Model again(io::read_native(text, "record"));
    ASSERT_EQ(bytes(again.record()), before) << "seed " << seed;
    for (std::size_t i = half; i < stream.sets.size(); ++i) {
      again.update(stream.sets[i]);
      ASSERT_EQ(broken_laws(again.record()), "") << "seed " << seed << " set " << i;
    }
    again.finish();
    ASSERT_EQ(broken_laws(again.record()), "") << "seed " << seed << " finished";
  }
}

}  // namespace
}  // namespace limpet::model
