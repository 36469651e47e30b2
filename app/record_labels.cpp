// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/record_labels.hpp>

namespace limpet::app {

std::string RecordLabels::lines(std::int64_t points, const std::vector<model::SegmentId>& labels) const {
  std::vector<std::uint64_t> by_place(static_cast<std::size_t>(points), 0);
  for (std::size_t i = 0; i < labels.size(); ++i)
    by_place[static_cast<std::size_t>(places_[i])] = labels[i].value;
  std::string text;
  auto skipped = skipped_.begin();
  for (std::int64_t place = 0; place <= points; ++place) {
    if (skipped != skipped_.end() && skipped->first == place)
      for (std::int64_t records = skipped++->second; records > 0; --records) text += "0\n";
    if (place < points) text += std::to_string(by_place[static_cast<std::size_t>(place)]) + "\n";
  }
  return text;
}

}  // namespace limpet::app
