// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/point_stream.hpp>

#include <limits>
#include <limpet/io/error.hpp>
#include <utility>

namespace limpet::survey {

PointStream::PointStream(const std::string& path, const io::ScanOptions& options, std::function<bool()> stop)
    : path_(path), options_(options), stop_(std::move(stop)), reader_(io::open_scan(path, options)) {}

bool PointStream::read(Kept& kept) {
  if (!spool_) return read_scan(kept);
  PointSpool::Entry entry;
  if (!spool_->read(entry)) return false;
  kept.record = {};
  kept.record.point.position = entry.position;
  kept.skipped = entry.skipped;
  return true;
}

bool PointStream::read_scan(Kept& kept) {
  if (!damage_.empty()) return false;
  try {
    if (!reader_->next(kept.record)) return false;
  } catch (const io::InputError& error) {
    damage_ = error.what();
    return false;
  }
  kept.skipped = reader_->skipped() - skipped_seen_;
  skipped_seen_ = reader_->skipped();
  return true;
}

bool PointStream::next(Reading& reading) {
  Kept kept;
  if (!ahead_.empty()) {
    kept = ahead_.front();
    ahead_.pop_front();
  } else if (!read(kept)) {
    return false;
  }
  reading = {kept.record.point, kept.skipped};
  if (orientation_) reading.point.axis = orientation_->axis(reading.point.position);
  return true;
}

bool PointStream::next_set(std::vector<model::SensorPoint>& set, std::size_t size) {
  set.clear();
  for (Reading reading; set.size() < size && next(reading);) set.push_back(reading.point);
  return !set.empty();
}

const io::ScanRecord* PointStream::first() {
  if (ahead_.empty()) {
    Kept kept;
    if (!read(kept)) return nullptr;
    ahead_.push_back(kept);
  }
  return &ahead_.front().record;
}

void PointStream::look_ahead(std::int64_t most, const std::function<void(const model::SensorPoint&)>& take) {
  if (is_standard_input()) {
    Kept kept;
    while (static_cast<std::int64_t>(ahead_.size()) < most && read(kept)) ahead_.push_back(kept);
    for (const Kept& point : ahead_) take(point.record.point);
    return;
  }
  read_again(most, take);
}

void PointStream::read_again(std::int64_t most,
                             const std::function<void(const model::SensorPoint&)>& take) const {
  try {
    const auto again = io::open_scan(path_, options_);
    io::ScanRecord record;
    for (std::int64_t i = 0; i < most && !stopped() && again->next(record); ++i) take(record.point);
  } catch (const io::InputError&) {
    // The points before the damage suffice here; next() reports the damage when it comes to it.
  }
}

void PointStream::orient(double edge) {
  auto orientation = std::make_unique<Orientation>(edge);
  if (is_standard_input()) {
    auto spool = std::make_unique<PointSpool>();
    const auto keep = [&](const Kept& kept) {
      orientation->add(kept.record.point.position);
      spool->write({kept.record.point.position, kept.skipped});
    };
    for (const Kept& kept : ahead_) keep(kept);
    ahead_.clear();
    for (Kept kept; !stopped() && read_scan(kept);) keep(kept);
    spool->rewind();
    spool_ = std::move(spool);
  } else {
    read_again(std::numeric_limits<std::int64_t>::max(),
               [&](const model::SensorPoint& point) { orientation->add(point.position); });
  }
  orientation->solve();
  orientation_ = std::move(orientation);
}

}  // namespace limpet::survey
