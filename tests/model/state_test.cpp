// Copyright the limpet authors. GPL-3.0-or-later.
//
// state() is all there is: a model that goes on from it cannot be told from one that was never stopped.
#include <gtest/gtest.h>

#include <limpet/model/digest.hpp>

#include "random_streams.hpp"

namespace limpet::model {
namespace {

using namespace testing;

/// How many streams each test reads: LIMPET_STREAMS, else 100.
const std::uint64_t kStoredStreams = wanted("LIMPET_STREAMS", 100);

bool same_all(const std::vector<Change>& a, const std::vector<Change>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Change& x, const Change& y) {
    return x.kind == y.kind && x.first == y.first && x.second == y.second && x.result == y.result &&
           std::ranges::equal(x.edges, y.edges);
  });
}

/// A model, and one that is put away and taken out again now and then.
class Twins {
 public:
  Twins(const Parameters& parameters, std::uint64_t seed) : kept_(parameters), random_(seed ^ 0x7477696e) {
    stopped_.emplace(parameters);
    if (random_.below(2)) kept_.keep_labels(), stopped_->keep_labels();
  }

  void add_initial(std::span<const InitialFace> faces) {
    kept_.add_initial(faces);
    stopped_->add_initial(faces);
    look();
  }
  void update(const Points& set) {
    if (random_.below(3) == 0) stop();
    const bool same_changes = same_all(kept_.update(set), stopped_->update(set));
    ASSERT_TRUE(same_changes);
    look();
  }
  void finish() {
    if (random_.below(2) == 0) stop();
    const bool same_changes = same_all(kept_.finish(), stopped_->finish());
    ASSERT_TRUE(same_changes);
    look();
  }
  /// Ends early, somewhere.
  void begin_to_finish() {
    const std::uint64_t asks = random_.below(1'000);
    std::uint64_t kept = 0, stopped = 0;
    const bool same_changes = same_all(kept_.finish([&] { return ++kept > asks; }),
                                       stopped_->finish([&] { return ++stopped > asks; }));
    ASSERT_TRUE(same_changes);
    look();
  }
  /// All that can be asked of the two is the same.
  void expect_same_answers() {
    stop();
    EXPECT_EQ(bytes(kept_.record()), bytes(stopped_->record()));
    EXPECT_EQ(kept_.labels(), stopped_->labels());
    EXPECT_EQ(kept_.surfaces(), stopped_->surfaces());
    EXPECT_EQ(kept_.counts().shared_edges, stopped_->counts().shared_edges);
    const auto open = kept_.open_edges(), open_too = stopped_->open_edges();
    EXPECT_TRUE(std::equal(open.begin(), open.end(), open_too.begin(), open_too.end(),
                           [](const OpenEdge& a, const OpenEdge& b) {
                             return a.segment == b.segment && a.edge == b.edge && a.refusal == b.refusal;
                           }));
  }
  const Model& kept() const { return kept_; }

 private:
  void stop() {
    const std::string state = stopped_->state();
    stopped_.reset();
    stopped_.emplace(Model::from_state(state));
  }
  void look() { ASSERT_TRUE(kept_.state() == stopped_->state()); }

  Model kept_;
  std::optional<Model> stopped_;
  Random random_;
};

void expect_same_ever_after(const Parameters& parameters, const std::vector<Points>& sets,
                            std::uint64_t seed) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Twins twins(parameters, seed);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    SCOPED_TRACE("set " + std::to_string(i));
    twins.update(sets[i]);
    if (::testing::Test::HasFatalFailure()) return;
    if (i == sets.size() / 3) twins.begin_to_finish();
    if (i == sets.size() / 2) twins.finish();  // points may follow all the same
    if (::testing::Test::HasFatalFailure()) return;
  }
  twins.finish();
  twins.expect_same_answers();
}

TEST(State, OfAnyStreamIsGoneOnFromToTheBit) {
  for (std::uint64_t seed = 1; seed <= kStoredStreams && !HasFailure(); ++seed) {
    const Stream stream = random_stream(seed);
    expect_same_ever_after(stream.parameters, stream.sets, seed);
  }
}

std::vector<Points> in_sets(const Points& points, std::size_t size) {
  std::vector<Points> sets;
  for (std::size_t i = 0; i < points.size(); i += size)
    sets.emplace_back(points.begin() + static_cast<std::ptrdiff_t>(i),
                      points.begin() + static_cast<std::ptrdiff_t>(std::min(points.size(), i + size)));
  return sets;
}

