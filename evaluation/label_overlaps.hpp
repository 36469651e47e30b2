// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <functional>
#include <limpet/evaluation/region_score.hpp>
#include <limpet/io/label_source.hpp>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace limpet::evaluation {

/// A range of labels, both ends in it.
using LabelRange = std::pair<std::int64_t, std::int64_t>;

/// Which labels stand for a region. Labels below 0 never do.
struct RegionLabels {
  std::vector<LabelRange> none;                 ///< labels that stand for no region
  std::optional<std::set<std::int64_t>> known;  ///< where given, no other label stands for a region
  /// The label itself, or kNoRegion.
  std::int64_t region(std::int64_t label) const;
};

/// The labels that stand for no region unless it is said otherwise: 0 in a list, as `limpet model --labels`
/// writes it; in a scan none.
std::vector<LabelRange> usual_none(const io::LabelSource& source);

/// The labels of one segmentation, and what they are called in messages.
struct Segmentation {
  io::LabelSource& labels;
  RegionLabels regions;
  std::string name;
};

struct CountedOverlaps {
  RegionOverlaps overlaps;
  std::int64_t records = 0;
};

/// Reads two segmentations of one scan to their ends, record by record, and counts what they share.
/// `progress` is told the records so far now and then. Errors: io::InputError at damage, and when one has
/// fewer labels than the other.
CountedOverlaps count_overlaps(Segmentation truth, Segmentation found,
                               const std::function<void(std::int64_t)>& progress = {});

}  // namespace limpet::evaluation
