// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/model/changes.hpp>
#include <string>
#include <utility>
#include <vector>

namespace limpet::app {

/// Remembers where a scan has records that are no point, because --labels writes a line for every record.
class SkippedRecords {
 public:
  void add(std::int64_t before_point, std::int64_t records) {
    if (records > 0) skipped_.emplace_back(before_point, records);
  }
  /// The labels file: one line for each record, 0 for one that is no point.
  std::string label_lines(const std::vector<model::SegmentId>& labels) const {
    std::string text;
    auto skipped = skipped_.begin();
    for (std::size_t i = 0; i <= labels.size(); ++i) {
      for (; skipped != skipped_.end() && skipped->first == static_cast<std::int64_t>(i); ++skipped) {
        for (std::int64_t k = 0; k < skipped->second; ++k) text += "0\n";
      }
      if (i < labels.size()) text += std::to_string(labels[i].value) + "\n";
    }
    return text;
  }

 private:
  std::vector<std::pair<std::int64_t, std::int64_t>> skipped_;
};

}  // namespace limpet::app
