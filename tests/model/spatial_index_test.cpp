// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <array>
#include <string>

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

using Stored = std::vector<std::pair<Box3, std::uint32_t>>;

/// What any_of() names, until it is told to stop.
std::vector<std::uint32_t> visited(const SpatialIndex& index, const Box3& box) {
  std::vector<std::uint32_t> found;
  EXPECT_FALSE(index.any_of(box, [&](std::uint32_t slot) {
    found.push_back(slot);
    return false;
  }));
  EXPECT_EQ(index.any_of(box, [](std::uint32_t) { return true; }), !found.empty());
  std::sort(found.begin(), found.end());
  return found;
}

/// Walks along a ray: is every box that it meets named in the piece where it enters it?
std::string missed_by_walk(Random& random, const SpatialIndex& index, const Stored& stored, double scale,
                           const Eigen::Vector3d& from) {
  Eigen::Vector3d axis(random.normal(), random.below(4) ? random.normal() : 0, random.normal());
  axis.normalize();
  const double range = random.below(3) ? scale * random.uniform(0, 40) : 1e300;
  std::vector<std::array<double, 3>> pieces;
  index.walk({from, axis}, range, 1e-6 * scale, [&](std::uint32_t slot, double begin, double end) {
    pieces.push_back({static_cast<double>(slot), begin, end});
    return range;
  });
  for (const auto& [box, slot] : stored) {
    // Where it enters a box that is a little smaller, as what is asked for is.
    const Eigen::Vector3d less = Eigen::Vector3d::Constant(1e-3 * scale);
    double first = 0, last = range;
    for (int i = 0; i < 3; ++i) {
      double t = (box.min()[i] + less[i] - from[i]) / axis[i],
             u = (box.max()[i] - less[i] - from[i]) / axis[i];
      if (axis[i] == 0) t = box.min()[i] < from[i] && from[i] < box.max()[i] ? 0 : 1e300, u = 1e300;
      first = std::max(first, std::min(t, u)), last = std::min(last, std::max(t, u));
    }
    const bool empty = (box.sizes().array() < 4e-3 * scale).any();
    if (empty || first > last) continue;
    if (std::none_of(pieces.begin(), pieces.end(), [&, in = slot](const auto& piece) {
          return piece[0] == static_cast<double>(in) && piece[1] <= first && first < piece[2];
        }))
      return "slot " + std::to_string(slot) + " at " + std::to_string(first);
  }
  return {};
}

void compare_with_brute_force(std::uint64_t seed, double scale, const Eigen::Vector3d& about) {
  Random random(seed);
  SpatialIndex index;
  Stored stored;
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
    ASSERT_EQ(visited(index, asked), expected) << "seed " << seed << " round " << round;
    const Box3 all(Eigen::Vector3d::Constant(-1e300), Eigen::Vector3d::Constant(1e300));
    ASSERT_EQ(visited(index, all).size(), stored.size()) << "seed " << seed << " round " << round;
    ASSERT_EQ(missed_by_walk(random, index, stored, scale, asked.min()), "")
        << "seed " << seed << " round " << round;
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
