// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace limpet::evaluation {

/// The label of a point that is in no region.
inline constexpr std::int64_t kNoRegion = std::numeric_limits<std::int64_t>::min();

/// How many points each true region shares with each found one. Memory goes with the pairs that meet, not
/// with the points.
class RegionOverlaps {
 public:
  /// One point: the true region it is of and the region it was found in; kNoRegion: none.
  void add(std::int64_t true_label, std::int64_t found_label) { ++counts_[{true_label, found_label}]; }
  const std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t>& counts() const { return counts_; }

 private:
  std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> counts_;
};

struct RegionScoreOptions {
  double overlap = 0.8;        ///< T: the share of a region that must agree; above 0.5, at most 1
  std::int64_t min_true = 1;   ///< points; those of smaller true regions are left out of everything
  std::int64_t min_found = 1;  ///< points; smaller found regions are none, and their points in none
};

/// What became of a true or a found region.
enum class RegionFate {
  correct,          ///< one found region is one true region
  over_segmented,   ///< a true region in several pieces; a found region that is such a piece
  under_segmented,  ///< a found region over several true ones; a true region lost among them
  unmatched,        ///< a true region that is missed; a found region that is noise
};

/// The fraction `points` / `all`; 0 where there are none.
inline double share(std::int64_t points, std::int64_t all) {
  return all > 0 ? static_cast<double>(points) / static_cast<double>(all) : 0;
}

struct TrueRegion {
  std::int64_t label = 0, points = 0;
  RegionFate fate = RegionFate::unmatched;
  std::vector<std::int64_t> found;      ///< labels of the found regions that made its fate, ascending
  std::int64_t main_found = kNoRegion;  ///< the found region with most of its points, of equals the lowest
  std::int64_t in_main = 0;             ///< its points in main_found
  std::int64_t in_any = 0;              ///< its points in any found region
  double covered() const { return share(in_any, points); }
  double covered_by_main() const { return share(in_main, points); }
};

struct FoundRegion {
  std::int64_t label = 0, points = 0;
  RegionFate fate = RegionFate::unmatched;
  std::vector<std::int64_t> truth;     ///< labels of the true regions that made its fate, ascending
  std::int64_t main_true = kNoRegion;  ///< the true region with most of its points, of equals the lowest
  std::int64_t of_main = 0;            ///< its points of main_true
  double purity() const { return share(of_main, points); }
};

struct RegionScore {
  std::vector<TrueRegion> truth;   ///< that count, by label
  std::vector<FoundRegion> found;  ///< that count, by label
  // Hoover's five numbers:
  int correct = 0;          ///< pairs
  int over_segmented = 0;   ///< true regions
  int under_segmented = 0;  ///< found regions
  int missed = 0;           ///< true regions
  int noise = 0;            ///< found regions
  int merged = 0;           ///< true regions lost in the under-segmented ones
  int pieces = 0;           ///< found regions that the over-segmented ones are in
  // Over points:
  std::int64_t points = 0;    ///< looked at
  std::int64_t left_out = 0;  ///< of true regions that do not count
  double purity = 0;          ///< of all points in found regions, the share that is of its region's main_true
  double covered = 0;         ///< of all points of true regions, the share in any found region
  /// Of the true regions, the share that is found correctly.
  double correct_share() const { return share(correct, static_cast<std::int64_t>(truth.size())); }
};

/// Judges a segmentation by the true one, by the rules of Hoover et al., "An experimental comparison of range
/// image segmentation algorithms", IEEE PAMI 18(7), 1996. With |·| the number of points and T the overlap:
///   - found m and true n are a *correct detection* when |m∩n| ≥ T|m| and |m∩n| ≥ T|n|;
///   - n is *over-segmented* into two or more m_i when |m_i∩n| ≥ T|m_i| for each and Σ|m_i∩n| ≥ T|n|;
///   - m is *under-segmented* over two or more n_i when |m∩n_i| ≥ T|n_i| for each and Σ|m∩n_i| ≥ T|m|;
///   - a true region in none of these is *missed*, a found one in none is *noise*.
/// As T > 0.5, a region is in at most one instance of each kind. Where it is in several, the one stands whose
/// overlaps have the higher average: those of the conditions above, two of a correct detection, one more than
/// there are pieces of the others. Of equals the correct goes before the over- before the under-segmented,
/// then the lower true label.
///
/// Points of no true region count in the size of the found region they are in, and so against it. Labels may
/// be any numbers: only which points share one matters. Errors: std::invalid_argument for an overlap that is
/// not above 0.5 and at most 1.
RegionScore score_regions(const RegionOverlaps& overlaps, const RegionScoreOptions& options);

}  // namespace limpet::evaluation
