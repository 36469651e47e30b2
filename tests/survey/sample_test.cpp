// Copyright the limpet authors. GPL-3.0-or-later.
//
// Samples of streams: what they hold, and that copies count once.
#include <gtest/gtest.h>

#include <algorithm>
#include <limpet/survey/sample.hpp>

#include "copies.hpp"

namespace limpet::survey {
namespace {

using testing::Copies;
using Points = std::vector<model::SensorPoint>;

/// A lattice, which is hard on hashes, in a random order.
Points lattice(int side, std::uint64_t seed) {
  Points points;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
      points.push_back({Eigen::Vector3d(column, row, 0) / 64, Eigen::Vector3d::UnitZ()});
  testing::shuffle(points, seed);
  return points;
}

Sampled sample_of(const Points& points, std::size_t size) {
  Sample sample(size);
  for (const auto& point : points) sample.add(point);
  return sample.result();
}

std::vector<Eigen::Vector3d> positions(const Points& points) {
  std::vector<Eigen::Vector3d> positions;
  for (const auto& point : points) positions.push_back(point.position);
  return positions;
}

TEST(Sample, OfAStreamWithoutCopiesIsOfItsPoints) {
  const Points points = lattice(100, 1);
  const Sampled whole = sample_of(points, 20'000), part = sample_of(points, 1000);
  EXPECT_EQ(positions(whole.points), positions(points)) << "in their order";
  EXPECT_EQ(whole.weight, 1);
  EXPECT_EQ(part.points.size(), 1000u);
  EXPECT_EQ(part.weight, 10);
  EXPECT_FALSE(whole.copies_left_out);
  EXPECT_FALSE(part.copies_left_out);
  EXPECT_EQ(Sample().result().weight, 1);
  EXPECT_TRUE(Sample().result().points.empty());
}

TEST(Sample, OfAStreamWithCopiesIsOfItsPositionsInWhateverOrder) {
  const Points points = lattice(100, 2);
  for (const std::size_t size : {1000, 20'000}) {
    std::vector<Eigen::Vector3d> first;
    for (const Copies order : testing::kAllCopies) {
      const Sampled sample = sample_of(testing::thrice(points, order, 3), size);
      ASSERT_TRUE(sample.copies_left_out);
      EXPECT_EQ(sample.count, 30'000);
      auto found = positions(sample.points);
      if (first.empty()) first = found;
      EXPECT_EQ(found, first);
      const auto less = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
      };
      std::sort(found.begin(), found.end(), less);
      EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
      EXPECT_EQ(found.size(), std::min<std::size_t>(size, points.size()));
      const double places = sample.weight * static_cast<double>(found.size());
      EXPECT_NEAR(places, 10'000, size == 1000 ? 1000 : 0);
    }
  }
}

/// Places are drawn alike, however many copies each has.
TEST(Sample, IsUniformOverPositions) {
  Points points;
  for (const auto& point : lattice(200, 4)) {
    const bool is_left = point.position.x() < 200 / 64.0 / 2;
    for (int i = 0; i < (is_left ? 1 : 9); ++i) points.push_back(point);
  }
  const Points found = sample_of(points, 4000).points;
  const auto left = std::count_if(found.begin(), found.end(),
                                  [](const auto& p) { return p.position.x() < 200 / 64.0 / 2; });
  EXPECT_NEAR(static_cast<double>(left), 2000, 5 * std::sqrt(1000.0));
}

TEST(Sample, AFewCopiesChangeNothing) {
  Points points = lattice(100, 5);
  for (int i = 0; i < 300; ++i) points.push_back(points[static_cast<std::size_t>(i)]);
  EXPECT_FALSE(sample_of(points, 20'000).copies_left_out);
  EXPECT_EQ(positions(sample_of(points, 20'000).points), positions(points));
}

TEST(PositionSample, BothZerosAreOnePosition) {
  PositionSample sample(10);
  sample.add({Eigen::Vector3d(0, 1, 2), Eigen::Vector3d::UnitX()});
  sample.add({Eigen::Vector3d(-0.0, 1, 2), Eigen::Vector3d::UnitY()});
  ASSERT_EQ(sample.result().points.size(), 1u);
  EXPECT_EQ(sample.result().points[0].axis, Eigen::Vector3d::UnitX()) << "the first of them";
  sample.add({Eigen::Vector3d(1, 0, 2), Eigen::Vector3d::UnitX()});
  EXPECT_EQ(sample.result().positions, 2) << "the order of the coordinates matters";
}

TEST(PositionSample, CountsToWithinOneOverTheRootOfItsSize) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    PositionSample sample(5000);
    for (int i = 0; i < 100'000; ++i)
      sample.add({Eigen::Vector3d(random.uniform(), random.uniform(), 1), Eigen::Vector3d::UnitZ()});
    EXPECT_NEAR(sample.result().positions / 100'000, 1, 5 / std::sqrt(5000.0)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace limpet::survey
