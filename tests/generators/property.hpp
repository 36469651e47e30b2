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

/// Tries a property on `cases` generated cases (LIMPET_CASES overrides), the same ones every time (those of
/// LIMPET_SEED, else of seed 1). Empty when it holds; else the smallest case found that breaks it, as text
/// that can be put into a test, and how to see it again.
template <class Property>
std::string check(const std::string& law, int cases, Property&& property) {
  namespace detail = rc::detail;
  struct Silent : detail::TestListener {
    void onTestCaseFinished(const detail::CaseDescription&) override {}
    void onShrinkTried(const detail::CaseDescription&, bool) override {}
    void onTestFinished(const detail::TestMetadata&, const detail::TestResult&) override {}
  } silent;
  detail::TestParams params;
  params.seed = from_environment("LIMPET_SEED", 1);
  params.maxSuccess = static_cast<int>(from_environment("LIMPET_CASES", static_cast<std::uint64_t>(cases)));
  params.maxDiscardRatio = 100;
  detail::TestMetadata metadata;
  metadata.id = metadata.description = law;
  const detail::TestResult result = detail::checkProperty(
      detail::toProperty(std::forward<Property>(property)), metadata, params, silent, {});
  if (result.template is<detail::SuccessResult>()) return {};
  std::ostringstream text;
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
