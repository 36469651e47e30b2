// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/signed_forest.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>

namespace limpet::survey {
namespace {

constexpr float kSure = 0.75F;

}  // namespace

SignedForest::SignedForest(int count)
    : parents_(static_cast<std::size_t>(count)),
      turns_(static_cast<std::size_t>(count), 1),
      sizes_(static_cast<std::size_t>(count), 1) {
  std::iota(parents_.begin(), parents_.end(), 0);
}

void SignedForest::vote(int a, int b, double weight) {
  if (weight != 0) votes_.push_back({a, b, static_cast<float>(weight)});
}

std::pair<int, int> SignedForest::root(int thing) {
  int top = thing, turn = 1;
  for (; parents_[top] != top; top = parents_[top]) turn *= turns_[top];
  // Everything on the way now hangs from the root.
  for (int at = thing, left = turn; parents_[at] != at;) {
    const int next = parents_[at], own = turns_[at];
    parents_[at] = top;
    turns_[at] = left;
    left *= own;
    at = next;
  }
  return {top, turn};
}

void SignedForest::solve() {
  join_sure();
  join_by_sums();
  roots_.resize(parents_.size());
  signs_.resize(parents_.size());
  for (std::size_t i = 0; i < parents_.size(); ++i) {
    std::tie(roots_[i], signs_[i]) = root(static_cast<int>(i));
  }
}

void SignedForest::join_sure() {
  const auto sure_end = std::stable_partition(votes_.begin(), votes_.end(),
                                              [](const Vote& v) { return std::abs(v.weight) >= kSure; });
  std::sort(votes_.begin(), sure_end, [](const Vote& u, const Vote& v) {
    return std::tuple(-std::abs(u.weight), u.a, u.b) < std::tuple(-std::abs(v.weight), v.a, v.b);
  });
  for (auto v = votes_.begin(); v != sure_end; ++v) {
    auto [a, turn_a] = root(v->a);
    auto [b, turn_b] = root(v->b);
    if (a == b) continue;
    if (sizes_[a] < sizes_[b]) std::swap(a, b);
    parents_[b] = a;
    turns_[b] = turn_a * turn_b * (v->weight > 0 ? 1 : -1);
    sizes_[a] += sizes_[b];
  }
}

void SignedForest::join_by_sums() {
  std::vector<std::map<int, double>> sums(parents_.size());  // of the votes between two roots
  for (const Vote& v : votes_) {
    const auto [a, turn_a] = root(v.a);
    const auto [b, turn_b] = root(v.b);
    if (a == b) continue;
    const double weight = static_cast<double>(v.weight) * turn_a * turn_b;
    sums[a][b] += weight;
    sums[b][a] += weight;
  }
  votes_.clear();
  votes_.shrink_to_fit();
  using Entry = std::tuple<double, int, int>;  // |sum|, and the two, negative so that the lower go first
  std::priority_queue<Entry> queue;
  const auto push = [&](int a, int b, double sum) {
    if (sum != 0) queue.emplace(std::abs(sum), -std::min(a, b), -std::max(a, b));
  };
  for (int a = 0; a < static_cast<int>(sums.size()); ++a) {
    for (const auto& [b, sum] : sums[a]) {
      if (a < b) push(a, b, sum);
    }
  }
  while (!queue.empty()) {
    const auto [clear, minus_a, minus_b] = queue.top();
    queue.pop();
    int a = -minus_a, b = -minus_b;
    const auto found = sums[a].find(b);
    if (found == sums[a].end() || std::abs(found->second) != clear) continue;  // joined or changed since
    const int turn = found->second > 0 ? 1 : -1;
    if (sums[a].size() < sums[b].size()) std::swap(a, b);
    parents_[b] = a;
    turns_[b] = turn;
    sums[a].erase(b);
    for (const auto& [c, sum] : sums[b]) {
      if (c == a) continue;
      sums[c].erase(b);
      const double more = sums[a][c] + turn * sum;
      sums[a][c] = sums[c][a] = more;
      push(a, c, more);
    }
    sums[b].clear();
  }
}

}  // namespace limpet::survey
