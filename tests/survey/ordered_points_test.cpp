// Copyright the limpet authors. GPL-3.0-or-later.
//
// A scan put in order is the same scan, in the same order however much memory there is.
#include <limpet/io/error.hpp>
#include <limpet/survey/curve.hpp>
#include <limpet/survey/key_sort_internal.hpp>
#include <limpet/survey/ordered_points.hpp>
#include <limpet/survey/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>

namespace limpet::survey {
namespace {

using Readings = std::vector<Reading>;

/// Points on a few sheets, some in dense spots, some equal, one far away.
Readings some_scan(Random& random, std::size_t count) {
  Readings scan(count);
  const double far = random.uniform() < 0.3 ? 1e9 : 10;
  for (Reading& reading : scan) {
    const double spread = random.uniform() < 0.5 ? 10 : 0.3;
    reading.point.position = {random.uniform(0, spread), random.uniform(0, spread),
                              static_cast<double>(random.below(3))};
    if (random.uniform() < 0.1) reading.point.position.setConstant(1.5);
    if (random.uniform() < 0.001) reading.point.position *= far;
    reading.point.axis = {random.uniform(), -1, 0};
    reading.point.range = random.uniform(1, 2);
    reading.skipped = static_cast<std::int64_t>(random.below(3));
  }
  return scan;
}

OrderedPoints ordered(const Readings& scan, Ordering ordering) {
  return {[&scan, next = std::size_t{0}](Reading& reading) mutable {
            if (next == scan.size()) return false;
            reading = scan[next++];
            return true;
          },
          std::move(ordering)};
}

Readings all_of(OrderedPoints points) {
  Readings all;
  for (Reading reading; points.next(reading);) all.push_back(reading);
  return all;
}

std::vector<std::int64_t> places_of(const Readings& readings) {
  std::vector<std::int64_t> places;
  for (const Reading& reading : readings) places.push_back(reading.place);
  return places;
}

TEST(OrderedPoints, AreTheScansPointsEachOnce) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Readings scan = some_scan(random, random.below(3000));
    Readings all = all_of(ordered(scan, {.cell = random.uniform(0.05, 2)}));
    ASSERT_EQ(all.size(), scan.size());
    std::sort(all.begin(), all.end(), [](const Reading& a, const Reading& b) { return a.place < b.place; });
    for (std::size_t i = 0; i < scan.size(); ++i) {
      ASSERT_EQ(all[i].place, static_cast<std::int64_t>(i));
      ASSERT_EQ(all[i].point.position, scan[i].point.position);
      ASSERT_EQ(all[i].point.axis, scan[i].point.axis);
      ASSERT_EQ(all[i].point.range, scan[i].point.range);
      ASSERT_EQ(all[i].skipped, scan[i].skipped);
    }
  }
}

TEST(OrderedPoints, ComeInTheSameOrderHoweverMuchMemoryThereIs) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Readings scan = some_scan(random, 1 + random.below(5000));
    const double cell = random.uniform(0.05, 2);
    const auto places = places_of(all_of(ordered(scan, {.cell = cell})));
    for (const std::size_t bytes : {1u << 12, 1u << 15, 1u << 18}) {
      OrderedPoints by_disk = ordered(scan, {.cell = cell, .memory_bytes = bytes});
      Readings all;
      for (Reading reading; by_disk.next(reading);) all.push_back(reading);
      ASSERT_EQ(places_of(all), places);
      ASSERT_EQ(by_disk.points(), static_cast<std::int64_t>(scan.size()));
      const std::size_t least = scan.size() * sizeof(Reading);
      const auto on_disk = static_cast<std::size_t>(by_disk.bytes_on_disk());
      ASSERT_GE(on_disk, least > bytes ? least : 0);
      ASSERT_TRUE(2 * least > bytes || on_disk == 0);
    }
  }
}

