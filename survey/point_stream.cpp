// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/point_stream.hpp>

#include <filesystem>
#include <limits>
#include <limpet/io/error.hpp>
#include <utility>

namespace limpet::survey {
namespace {

bool is_file(const std::string& path) {
  std::error_code none;
  return path != "-" && std::filesystem::is_regular_file(path, none);
}

io::ScanOptions with_axisless(io::ScanOptions options, const std::function<bool()>& stop) {
  options.keep_axisless = true;
  options.stop = stop;
  return options;
}

}  // namespace

PointStream::PointStream(const std::string& path, const io::ScanOptions& options, std::function<bool()> stop)
    : path_(path),
      options_(with_axisless(options, stop)),
      stop_(std::move(stop)),
      is_file_(is_file(path)),
      reader_(io::open_scan(path, options_)) {}

bool PointStream::read_record(io::ScanRecord& record) {
  if (!damage_.empty()) return false;
  try {
    return reader_->next(record);
  } catch (const io::InputError& error) {
    damage_ = error.what();
    return false;
  }
}

/// The next point with an axis; where no point has one, the next point.
bool PointStream::read(ReadPoint& read) {
  settle_axes();
  for (io::ScanRecord record; read_record(record);) {
    if (record.axisless) {
      ++axisless_;
      continue;
    }
    read = {record.point, record.has_axis, skipped() - skipped_seen_};
    skipped_seen_ = skipped();
    return true;
  }
  return false;
}

/// Reads up to the first point whose axis is as its columns promise. If there is none, the others are the
/// scan.
void PointStream::settle_axes() {
  if (std::exchange(settled_, true)) return;
  Backlog without;
  std::int64_t seen = 0;  // records passed over before the last point of these
  for (io::ScanRecord record; read_record(record);) {
    if (!record.axisless) {
      ahead_.add({record.point, record.has_axis, skipped()});
      skipped_seen_ = skipped();
      return;
    }
    ++axisless_;
    if (!is_file_) without.add({record.point, record.has_axis, reader_->skipped() - seen});
    seen = reader_->skipped();
    if (stopped()) return;
  }
  if (axisless_ == 0) return;
  axes_say_nothing_ = true;
  axisless_ = 0;
  if (is_file_) {
    options_.ignore_axis_columns = true;
    reader_ = io::open_scan(path_, options_);
    damage_.clear();
  } else {
    ahead_ = std::move(without);
    skipped_seen_ = seen;
  }
}

bool PointStream::next(Reading& reading) {
  settle_axes();
  ReadPoint point;
  if (!ahead_.take(point) && !read(point)) return false;
  reading = {point.point, point.skipped, given_++};
  if (orientation_) reading.point.axis = orientation_->axis(reading.point.position);
  return true;
}

bool PointStream::next_set(std::vector<model::SensorPoint>& set, std::size_t size) {
  set.clear();
  for (Reading reading; set.size() < size && next(reading);) set.push_back(reading.point);
  return !set.empty();
}

const ReadPoint* PointStream::first() {
  settle_axes();
  if (ahead_.size() == 0) {
    ReadPoint point;
    if (!read(point)) return nullptr;
    ahead_.add(point);
  }
  return ahead_.first();
}

void PointStream::look_ahead(std::int64_t most, const std::function<void(const model::SensorPoint&)>& take) {
  settle_axes();
  if (is_file_) return read_again(most, take);
  for (ReadPoint point; ahead_.size() < most && !stopped() && read(point);) ahead_.add(point);
  ahead_.for_each(most, [&](const ReadPoint& point) { take(point.point); });
}

void PointStream::read_again(std::int64_t most,
                             const std::function<void(const model::SensorPoint&)>& take) const {
  try {
    const auto again = io::open_scan(path_, options_);
    io::ScanRecord record;
    for (std::int64_t i = 0; i < most && !stopped() && again->next(record);) {
      if (record.axisless) continue;
      take(record.point);
      ++i;
    }
  } catch (const io::InputError&) {
    // The points before the damage suffice here; next() reports the damage when it comes to it.
  }
}

void PointStream::orient(double edge) {
  settle_axes();
  auto orientation = std::make_unique<Orientation>(edge);
  const auto all = std::numeric_limits<std::int64_t>::max();
  look_ahead(all, [&](const model::SensorPoint& point) { orientation->add(point.position); });
  orientation->solve();
  orientation_ = std::move(orientation);
}

}  // namespace limpet::survey
