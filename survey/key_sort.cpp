// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/key_sort_internal.hpp>

#include <array>
#include <numeric>

namespace limpet::survey {
namespace {

constexpr int kDigitBits = 11, kDigits = (64 + kDigitBits - 1) / kDigitBits;
constexpr std::size_t kValues = std::size_t{1} << kDigitBits;

std::size_t digit(const SortKey& key, int which) { return key.key >> (which * kDigitBits) & (kValues - 1); }

using Counts = std::array<std::size_t, kValues>;

std::vector<Counts> digit_counts(const std::vector<SortKey>& keys) {
  std::vector<Counts> counts(kDigits, Counts{});
  for (const SortKey& key : keys)
    for (int which = 0; which < kDigits; ++which)
      ++counts[static_cast<std::size_t>(which)][digit(key, which)];
  return counts;
}

}  // namespace

void sort_by_key(std::vector<SortKey>& keys) {
  if (keys.empty()) return;
  std::vector<Counts> counts = digit_counts(keys);
  std::vector<SortKey> sorted(keys.size());
  for (int which = 0; which < kDigits; ++which) {
    Counts& starts = counts[static_cast<std::size_t>(which)];
    if (starts[digit(keys.front(), which)] == keys.size()) continue;  // all have the same
    std::exclusive_scan(starts.begin(), starts.end(), starts.begin(), std::size_t{0});
    for (const SortKey& key : keys) sorted[starts[digit(key, which)]++] = key;
    keys.swap(sorted);
  }
}

}  // namespace limpet::survey
