// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/label_overlaps.hpp>

#include <algorithm>
#include <limpet/io/error.hpp>

namespace limpet::evaluation {

std::int64_t RegionLabels::region(std::int64_t label) const {
  const bool is_none = label < 0 || std::any_of(none.begin(), none.end(), [&](const LabelRange& range) {
                         return label >= range.first && label <= range.second;
                       });
  return is_none || (known && !known->contains(label)) ? kNoRegion : label;
}

std::vector<LabelRange> usual_none(const io::LabelSource& source) {
  return source.is_list() ? std::vector<LabelRange>{{0, 0}} : std::vector<LabelRange>{};
}

CountedOverlaps count_overlaps(Segmentation truth, Segmentation found,
                               const std::function<void(std::int64_t)>& progress) {
  CountedOverlaps counted;
  for (std::int64_t found_label = 0, true_label = 0;; ++counted.records) {
    const bool has_found = found.labels.next(found_label), has_true = truth.labels.next(true_label);
    if (!has_found && !has_true) return counted;
    if (has_found != has_true) {
      throw io::InputError((has_found ? truth : found).name,
                           "has only " + std::to_string(counted.records) +
                               " labels, fewer than the other: they are not of the same scan");
    }
    counted.overlaps.add(truth.regions.region(true_label), found.regions.region(found_label));
    if (progress && counted.records % 4096 == 0) progress(counted.records);
  }
}

}  // namespace limpet::evaluation
