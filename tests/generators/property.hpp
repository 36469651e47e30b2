// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>

#include <rapidcheck.h>

/// Properties: laws that are tried on generated input, and small numbers to generate it from.
namespace limpet::properties {

/// As the environment says, else so much.
inline std::uint64_t from_environment(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// How many cases a law is tried on; of these at least the part `least_share` must have been classified
/// (RC_CLASSIFY), for a law that is asked of almost nothing says nothing.
struct Cases {
  Cases(int number, double least = 0) : count(number), least_share(least) {}
  int count;
  double least_share;
};

/// Tries a property on `cases` generated cases (LIMPET_CASES overrides), the same ones every time (those of
/// LIMPET_SEED, else of seed 1). Empty when it holds; else the smallest case found that breaks it, as text
/// that can be put into a test, and how to see it again; or that too few of the cases were classified.
template <class Property>
std::string check(const std::string& law, Cases cases, Property&& property) {
  namespace detail = rc::detail;
  struct Silent : detail::TestListener {
    void onTestCaseFinished(const detail::CaseDescription&) override {}
    void onShrinkTried(const detail::CaseDescription&, bool) override {}
    void onTestFinished(const detail::TestMetadata&, const detail::TestResult&) override {}
  } silent;
  detail::TestParams params;
  params.seed = from_environment("LIMPET_SEED", 1);
  params.maxSuccess =
      static_cast<int>(from_environment("LIMPET_CASES", static_cast<std::uint64_t>(cases.count)));
  params.maxDiscardRatio = 100;
  detail::TestMetadata metadata;
  metadata.id = metadata.description = law;
  const detail::TestResult result = detail::checkProperty(
      detail::toProperty(std::forward<Property>(property)), metadata, params, silent, {});
  std::ostringstream text;
  detail::SuccessResult success;
  if (result.match(success)) {
    int classified = 0;
    for (const auto& [tags, count] : success.distribution) classified += tags.empty() ? 0 : count;
    if (classified >= cases.least_share * success.numSuccess) return {};
    text << law << "\nwas tried on " << classified << " of " << success.numSuccess << " cases only\n";
    return text.str();
  }
  text << law << "\n";
  detail::printResultMessage(result, text);
  text << "\nAgain with LIMPET_SEED=" << params.seed << " LIMPET_CASES=" << params.maxSuccess << "\n";
  return text.str();
}

/// A whole number from `low` to `high`; shrinks to `low`. Small ones are tried first.
inline std::int64_t whole(std::int64_t low, std::int64_t high) {
  return *rc::gen::inRange<std::int64_t>(low, high + 1);
}
/// From -reach to reach; shrinks to 0.
inline std::int64_t about_zero(std::int64_t reach) {
  const std::int64_t k = whole(0, 2 * reach);
  return k % 2 ? (k + 1) / 2 : -(k / 2);
}
/// One of 0 to count - 1, all alike from the start; shrinks to 0.
inline int one_of(int count) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, count)); }
/// 2^low to 2^high, all alike; shrinks to 2^low.
inline double power_of_two(int low, int high) {
  double x = 1;
  for (int e = low + one_of(high - low + 1); e != 0; e += e < 0 ? 1 : -1) x *= e < 0 ? 0.5 : 2;
  return x;
}

}  // namespace limpet::properties
