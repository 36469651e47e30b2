// Copyright the limpet authors. GPL-3.0-or-later.
//
// The numbered laws of view.hpp, by many questions about models of all kinds. LIMPET_VIEW_QUESTIONS says how
// many are asked of scans (10⁴), LIMPET_CASES of how many streams.
#include <thread>

#include "../expect_law.hpp"
#include "../generators/streams.hpp"
#include "random_streams.hpp"
#include "solids.hpp"
#include "view_questions.hpp"

namespace limpet::model {
namespace {

using namespace testing;

/// What is wrong with the answers to so many questions; the first thing.
std::string ask_many(const Asked& asked, std::uint64_t seed, std::uint64_t count) {
  Random random(seed);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string wrong = judge(asked, any_question(asked.truth, random));
    if (!wrong.empty())
      return wrong + " (question " + std::to_string(i) + ", seed " + std::to_string(seed) + ")";
  }
  return {};
}

Model after(const properties::Stream& stream) {
  Model model(stream.parameters);
  for (const auto& set : stream.sets) model.update(set);
  return model;
}

TEST(ViewLaws, TheBestOfAllSegmentsAndRightToRoundingOnAnyStream) {
  properties::expect_law("View (1) (2)", 100, [] {
    const properties::Stream stream = *properties::streams();
    const auto seed = static_cast<std::uint64_t>(properties::whole(1, 1'000'000));
    Model model = after(stream);
    RC_ASSERT(ask_many(Asked(model), seed, 30) == "");
    model.finish();
    RC_ASSERT(ask_many(Asked(model), seed, 30) == "");
  });
}

TEST(ViewLaws, TheBestOfAllSegmentsOnDegenerateScansBetweenTheirSets) {
  const std::uint64_t wanted_questions = wanted("LIMPET_VIEW_QUESTIONS", 10'000);
  std::uint64_t asked = 0;
  for (std::uint64_t seed = 1; asked < wanted_questions; ++seed) {
    Random random(seed);
    const Stream stream = random_stream(random, 150 + static_cast<int>(random.below(500)));
    Model model(stream.parameters);
    const std::uint64_t each = 20;
    for (std::size_t i = 0; i < stream.sets.size(); ++i) {
      model.update(stream.sets[i]);
      if (i % 16 != 15) continue;
      ASSERT_EQ(ask_many(Asked(model), seed + i, each), "") << "stream " << seed << ", set " << i;
      asked += each;
    }
    model.finish();
    ASSERT_EQ(ask_many(Asked(model), seed, 5 * each), "") << "stream " << seed << ", finished";
    asked += 5 * each;
  }
}

/// With faces known beforehand among them, that tilt against what is scanned.
TEST(ViewLaws, TheBestOfAllSegmentsOnSolids) {
  const std::uint64_t each = wanted("LIMPET_VIEW_QUESTIONS", 10'000) / 50;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    const auto mesh = random_convex(random, 0.2);
    simulation::ScanOptions options;
    options.points = 8'000, options.noise = 0.002, options.seed = seed;
    options.order = simulation::ScanOptions::Order::shuffled;
    options.viewpoints = simulation::viewpoints_around(mesh, true);
    Parameters parameters = of_resolution(0.1);
    parameters.noise = options.noise;
    Model model(parameters);
    const Vector3d u = Vector3d(random.normal(), random.normal(), random.normal()).normalized(),
                   v = u.unitOrthogonal();
    const std::vector<InitialFace> faces{{{{2 * u, 2 * u + v, 2 * u + v + u.cross(v)}}},
                                         {{{Vector3d(-3, -3, -2), Vector3d(3, -3, -2), Vector3d(0, 3, -2)}}}};
    model.add_initial(faces);
    Points points;
    simulation::scan(mesh, options, [&](const simulation::LabelledPoint& p) { points.push_back(p.point); });
    feed(model, points);
    EXPECT_EQ(ask_many(Asked(model), seed, 3 * each), "") << "solid " << seed;
    model.finish();
    EXPECT_EQ(ask_many(Asked(model), seed, 2 * each), "") << "solid " << seed << ", finished";
  }
}

TEST(ViewLaws, ALargerReachFindsNothingFarther) {
  properties::expect_law("View (3)", 50, [] {
    const properties::Stream stream = *properties::streams();
    const auto seed = static_cast<std::uint64_t>(properties::whole(1, 1'000'000));
    const Model model = after(stream);
    const Asked asked(model);
    Random random(seed);
    for (int i = 0; i < 50; ++i) {
      const Question q = any_question(asked.truth, random);
      const auto near = asked.view.nearest(q.p, q.reach, q.which),
                 far = asked.view.nearest(q.p, 3 * q.reach, q.which);
      if (near) RC_ASSERT(far && same(*near, *far));
      if (!near && far) RC_ASSERT(far->distance > q.reach);
      if (far) RC_ASSERT(same(*far, *asked.view.nearest(q.p, far->distance, q.which)));
      const Capsule link{q.p, q.q, q.radius};
      const auto near_link = asked.view.nearest(link, q.reach, q.which),
                 far_link = asked.view.nearest(link, 3 * q.reach, q.which);
      if (near_link) RC_ASSERT(far_link && same(*near_link, *far_link));
      const auto axis = axis_of(q);
      if (!axis) continue;
      const auto near_hit = asked.view.first_hit(q.p, *axis, q.reach, q.which),
                 far_hit = asked.view.first_hit(q.p, *axis, 3 * q.reach, q.which);
      if (near_hit) RC_ASSERT(far_hit && same(*near_hit, *far_hit));
    }
  });
}

TEST(ViewLaws, TheAnswerDependsNeitherOnStorageNorOnEarlierQuestions) {
  properties::expect_law("View (4)", 50, [] {
    const properties::Stream stream = *properties::streams();
    const auto seed = static_cast<std::uint64_t>(properties::whole(1, 1'000'000));
    const Model model = after(stream), again = Model::from_state(model.state());
    const Asked asked(model), other(again);
    Random random(seed);
    std::vector<Question> questions;
    for (int i = 0; i < 50; ++i) questions.push_back(any_question(asked.truth, random));
    std::vector<std::optional<View::Nearest>> answers;
    for (const auto& q : questions) answers.push_back(asked.view.nearest(q.p, q.reach, q.which));
    for (std::size_t i = questions.size(); i-- > 0;) {
      const auto found = other.view.nearest(questions[i].p, questions[i].reach, questions[i].which);
      RC_ASSERT(found.has_value() == answers[i].has_value());
      if (found) RC_ASSERT(same(*found, *answers[i]));
    }
  });
}

TEST(ViewLaws, SeveralThreadsMayAskAtOnce) {
  const auto scan = scanned("step_hole", 20'000, 0.001, simulation::ScanOptions::Order::shuffled);
  const Model model = modelled(scan.parameters, scan.points);
  const Asked asked(model);
  std::vector<std::string> wrong(4);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < wrong.size(); ++i)
    threads.emplace_back([&, i] { wrong[i] = ask_many(asked, i, 200); });
  for (auto& thread : threads) thread.join();
  for (const auto& w : wrong) EXPECT_EQ(w, "");
}

}  // namespace
}  // namespace limpet::model
