// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/model/rules.hpp>
#include <limpet/survey/random.hpp>
#include <set>
#include <stdexcept>

namespace limpet::model {
namespace {

std::string message_of(std::string_view text) {
  try {
    Rules::parse(text);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

TEST(Rules, AllAreOnUnlessSaidOtherwise) {
  EXPECT_EQ(Rules{}.to_string(), joined(Rules::names()));
  EXPECT_EQ(Rules::parse("limpet").to_string(), joined(Rules::names()));
  EXPECT_EQ(Rules::thesis().to_string(), "thesis");
  EXPECT_EQ(Rules::parse("thesis").to_string(), "thesis");
}

TEST(Rules, NamesAreDifferentAndPlain) {
  const auto names = Rules::names();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  for (const auto& name : names) EXPECT_EQ(name.find_first_of(" ,-"), std::string::npos) << name;
}

TEST(Rules, EveryNameSwitchesOneRule) {
  for (const auto& name : Rules::names()) {
    EXPECT_EQ(Rules::parse(name).to_string(), name);
    std::vector<std::string> others;
    for (const auto& other : Rules::names())
      if (other != name) others.push_back(other);
    EXPECT_EQ(Rules::parse("-" + name).to_string(), joined(others));
  }
}

TEST(Rules, NamesAreThoseOfTheMembers) {
  Rules rules = Rules::thesis();
  rules.near = true, rules.holes = true;
  EXPECT_EQ(Rules::parse(rules.to_string()).to_string(), rules.to_string());
  EXPECT_TRUE(Rules::parse("near").near);
  EXPECT_FALSE(Rules::parse("near").holes);
  EXPECT_TRUE(Rules::parse("expiry").expiry);
  EXPECT_FALSE(Rules::parse("-voids").voids);
  EXPECT_TRUE(Rules::parse("-voids").promotion);
  EXPECT_FALSE(Rules::parse("-dissolve,-best").dissolve);
  EXPECT_FALSE(Rules::parse("-dissolve,-best").best);
}

TEST(Rules, WhatIsPrintedIsReadBack) {
  survey::Random random(1);
  for (int round = 0; round < 500; ++round) {
    std::vector<std::string> some;
    for (const auto& name : Rules::names())
      if (random.below(2)) some.push_back(name);
    const std::string text = some.empty() ? "thesis" : joined(some);
    EXPECT_EQ(Rules::parse(text).to_string(), text);
    // The order they are given in does not matter.
    for (std::size_t i = some.size(); i > 1; --i) std::swap(some[i - 1], some[random.below(i)]);
    if (!some.empty()) {
      EXPECT_EQ(Rules::parse(joined(some)).to_string(), text);
    }
  }
}

TEST(Rules, ErrorsNameTheUnknownRuleAndTheKnownOnes) {
  for (const std::string bad : {"frobnicate", "Near", "near ", "--near", "limpet2"}) {
    for (const std::string& text : {bad, "near," + bad, "-holes,-" + bad}) {
      const std::string message = message_of(text);
      EXPECT_NE(message.find('\''), std::string::npos) << text;
      const std::string shown = bad == "--near" ? "-near" : bad;
      EXPECT_NE(message.find(shown), std::string::npos) << text << ": " << message;
      for (const auto& name : Rules::names()) EXPECT_NE(message.find(name), std::string::npos) << message;
    }
  }
  EXPECT_NE(message_of("near,,holes").find("''"), std::string::npos);
}

}  // namespace
}  // namespace limpet::model
