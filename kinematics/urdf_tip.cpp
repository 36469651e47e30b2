// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cctype>
#include <string_view>

#include "urdf_tip_internal.hpp"

namespace limpet::kinematics::internal {
namespace {

constexpr std::string_view kTipNames[] = {"tcp", "tool0", "ee", "ee_link", "end_effector", "flange", "hand"};
constexpr std::size_t kNoTip = std::size(kTipNames);

/// Where the name is among those of tips, alone or after an underscore: 0 is the best.
std::size_t rank_of(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (std::size_t rank = 0; rank < kNoTip; ++rank)
    if (name == kTipNames[rank] || name.ends_with("_" + std::string(kTipNames[rank]))) return rank;
  return kNoTip;
}

/// Those for which `value` is the largest.
template <class Value>
std::vector<std::size_t> largest(const std::vector<std::size_t>& from, const Value& value) {
  std::vector<std::size_t> best;
  for (const std::size_t i : from) {
    if (!best.empty() && value(i) < value(best.front())) continue;
    if (!best.empty() && value(i) > value(best.front())) best.clear();
    best.push_back(i);
  }
  return best;
}

}  // namespace

std::vector<std::size_t> likely_tips(const std::vector<TipCandidate>& candidates) {
  std::size_t most = 0;
  for (const TipCandidate& one : candidates) most = std::max(most, one.moving_joints);
  const auto joints = [&](std::size_t i) { return candidates[i].moving_joints; };
  std::vector<std::size_t> all, named;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    all.push_back(i);
    if (rank_of(candidates[i].name) < kNoTip && 2 * joints(i) >= most) named.push_back(i);
  }
  if (!named.empty())
    return largest(largest(named, joints),
                   [&](std::size_t i) { return kNoTip - rank_of(candidates[i].name); });
  return largest(largest(all, joints), [&](std::size_t i) { return candidates[i].depth; });
}

}  // namespace limpet::kinematics::internal
