// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include "following/run_pool.hpp"

namespace limpet::benchmarks {
namespace {

MadeRun run_of(const std::string& name, std::uint64_t seed, std::int64_t sets) {
  MadeRun run;
  run.wanted.name = name;
  run.wanted.seed = seed;
  run.figures.ended = "complete";
  run.figures.sets = sets;
  run.figures.coverage = 1;
  return run;
}

double sets_of(const RunFigures& f) { return static_cast<double>(f.sets); }

TEST(RunGroup, RunsOfOneNameAreCountedTogetherButThoseThatFailed) {
  std::vector<MadeRun> made{run_of("a", 1, 30), run_of("a", 2, 10), run_of("a", 3, 20), run_of("b", 1, 5)};
  made[3].figures.failed = "signal 11";
  const auto groups = grouped(made);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].median(sets_of), 20);
  EXPECT_EQ(groups[0].least(sets_of), 10);
  EXPECT_EQ(groups[0].most(sets_of), 30);
  EXPECT_EQ(groups[0].sum(&RunFigures::sets), 60);
  EXPECT_EQ(groups[0].share([](const RunFigures& f) { return f.sets > 15; }), "2 of 3");
  EXPECT_TRUE(groups[1].runs.empty());
  EXPECT_EQ(groups[1].share([](const RunFigures&) { return true; }), "0 of 1");
  EXPECT_EQ(groups[1].median(sets_of), 0);
}

TEST(Faults, AreToldWithNameAndSeed) {
  std::vector<MadeRun> made{run_of("a", 1, 30), run_of("a", 2, 10)};
  EXPECT_EQ(faults_text(made), "");
  made[1].figures.collisions = 2;
  made[1].figures.ended = "max-sets";
  EXPECT_EQ(faults_text(made), "a seed 2: max-sets, 2 collisions\n");
}

TEST(Spread, OfTimes) {
  std::vector<double> times;
  for (int i = 100; i >= 0; --i) times.push_back(i);
  const Spread spread = spread_of(times);
  EXPECT_EQ(spread.count, 101);
  EXPECT_EQ(spread.mean, 50);
  EXPECT_EQ(spread.median, 50);
  EXPECT_EQ(spread.p99, 99);
  EXPECT_EQ(spread.max, 100);
  EXPECT_EQ(spread_of({}).mean, 0);
}

TEST(SecondsPerSet, AreThoseOfAllThatIsDoneInThem) {
  RunFigures figures;
  figures.sets = 10;
  figures.step = spread_of(std::vector<double>(9, 100));
  figures.asking = spread_of({5000});
  figures.update = spread_of(std::vector<double>(10, 50));
  EXPECT_DOUBLE_EQ(figures.seconds_per_set(), 1e-6 * (900 + 5000 + 500) / 10);
}

}  // namespace
}  // namespace limpet::benchmarks
