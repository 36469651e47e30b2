// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/model/changes.hpp>
#include <limpet/survey/point_stream.hpp>
#include <map>
#include <string>
#include <vector>

namespace limpet::app {

/// Which record of the scan each point was that the model was given: --labels writes a line for every record,
/// in the scan's order.
class RecordLabels {
 public:
  /// The next point that the model is given.
  void add(const survey::Reading& reading) {
    places_.push_back(reading.place);
    skip(reading.place, reading.skipped);
  }
  /// So many records that are no point stand before the scan's point of this place, or at its end.
  void skip(std::int64_t before, std::int64_t records) {
    if (records > 0) skipped_[before] += records;
  }
  /// The labels file: one line for each of the scan's first `points` points and the records between them, 0
  /// for one that is no point or that the model was not given. `labels` in the order of add().
  std::string lines(std::int64_t points, const std::vector<model::SegmentId>& labels) const;

 private:
  std::vector<std::int64_t> places_;              ///< of the points, in the order of add()
  std::map<std::int64_t, std::int64_t> skipped_;  ///< records by the place of the point behind them
};

}  // namespace limpet::app
