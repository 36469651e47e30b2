// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <vector>

namespace limpet::survey {

/// Gives each of a number of things a sign, +1 or -1, so that pairs agree or differ as voted, the clearer
/// votes going first. Greedy: sure pairs are joined one by one; what they make is then joined by the sums of
/// all the votes between them, largest first, sums being added as things join (greedy additive edge
/// contraction, Keuper et al., ICCV 2015, with signs). Deterministic: equal votes go by number.
class SignedForest {
 public:
  /// Things are numbered 0 .. count-1.
  explicit SignedForest(int count);

  /// That a and b should have the same sign (weight > 0, at most 1) or different ones (< 0); 0 says nothing.
  void vote(int a, int b, double weight);

  /// Settles the signs. Nothing may be voted afterwards.
  void solve();

  int sign(int thing) const { return signs_[thing]; }
  /// Things that no vote ties together, even by others, are in different components; numbered by one of
  /// theirs.
  int component(int thing) const { return roots_[thing]; }

 private:
  struct Vote {
    int a, b;
    float weight;
  };
  /// The root of a thing, and its sign over the root's; shortens the way there.
  std::pair<int, int> root(int thing);
  void join_sure();
  void join_by_sums();

  std::vector<Vote> votes_;
  std::vector<int> parents_;
  std::vector<int> turns_;  ///< sign over the parent's
  std::vector<int> sizes_;
  std::vector<int> roots_, signs_;
};

}  // namespace limpet::survey