/// No cell has its second twelve readings before every cell has its first twelve, nor its third and fourth
/// before every cell has its second, and so on; and each pass goes once along the curve.
TEST(OrderedPoints, GoRoundAllCellsBeforeAnyIsFull) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Readings scan = some_scan(random, 4000);
    const double cell = random.uniform(0.2, 2);
    const Curve curve(scan.front().point.position, cell);
    std::map<std::uint64_t, std::int64_t> seen;
    std::int64_t pass = 0;
    std::uint64_t last = 0;
    for (const Reading& reading : all_of(ordered(scan, {.cell = cell}))) {
      const std::uint64_t at = curve.place(reading.point.position);
      const std::int64_t twelves = seen[at]++ / 12;
      std::int64_t due = 0;
      while (twelves >> due > 0) ++due;
      ASSERT_GE(due, pass) << "a reading of an earlier pass";
      if (due > pass) pass = due, last = 0;
      ASSERT_GE(at, last) << "back along the curve within a pass";
      last = at;
    }
  }
}

TEST(OrderedPoints, WithinACellAreNotInTheOrderOfTheScan) {
  Readings scan(8);
  const auto places = places_of(all_of(ordered(scan, {.cell = 1})));
  EXPECT_FALSE(std::is_sorted(places.begin(), places.end()));
}

TEST(OrderedPoints, SetsAreFullButForTheLast) {
  Random random(1);
  const Readings scan = some_scan(random, 100);
  OrderedPoints points = ordered(scan, {.cell = 1});
  std::vector<model::SensorPoint> set;
  std::vector<std::size_t> sizes;
  while (points.next_set(set)) sizes.push_back(set.size());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{26, 26, 26, 22}));
}

TEST(OrderedPoints, OfNoneAreNone) { EXPECT_TRUE(all_of(ordered({}, {.cell = 1})).empty()); }

TEST(OrderedPoints, AreNoneWhenReadingWasStopped) {
  const Readings scan(100);
  EXPECT_TRUE(all_of(ordered(scan, {.cell = 1, .stop = [] { return true; }})).empty());
}

TEST(OrderedPoints, SayWhenThereIsNoPlaceForTheirFiles) {
  const Readings scan(100);
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "";
  ::setenv("TMPDIR", "/nonexistent", 1);
  EXPECT_THROW(all_of(ordered(scan, {.cell = 1, .memory_bytes = 1000})), io::OutputError);
  before ? ::setenv("TMPDIR", kept.c_str(), 1) : ::unsetenv("TMPDIR");
}

TEST(Curve, InterleavesTheBitsOfTheCell) {
  Random random(1);
  const Curve curve({0, 0, 0}, 0.5);
  for (int i = 0; i < 1000; ++i) {
    std::uint64_t cell[3], place = 0;
    for (auto& c : cell) c = random.below(1 << Curve::kBits);
    for (int bit = 0; bit < Curve::kBits; ++bit)
      for (int axis = 0; axis < 3; ++axis) place |= (cell[axis] >> bit & 1) << (3 * bit + axis);
    const auto at = [&](int axis) {
      return (static_cast<double>(cell[axis]) - (1 << (Curve::kBits - 1)) + random.uniform()) * 0.5;
    };
    const double x = at(0), y = at(1), z = at(2);
    ASSERT_EQ(curve.place({x, y, z}), place);
  }
}

TEST(Curve, TakesWhatIsFarAwayIntoItsLastCells) {
  const Curve curve({0, 0, 0}, 1);
  EXPECT_EQ(curve.place({1e300, 1e300, 1e300}), (std::uint64_t{1} << (3 * Curve::kBits)) - 1);
  EXPECT_EQ(curve.place({-1e300, -1e300, -1e300}), 0u);
}

TEST(KeySort, IsAStableSort) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    std::vector<SortKey> keys(random.below(2000));
    const std::uint64_t mask = random.next() & random.next();
    for (std::uint32_t i = 0; i < keys.size(); ++i) keys[i] = {random.next() & mask, i};
    auto expected = keys;
    std::stable_sort(expected.begin(), expected.end(),
                     [](const SortKey& a, const SortKey& b) { return a.key < b.key; });
    sort_by_key(keys);
    for (std::size_t i = 0; i < keys.size(); ++i) ASSERT_EQ(keys[i].index, expected[i].index);
  }
}

}  // namespace
}  // namespace limpet::survey
