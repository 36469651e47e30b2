// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>

#include <gtest/gtest.h>

#include <limpet/model/spatial_index_internal.hpp>
#include <limpet/survey/random.hpp>

namespace limpet::model {
namespace {

using survey::Random;

/// Boxes of all sizes, some of no extent, on few different coordinates so that many touch.
Box3 random_box(Random& random, double scale, const Eigen::Vector3d& about) {
  Eigen::Vector3d low, size;
  for (int i = 0; i < 3; ++i) {
    low[i] = scale * static_cast<double>(random.below(20));
    size[i] = scale * static_cast<double>(random.below(random.below(4) ? 3 : 20));
  }
  return {about + low, about + low + size};
}

void compare_with_brute_force(std::uint64_t seed, double scale, const Eigen::Vector3d& about) {
  Random random(seed);
  SpatialIndex index;
  std::vector<std::pair<Box3, std::uint32_t>> stored;
  std::vector<std::uint32_t> found{99};  // left over from before: must be cleared
  std::uint32_t next = 0;
  for (int round = 0; round < 2000; ++round) {
    if (stored.empty() || random.below(3)) {
      stored.emplace_back(random_box(random, scale, about), next++);
      index.insert(stored.back().first, stored.back().second);
    } else {
      std::swap(stored[random.below(stored.size())], stored.back());
      index.remove(stored.back().first, stored.back().second);
      stored.pop_back();
    }
    ASSERT_EQ(index.size(), stored.size());
    if (round % 4) continue;
    const Box3 asked = random_box(random, scale, about);
    index.query(asked, found);
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> expected;
    for (const auto& [box, slot] : stored)
      if (box.intersects(asked)) expected.push_back(slot);
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(found, expected) << "seed " << seed << " round " << round;
    std::vector<std::uint32_t> by_box, by_point;
    index.query(Box3(asked.min(), asked.min()), by_box);
    index.query(asked.min(), by_point);
    std::sort(by_box.begin(), by_box.end());
    std::sort(by_point.begin(), by_point.end());
    ASSERT_EQ(by_point, by_box) << "seed " << seed << " round " << round;
  }
}

TEST(SpatialIndex, FindsWhatBruteForceFinds) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) compare_with_brute_force(seed, 1, {0, 0, 0});
}

TEST(SpatialIndex, FarFromTheOriginToo) { compare_with_brute_force(6, 0x1p-10, {1e6, -1e6, 1e3}); }

TEST(SpatialIndex, TouchingIsMeeting) {
  SpatialIndex index;
  index.insert({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1)}, 4);
  std::vector<std::uint32_t> found;
  index.query(Box3(Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, 1, 1)), found);
  EXPECT_EQ(found, std::vector<std::uint32_t>{4});
  index.query(Box3(Eigen::Vector3d(1.001, 1, 1), Eigen::Vector3d(2, 2, 2)), found);
  EXPECT_TRUE(found.empty());
}

TEST(SpatialIndex, SameBoxOfManySlots) {
  SpatialIndex index;
  const Box3 box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1));
  for (std::uint32_t slot = 0; slot < 100; ++slot) index.insert(box, slot);
  for (std::uint32_t slot = 0; slot < 100; slot += 2) index.remove(box, slot);
  std::vector<std::uint32_t> found;
  index.query(box, found);
  std::sort(found.begin(), found.end());
  ASSERT_EQ(found.size(), 50u);
  for (std::uint32_t i = 0; i < 50; ++i) EXPECT_EQ(found[i], 2 * i + 1);
}

}  // namespace
}  // namespace limpet::model
