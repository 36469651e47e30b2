// Copyright the limpet authors. GPL-3.0-or-later.
//
// Law (10) of Model: a change that is ended by an exception leaves a model that says so to whatever is asked,
// and nothing worse. Memory runs out at the nth request, for n all over a small run.
#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <utility>

#include <limpet/model/view.hpp>

#include "../model/streams.hpp"
#include "failing_new.hpp"

namespace limpet::model {
namespace {

using testing::Points;

constexpr std::size_t kSet = 200;

/// A cube, whose bottom is known beforehand.
const testing::Scan& cube_scan() {
  static const testing::Scan scan =
      testing::scanned("cube", 2500, 0.0005, simulation::ScanOptions::Order::sampled);
  return scan;
}
const std::vector<InitialFace>& bottom() {
  static const std::vector<InitialFace> faces{
      {{{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}}},
      {{{{2, 0, 0}, {2, 1, 0}, {3, 1, 0}, {3, 0, 0}}}},
  };
  return faces;
}

/// The whole run; the calls that change the model, in order.
std::vector<std::function<void(Model&)>> calls() {
  std::vector<std::function<void(Model&)>> all;
  all.push_back([](Model& m) { m.keep_labels(); });
  all.push_back([](Model& m) { m.add_initial(bottom()); });
  const Points& points = cube_scan().points;
  for (std::size_t i = 0; i < points.size(); i += kSet)
    all.push_back([i, &points](Model& m) {
      m.update(std::span(points).subspan(i, std::min(kSet, points.size() - i)));
    });
  all.push_back([](Model& m) { m.finish(); });
  return all;
}

template <class Call>
bool is_refused(Call&& call) {
  try {
    call();
  } catch (const ModelUnusable&) {
    return true;
  }
  return false;
}

/// Every public call there is, but those that are promised.
void expect_unusable(Model& m) {
  const Points one{{{0.5, 0.5, 2}, {0, 0, -1}, 0}};
  EXPECT_TRUE(is_refused([&] { m.add_initial(bottom()); }));
  EXPECT_TRUE(is_refused([&] { m.update(one); }));
  EXPECT_TRUE(is_refused([&] { m.update({}); }));
  EXPECT_TRUE(is_refused([&] { m.finish(); }));
  EXPECT_TRUE(is_refused([&] { m.parameters(); }));
  EXPECT_TRUE(is_refused([&] { m.counts(); }));
  EXPECT_TRUE(is_refused([&] { m.record(); }));
  EXPECT_TRUE(is_refused([&] { m.view(); }));
  EXPECT_TRUE(is_refused([&] { m.state(); }));
  EXPECT_TRUE(is_refused([&] { m.surfaces(); }));
  EXPECT_TRUE(is_refused([&] { m.now({1}); }));
  EXPECT_TRUE(is_refused([&] { m.would_finish(); }));
  EXPECT_TRUE(is_refused([&] { m.open_edges(); }));
  EXPECT_TRUE(is_refused([&] { m.keep_labels(); }));
  EXPECT_TRUE(is_refused([&] { m.labels(); }));
  EXPECT_TRUE(is_refused([&] { m.measure_stages(); }));
  EXPECT_TRUE(is_refused([&] { m.stage_times(); }));
}

/// Calls with memory for `requests` requests. Whether it succeeded.
bool succeeds(const std::function<void(Model&)>& call, Model& model, std::int64_t requests) {
  memory::fail_from(requests);
  bool done = true;
  try {
    call(model);
  } catch (const std::bad_alloc&) {
    done = false;
  }
  memory::relent();
  return done;
}

/// Tries a call on copies of the model with every kth number of requests. How many there are in all.
std::int64_t try_call(const std::function<void(Model&)>& call, const std::string& before,
                      std::uint64_t every) {
  Model whole = Model::from_state(before);
  memory::fail_from(std::numeric_limits<std::int64_t>::max());
  call(whole);
  const std::int64_t requests = memory::relent();
  const std::string after = whole.state();
  for (std::int64_t n = 0; n < requests; n += static_cast<std::int64_t>(every)) {
    SCOPED_TRACE("request " + std::to_string(n) + " of " + std::to_string(requests));
    Model model = Model::from_state(before);
    if (succeeds(call, model, n)) {
      EXPECT_EQ(model.state(), after);  // done without
      continue;
    }
    expect_unusable(model);
    Model moved = std::move(model);
    expect_unusable(moved);
    moved = Model::from_state(before);  // usable again
    if (n % 64 == 0) {
      call(moved);
      EXPECT_EQ(moved.state(), after);
    }
  }
  return requests;
}

TEST(OutOfMemory, AChangeIsMadeOrTheModelSaysThatItIsUnusable) {
  // LIMPET_EVERY=1 tries all of them.
  const std::uint64_t every = testing::wanted("LIMPET_EVERY", 97);
  Model model(cube_scan().parameters);
  std::int64_t requests = 0;
  for (const auto& call : calls()) {
    requests += try_call(call, model.state(), every);
    call(model);
    if (HasFatalFailure()) return;
  }
  std::printf("every %llu. of %lld requests for memory\n", static_cast<unsigned long long>(every),
              static_cast<long long>(requests));
  EXPECT_GT(requests, 1000);
  EXPECT_GE(model.counts().polygons, 6);
}

/// What changes nothing leaves the model as it is when it cannot be done.
TEST(OutOfMemory, AQuestionThatFailsChangesNothing) {
  const std::uint64_t every = testing::wanted("LIMPET_EVERY", 97);
  Model model(cube_scan().parameters);
  for (const auto& call : calls()) call(model);
  const std::string before = model.state();
  const std::function<void(Model&)> questions[] = {
      [](Model& m) { m.record(); },
      [](Model& m) { m.state(); },
      [](Model& m) { m.open_edges(); },
      [](Model& m) { m.surfaces(); },
      [](Model& m) { m.labels(); },
      [](Model& m) { m.would_finish(); },
      [](Model& m) { Model::from_state(m.state()); },
      [](Model& m) { Model again(m.record()); },
  };
  for (const auto& question : questions) {
    memory::fail_from(std::numeric_limits<std::int64_t>::max());
    question(model);
    const std::int64_t requests = memory::relent();
    for (std::int64_t n = 0; n < requests; n += static_cast<std::int64_t>(every)) {
      EXPECT_FALSE(succeeds(question, model, n) && n == 0);
      if (n % 16 == 0) {
        ASSERT_EQ(model.state(), before);
      }
    }
  }
  ASSERT_EQ(model.state(), before);
}

TEST(OutOfMemory, ARefusedFaceLeavesTheModelUsable) {
  Model model(cube_scan().parameters);
  const std::vector<InitialFace> faces{bottom()[0], {{{{0, 0, 0}, {1, 0, 0}}}}};
  EXPECT_THROW(model.add_initial(faces), std::invalid_argument);
  EXPECT_EQ(model.counts().polygons, 1);
  model.update(cube_scan().points);
  EXPECT_EQ(testing::broken_laws(model.record()), "");
}

TEST(OutOfMemory, AModelThatWasMovedFromSaysSo) {
  Model model(cube_scan().parameters);
  Model other = std::move(model);
  expect_unusable(model);  // NOLINT: that is the question
  model = std::move(other);
  EXPECT_EQ(model.counts().sets, 0);
}

}  // namespace
}  // namespace limpet::model
