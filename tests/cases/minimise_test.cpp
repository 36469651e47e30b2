// Copyright the limpet authors. GPL-3.0-or-later.
#include "minimise.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

#include "case.hpp"

namespace limpet::cases {
namespace {

/// Breaks its law when it holds both a 3 and an 8, and crashes on a 13.
struct Numbers {
  std::vector<int> values;
};

std::optional<BrokenLaw> broken_law(const Numbers& c) {
  bool three = false, eight = false;
  for (const int v : c.values) {
    if (v == 13) std::abort();
    three |= v == 3, eight |= v == 8;
  }
  if (three && eight) return BrokenLaw{"together", ""};
  return std::nullopt;
}

std::string to_text(const Numbers& c) {
  std::string text;
  for (const int v : c.values) text += std::to_string(v) + " ";
  return text;
}

std::vector<Numbers> reductions(const Numbers& c) {
  std::vector<Numbers> smaller;
  for (std::size_t i = 0; i < c.values.size(); ++i) {
    smaller.push_back(c);
    smaller.back().values.erase(smaller.back().values.begin() + static_cast<std::ptrdiff_t>(i));
  }
  smaller.push_back(c);  // no smaller at all
  return smaller;
}

TEST(Minimise, LeavesOnlyWhatBreaksTheLaw) {
  const auto least = minimise<Numbers>({{1, 3, 5, 3, 8, 2, 9}}, "together", 5, [](const Numbers&) {});
  EXPECT_EQ(least.values, (std::vector{3, 8}));
}

TEST(Minimise, TakesACrashForWhatItIs) {
  const auto least = minimise<Numbers>({{1, 3, 13, 8}}, "crash", 5, [](const Numbers&) {});
  EXPECT_EQ(least.values, std::vector{13});
}

TEST(VerdictAside, TellsCrashesAndHangsApart) {
  EXPECT_EQ(verdict_aside([] { return std::string("law"); }, 5), "law");
  EXPECT_EQ(verdict_aside([]() -> std::string { std::abort(); }, 5), "crash");
  volatile bool always = true;
  EXPECT_EQ(verdict_aside(
                [&] {
                  while (always) {
                  }
                  return std::string();
                },
                1),
            "hang");
}

}  // namespace
}  // namespace limpet::cases
