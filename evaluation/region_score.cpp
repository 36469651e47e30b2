// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/region_score.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <tuple>

namespace limpet::evaluation {
namespace {

/// How many points a true and a found region share; the regions are given by their indices in the score.
struct Meeting {
  std::size_t truth, found;
  std::int64_t points;
};

/// One instance of Hoover's kinds (correct, over- or under-segmented), with the regions it is about.
struct Instance {
  RegionFate fate;
  std::vector<std::size_t> truth, found;  ///< places in the score, ascending by label
  double overlaps;  ///< of each piece with the whole it is in, and of the whole with all pieces: their sum
  /// In units of 10⁻¹², so that averages that are equal but for rounding are equal.
  std::int64_t average_overlap() const {
    return std::llround(1e12 * overlaps / static_cast<double>(std::max(truth.size(), found.size()) + 1));
  }
};

using Sizes = std::map<std::int64_t, std::int64_t>;  ///< points by label

Sizes true_sizes_of(const RegionOverlaps& overlaps, std::int64_t smallest) {
  Sizes sizes;
  for (const auto& [labels, points] : overlaps.counts()) {
    if (labels.first != kNoRegion) sizes[labels.first] += points;
  }
  std::erase_if(sizes, [&](const auto& region) { return region.second < smallest; });
  return sizes;
}

bool is_left_out(const Sizes& true_sizes, std::int64_t true_label) {
  return true_label != kNoRegion && !true_sizes.contains(true_label);
}

Sizes found_sizes_of(const RegionOverlaps& overlaps, std::int64_t smallest, const Sizes& true_sizes) {
  Sizes sizes;
  for (const auto& [labels, points] : overlaps.counts()) {
    if (labels.second != kNoRegion && !is_left_out(true_sizes, labels.first)) sizes[labels.second] += points;
  }
  std::erase_if(sizes, [&](const auto& region) { return region.second < smallest; });
  return sizes;
}

template <class Region>
void add_regions(std::vector<Region>& regions, const Sizes& sizes) {
  for (const auto& [label, points] : sizes) {
    Region& region = regions.emplace_back();
    region.label = label;
    region.points = points;
  }
}

template <class Region>
std::size_t place_of(const std::vector<Region>& regions, std::int64_t label) {
  const auto found =
      std::lower_bound(regions.begin(), regions.end(), label,
                       [](const Region& region, std::int64_t wanted) { return region.label < wanted; });
  const bool there = found != regions.end() && found->label == label;
  return there ? static_cast<std::size_t>(found - regions.begin()) : regions.size();
}

class Scorer {
 public:
  Scorer(const RegionOverlaps& overlaps, const RegionScoreOptions& options) : overlap_(options.overlap) {
    const Sizes true_sizes = true_sizes_of(overlaps, options.min_true);
    const Sizes found_sizes = found_sizes_of(overlaps, options.min_found, true_sizes);
    add_regions(score_.truth, true_sizes);
    add_regions(score_.found, found_sizes);
    for (const auto& [labels, points] : overlaps.counts()) {
      if (is_left_out(true_sizes, labels.first)) {
        score_.left_out += points;
      } else {
        count(labels.first, labels.second, points);
      }
    }
  }

  RegionScore score() {
    std::vector<Instance> instances = correct_detections();
    append(instances, in_pieces(RegionFate::over_segmented));
    append(instances, in_pieces(RegionFate::under_segmented));
    choose(std::move(instances));
    count_fates();
    return std::move(score_);
  }

 private:
  /// Meetings come by label, so of equals the lowest stays the main one.
  void count(std::int64_t true_label, std::int64_t found_label, std::int64_t points) {
    score_.points += points;
    const std::size_t n = place_of(score_.truth, true_label), m = place_of(score_.found, found_label);
    if (n == score_.truth.size() || m == score_.found.size()) return;
    meetings_.push_back({n, m, points});
    TrueRegion& truth = score_.truth[n];
    truth.in_any += points;
    if (points > truth.in_main) {
      truth.in_main = points;
      truth.main_found = found_label;
    }
    FoundRegion& found = score_.found[m];
    if (points > found.of_main) {
      found.of_main = points;
      found.main_true = true_label;
    }
  }

  double share_of_true(const Meeting& meeting) const {
    return share(meeting.points, score_.truth[meeting.truth].points);
  }
  double share_of_found(const Meeting& meeting) const {
    return share(meeting.points, score_.found[meeting.found].points);
  }

