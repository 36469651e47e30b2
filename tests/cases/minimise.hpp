// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace limpet::cases {

/// How a trial in a process of its own ended: "" all laws hold, the name of the law that broke, "crash",
/// "hang", or "invalid" where it threw. Throws std::runtime_error when there is no process to be had.
std::string verdict_aside(const std::function<std::string()>& trial, unsigned seconds);

/// The smallest case found that ends as `wanted` does: tries reductions(c), goes on from the first that still
/// does, until none does. `told` hears of each step.
template <class Case>
Case minimise(Case c, const std::string& wanted, unsigned seconds,
              const std::function<void(const Case&)>& told) {
  const auto verdict = [&](const Case& tried) {
    return verdict_aside(
        [&] {
          const auto broken = broken_law(tried);
          return broken ? broken->law : std::string();
        },
        seconds);
  };
  for (bool smaller = true; smaller;) {
    smaller = false;
    const std::string text = to_text(c);
    for (Case& candidate : reductions(c)) {
      if (to_text(candidate) == text || verdict(candidate) != wanted) continue;
      c = std::move(candidate);
      told(c);
      smaller = true;
      break;
    }
  }
  return c;
}

}  // namespace limpet::cases
