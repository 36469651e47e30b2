// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include "any_case.hpp"

namespace limpet::cases {
namespace {

std::vector<std::uint8_t> some_bytes(std::uint64_t seed, std::size_t count) {
  shapes::Random random(seed);
  std::vector<std::uint8_t> bytes(count);
  for (auto& b : bytes) b = static_cast<std::uint8_t>(random.whole(0, 255));
  return bytes;
}

TEST(CaseText, OfAPerimeterReadsBack) {
  std::size_t steps = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const auto bytes = some_bytes(seed, 1000);
    PerimeterCase c;
    broken_law_of_script(bytes, c, [](const PerimeterCase&) {});
    c.law = "area";
    const std::string text = to_text(c);
    EXPECT_EQ(to_text(perimeter_case(text)), text) << "seed " << seed;
    steps += c.steps.size();
  }
  EXPECT_GT(steps, 100u);
}

TEST(CaseText, OfAStreamReadsBackToTheBit) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const StreamCase c = stream_of(some_bytes(seed, 300));
    const std::string text = to_text(c);
    EXPECT_EQ(to_text(stream_case(text)), text) << "seed " << seed;
    EXPECT_GT(c.sets.size(), 0u);
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