  std::vector<Instance> correct_detections() const {
    std::vector<Instance> instances;
    for (const Meeting& meeting : meetings_) {
      if (share_of_true(meeting) < overlap_ || share_of_found(meeting) < overlap_) continue;
      instances.push_back({RegionFate::correct,
                           {meeting.truth},
                           {meeting.found},
                           share_of_true(meeting) + share_of_found(meeting)});
    }
    return instances;
  }

  /// A region is in pieces when those of the other kind that lie in it, by T of their own points, hold T of
  /// its points together: a true one in pieces is over-segmented, a found one is under-segmented.
  std::vector<Instance> in_pieces(RegionFate fate) const {
    const bool over = fate == RegionFate::over_segmented;
    std::map<std::size_t, std::pair<Instance, std::int64_t>> wholes;  // and the points in their pieces
    for (const Meeting& meeting : meetings_) {
      const double in_whole = over ? share_of_found(meeting) : share_of_true(meeting);
      if (in_whole < overlap_) continue;
      auto& [instance, shared] = wholes[over ? meeting.truth : meeting.found];
      (over ? instance.found : instance.truth).push_back(over ? meeting.found : meeting.truth);
      instance.overlaps += in_whole;
      shared += meeting.points;
    }
    std::vector<Instance> instances;
    for (auto& [whole, entry] : wholes) {
      auto& [instance, shared] = entry;
      const double held = share(shared, over ? score_.truth[whole].points : score_.found[whole].points);
      if ((over ? instance.found : instance.truth).size() < 2 || held < overlap_) continue;
      instance.fate = fate;
      (over ? instance.truth : instance.found) = {whole};
      instance.overlaps += held;
      instances.push_back(std::move(instance));
    }
    return instances;
  }

  static void append(std::vector<Instance>& all, std::vector<Instance> more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }

  /// The best first; an instance stands when none of its regions is in one that stands already.
  void choose(std::vector<Instance> instances) {
    std::stable_sort(instances.begin(), instances.end(), [](const Instance& a, const Instance& b) {
      return std::tuple(-a.average_overlap(), a.fate, a.truth.front()) <
             std::tuple(-b.average_overlap(), b.fate, b.truth.front());
    });
    const auto is_free = [](const auto& region) { return region.fate == RegionFate::unmatched; };
    for (const Instance& instance : instances) {
      const bool stands = std::all_of(instance.truth.begin(), instance.truth.end(),
                                      [&](std::size_t n) { return is_free(score_.truth[n]); }) &&
                          std::all_of(instance.found.begin(), instance.found.end(),
                                      [&](std::size_t m) { return is_free(score_.found[m]); });
      if (stands) settle(instance);
    }
  }

  void settle(const Instance& instance) {
    for (const std::size_t n : instance.truth) {
      score_.truth[n].fate = instance.fate;
      for (const std::size_t m : instance.found) score_.truth[n].found.push_back(score_.found[m].label);
    }
    for (const std::size_t m : instance.found) {
      score_.found[m].fate = instance.fate;
      for (const std::size_t n : instance.truth) score_.found[m].truth.push_back(score_.truth[n].label);
    }
  }

  void count_fates() {
    std::int64_t in_truth = 0, covered = 0, in_found = 0, pure = 0;
    for (const TrueRegion& region : score_.truth) {
      score_.correct += region.fate == RegionFate::correct;
      score_.over_segmented += region.fate == RegionFate::over_segmented;
      score_.merged += region.fate == RegionFate::under_segmented;
      score_.missed += region.fate == RegionFate::unmatched;
      in_truth += region.points;
      covered += region.in_any;
    }
    for (const FoundRegion& region : score_.found) {
      score_.under_segmented += region.fate == RegionFate::under_segmented;
      score_.pieces += region.fate == RegionFate::over_segmented;
      score_.noise += region.fate == RegionFate::unmatched;
      in_found += region.points;
      pure += region.of_main;
    }
    score_.covered = share(covered, in_truth);
    score_.purity = share(pure, in_found);
  }

  double overlap_;
  RegionScore score_;
  std::vector<Meeting> meetings_;
};

}  // namespace

RegionScore score_regions(const RegionOverlaps& overlaps, const RegionScoreOptions& options) {
  if (!(options.overlap > 0.5 && options.overlap <= 1)) {
    throw std::invalid_argument("the overlap must be above 0.5 and at most 1");
  }
  return Scorer(overlaps, options).score();
}

}  // namespace limpet::evaluation
