// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <vector>

namespace limpet::evaluation {

/// A set cover with demands: what each candidate gives, as indices of items; an index may be there several
/// times.
using Offers = std::vector<std::vector<std::size_t>>;

/// Chooses candidates until each item was given as often as `demand` says, or no candidate gives anything
/// that is still asked for: always the one that gives most of that, of equals the first. Then those whose
/// gifts the others make up for are taken back, the earliest chosen last. The result is in ascending order.
/// Greedy choice is within a factor of ln(items) + 1 of the best in theory, and some tenths in practice.
std::vector<std::size_t> greedy_cover(const Offers& offers, std::vector<int> demand);

}  // namespace limpet::evaluation
