// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/greedy_cover.hpp>

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace limpet::evaluation {
namespace {

/// How much of a candidate's offer is asked for. `demand` is changed and put back.
int gain(const std::vector<std::size_t>& offer, std::vector<int>& demand) {
  int result = 0;
  for (const std::size_t item : offer) result += demand[item]-- > 0;
  for (const std::size_t item : offer) ++demand[item];
  return result;
}

/// Can the candidate go, with `demand` what is left over it, negative where more was given than asked for?
bool is_spare(const std::vector<std::size_t>& offer, std::vector<int>& demand) {
  bool spare = true;
  for (const std::size_t item : offer) spare &= ++demand[item] <= 0;
  if (!spare)
    for (const std::size_t item : offer) --demand[item];
  return spare;
}

std::vector<std::size_t> chosen_greedily(const Offers& offers, std::vector<int>& demand) {
  using Entry = std::pair<int, std::size_t>;  // gain as last seen, which only falls, and the candidate
  const auto later = [](const Entry& a, const Entry& b) {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  };
  std::priority_queue<Entry, std::vector<Entry>, decltype(later)> queue(later);
  for (std::size_t i = 0; i < offers.size(); ++i) queue.emplace(gain(offers[i], demand), i);
  std::vector<std::size_t> chosen;
  while (!queue.empty()) {
    const auto [seen, candidate] = queue.top();
    queue.pop();
    const int now = gain(offers[candidate], demand);
    if (now == 0) continue;
    if (now < seen) {
      queue.emplace(now, candidate);
      continue;
    }
    for (const std::size_t item : offers[candidate]) --demand[item];
    chosen.push_back(candidate);
  }
  return chosen;
}

}  // namespace

std::vector<std::size_t> greedy_cover(const Offers& offers, std::vector<int> demand) {
  const std::vector<std::size_t> chosen = chosen_greedily(offers, demand);
  std::vector<std::size_t> kept;
  for (auto candidate = chosen.rbegin(); candidate != chosen.rend(); ++candidate)
    if (!is_spare(offers[*candidate], demand)) kept.push_back(*candidate);
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace limpet::evaluation
