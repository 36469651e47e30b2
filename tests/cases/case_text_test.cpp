// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <cmath>

#include "any_case.hpp"

namespace limpet::cases {
namespace {

std::vector<std::uint8_t> some_bytes(std::uint64_t seed, std::size_t count) {
  shapes::Random random(seed);
  std::vector<std::uint8_t> bytes(count);
  for (auto& b : bytes) b = static_cast<std::uint8_t>(random.whole(0, 255));
  return bytes;
}

void expect_same(const Cycles& a, const Cycles& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].size(), b[i].size());
    for (std::size_t k = 0; k < a[i].size(); ++k) {
      EXPECT_EQ(a[i][k].at, b[i][k].at);
      EXPECT_EQ(a[i][k].shared, b[i][k].shared);
    }
  }
}

/// To the bit, but for which NaN it is.
void expect_same(double a, double b) {
  EXPECT_TRUE((std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b)))
      << a << " and " << b;
}

void expect_same(const model::SensorPoint& a, const model::SensorPoint& b) {
  for (int k = 0; k < 3; ++k) {
    expect_same(a.position[k], b.position[k]);
    expect_same(a.axis[k], b.axis[k]);
  }
  expect_same(a.range, b.range);
}

void expect_same(const model::Parameters& a, const model::Parameters& b) {
  expect_same(a.resolution, b.resolution);
  expect_same(a.angle_rad, b.angle_rad);
  expect_same(a.noise, b.noise);
  expect_same(a.noise_per_range, b.noise_per_range);
  expect_same(a.noise_per_range2, b.noise_per_range2);
  expect_same(a.input_quantum, b.input_quantum);
  expect_same(a.tolerance, b.tolerance);
  expect_same(a.redundancy_count, b.redundancy_count);
  expect_same(a.redundancy_ratio, b.redundancy_ratio);
  EXPECT_EQ(a.outlier_patience, b.outlier_patience);
  EXPECT_EQ(a.neighbours, b.neighbours);
  EXPECT_EQ(a.rules.to_string(), b.rules.to_string());
}

TEST(CaseText, OfAPerimeterReadsBack) {
  std::size_t steps = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const auto bytes = some_bytes(seed, 1000);
    PerimeterCase c;
    broken_law_of_script(bytes, c, [](const PerimeterCase&) {});
    c.law = "area";
    const PerimeterCase read = perimeter_case(to_text(c));
    EXPECT_EQ(read.law, c.law);
    EXPECT_EQ(read.gap, c.gap);
    EXPECT_EQ(read.area_tolerance, c.area_tolerance);
    EXPECT_EQ(read.step_tolerance, c.step_tolerance);
    expect_same(read.start, c.start);
    ASSERT_EQ(read.steps.size(), c.steps.size()) << "seed " << seed;
    for (std::size_t i = 0; i < c.steps.size(); ++i) {
      EXPECT_EQ(read.steps[i].operation, c.steps[i].operation);
      if (c.steps[i].operation == Operation::extend) {
        EXPECT_EQ(read.steps[i].q, c.steps[i].q);
      }
      EXPECT_EQ(read.steps[i].all_fresh, c.steps[i].all_fresh);
      expect_same(read.steps[i].other, c.steps[i].other);
    }
    steps += c.steps.size();
  }
  EXPECT_GT(steps, 100u);
}

TEST(CaseText, OfAStreamReadsBackToTheBit) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    StreamCase c = stream_of(some_bytes(seed, 300));
    ASSERT_GT(c.sets.size(), 0u);
    c.sets[0][0].range = 1.0 / 3;
    const StreamCase read = stream_case(to_text(c));
    ASSERT_EQ(read.sets.size(), c.sets.size()) << "seed " << seed;
    for (std::size_t i = 0; i < c.sets.size(); ++i) {
      ASSERT_EQ(read.sets[i].size(), c.sets[i].size());
      for (std::size_t k = 0; k < c.sets[i].size(); ++k) expect_same(read.sets[i][k], c.sets[i][k]);
    }
    expect_same(read.parameters, c.parameters);
  }
}

TEST(CaseText, OfAFileKeepsEveryByte) {
  std::string all;
  for (int i = 0; i < 512; ++i) all += static_cast<char>(i);
  for (const std::string& bytes : {all, std::string("ply\n\\c\\x00\n|x"), std::string("\n\n"), std::string()})
    EXPECT_EQ(file_case(to_text(FileCase{"ply", bytes, "refusal"})).bytes, bytes);
}

TEST(CaseText, NamesTheLineThatIsWrong) {
  const auto message = [](std::string_view text) {
    try {
      with_case(text, [](const auto&) {});
    } catch (const CaseError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message("limpet case perimeter\ngap two\n"), "line 2: 'two' is no number");
  EXPECT_EQ(message("limpet case perimeter\npolygon\ncycle 0 0 1 0 0 1\nturn\n"),
            "line 4: 'turn' is no operation");
  EXPECT_EQ(message("limpet case nothing\n"), "line 1: there are no cases of kind 'nothing'");
  EXPECT_EQ(message("# empty\n"), "line 1: no case");
}

}  // namespace
}  // namespace limpet::cases