/// Long perimeters with an index, shared edges and corners, reliefs, holes, redundant segments.
TEST(State, OfSolidsIsGoneOnFromToTheBit) {
  std::uint64_t seed = 1;
  for (const char* shape : {"cube", "step_hole", "plate3", "open_box", "city:2", "room:2"})
    for (const auto order :
         {simulation::ScanOptions::Order::raster, simulation::ScanOptions::Order::shuffled})
      for (const double noise : {0.0, 0.002}) {
        const Scan scan = scanned(shape, 6'000, noise, order, ++seed);
        SCOPED_TRACE(shape);
        expect_same_ever_after(scan.parameters, in_sets(scan.points, 100), seed);
        if (HasFailure()) return;
      }
}

TEST(State, OfToleranceAndGrowingNoiseIsGoneOnFromToTheBit) {
  Scan scan = scanned("step_hole", 6'000, 0.004, simulation::ScanOptions::Order::raster, 3);
  scan.parameters.tolerance = scan.parameters.resolution / 3;
  scan.parameters.noise_per_range = 1e-4;
  scan.parameters.outlier_patience = 1'000;
  expect_same_ever_after(scan.parameters, in_sets(scan.points, 26), 5);
}

TEST(State, OfInitialFacesIsGoneOnFromToTheBit) {
  Random random(4);
  Twins twins(of_resolution(0.1), 4);
  const InitialFace ground{{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}}};
  twins.add_initial({&ground, 1});
  Points wall = plate(random, 3'000, 0, 0, 2, 1);
  for (auto& p : wall) p = {{p.position.x(), 0, p.position.y()}, {0, -1, 0}};
  for (const auto& p : plate(random, 1'000, 0, 0, 2, 2)) wall.push_back(p);
  shuffle(wall, random);
  for (const Points& set : in_sets(wall, 60)) twins.update(set);
  twins.finish();
  twins.expect_same_answers();
  EXPECT_GT(twins.kept().counts().shared_edges, 0);
  EXPECT_GT(twins.kept().counts().confirmed, 900);
}

TEST(State, IsTheSameForTheSameModel) {
  const Scan scan = scanned("cube", 3'000, 0.001, simulation::ScanOptions::Order::shuffled);
  EXPECT_EQ(modelled(scan.parameters, scan.points).state(), modelled(scan.parameters, scan.points).state());
}

TEST(State, OfAnEmptyModelIsOne) {
  const Model model(of_resolution(0.1));
  EXPECT_EQ(Model::from_state(model.state()).state(), model.state());
}

std::string some_state(bool labels) {
  const Scan scan = scanned("L", 4'000, 0.001, simulation::ScanOptions::Order::raster);
  Model model(scan.parameters);
  if (labels) model.keep_labels();
  feed(model, {scan.points.begin(), scan.points.begin() + 3'000});
  return model.state();
}

TEST(State, CutShortIsRefused) {
  const std::string state = some_state(true);
  for (std::size_t size = 0; size < state.size(); size += size < 400 ? 1 : 97)
    EXPECT_THROW(Model::from_state(std::string_view(state).substr(0, size)), std::invalid_argument) << size;
  EXPECT_THROW(Model::from_state(state + '\0'), std::invalid_argument);
}

TEST(State, WithABitTurnedIsRefused) {
  const std::string state = some_state(true);
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    std::string damaged = state;
    const auto at = random.below(state.size());
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << random.below(8)));
    EXPECT_THROW(Model::from_state(damaged), std::invalid_argument) << "byte " << at;
  }
}

/// With a digest that fits, whatever the damage: refused, or a model that can be asked for its record.
TEST(State, DamagedOnPurposeIsNoCrash) {
  constexpr std::size_t kDigest = 8;
  const std::uint64_t attempts = wanted("LIMPET_MUTATIONS", 3'000);
  const std::string state = some_state(false);
  std::uint64_t refused = 0, sound = 0;
  Random random(8);
  for (std::uint64_t i = 0; i < attempts; ++i) {
    std::string damaged = state.substr(0, state.size() - kDigest);
    for (auto k = 1 + random.below(3); k > 0; --k) {
      const auto at = random.below(damaged.size());
      const auto kind = random.below(4);
      if (kind == 0) damaged[at] = static_cast<char>(random.below(256));
      if (kind == 1) damaged[at] = static_cast<char>(damaged[at] ^ (1 << random.below(8)));
      if (kind == 2) damaged.replace(at, 8, 8, static_cast<char>(random.below(2) ? 0 : 0xff));
      if (kind == 3) damaged.erase(at, 1 + random.below(16));
      if (damaged.empty()) damaged = "x";
    }
    Digest digest;
    digest.add(std::string_view(damaged));
    for (std::size_t b = 0; b < kDigest; ++b) damaged += static_cast<char>(digest.value() >> (8 * b));
    try {
      const Model model = Model::from_state(damaged);
      sound += broken_laws(model.record()).empty();
    } catch (const std::invalid_argument&) {
      ++refused;
    }
  }
  RecordProperty("refused", std::to_string(refused));
  RecordProperty("sound", std::to_string(sound));
  EXPECT_GT(refused, attempts / 4);
  EXPECT_GT(sound, 0u);
}

TEST(State, OfSomethingElseIsRefused) {
  for (const std::string bytes : {"", "limpet", "limpet 1\n", "limpet model state 2 exact\n",
                                  "limpet model state 1 exact\n", "limpet model state 1 wrong\n12345678",
                                  "limpet model state 3 exact\n", "limpet model state 3 wrong\n12345678"})
    EXPECT_THROW(Model::from_state(bytes), std::invalid_argument) << bytes;
}

}  // namespace
}  // namespace limpet::model
