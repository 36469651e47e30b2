// Copyright the limpet authors. GPL-3.0-or-later.
//
// What once broke a law, or might: every case in tests/corpus keeps all laws.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "any_case.hpp"

namespace limpet::cases {
namespace {

std::vector<std::string> files() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(LIMPET_CORPUS))
    if (entry.path().extension() == ".case") names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string text_of(const std::string& name) {
  std::ifstream file(std::filesystem::path(LIMPET_CORPUS) / name, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class Corpus : public ::testing::TestWithParam<std::string> {};

TEST_P(Corpus, KeepsAllLaws) {
  with_case(text_of(GetParam()), [](const auto& c) {
    const auto broken = broken_law(c);
    EXPECT_FALSE(broken) << broken->law << ": " << broken->what;
  });
}

TEST_P(Corpus, SaysWhichLawItBrokeAndReadsBack) {
  with_case(text_of(GetParam()), [](const auto& c) {
    EXPECT_NE(c.law, "");
    const std::string text = to_text(c);
    with_case(text, [&](const auto& again) { EXPECT_EQ(to_text(again), text); });
  });
}

INSTANTIATE_TEST_SUITE_P(Cases, Corpus, ::testing::ValuesIn(files()), [](const auto& parameter) {
  std::string name = std::filesystem::path(parameter.param).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});

}  // namespace
}  // namespace limpet::cases
