// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <limpet/app/orientation.hpp>
#include <limpet/app/point_spool.hpp>
#include <limpet/io/scan_reader.hpp>
#include <memory>
#include <string>

namespace limpet::app {

/// The points of a scan, in order, with a look ahead for what has to be known of it beforehand.
class PointStream {
 public:
  /// Throws io::InputError when the scan cannot be opened.
  PointStream(const std::string& path, const io::ScanOptions& options);

  /// The next point; false at the end and at damage. Records passed over just before it are counted by
  /// `skipped`.
  bool next(model::SensorPoint& point, std::int64_t& skipped);

  /// The first point, left in place; null when there is none.
  const io::ScanRecord* first();

  /// Hands the scan's points from the beginning to `take`, at most `most` of them, without moving on: a file
  /// is read a second time, standard input is kept. Precondition: next() has not been called.
  void look_ahead(std::int64_t most, const std::function<void(const model::SensorPoint&)>& take);

  /// For a scan without axes: goes through all of it to find them (see Orientation) and gives next()'s points
  /// theirs. A file is read a second time, standard input is spooled to a temporary file. `edge` of a voxel,
  /// scan's unit. Precondition: next() has not been called. Errors: io::OutputError when there is no space to
  /// spool.
  void orient(double edge);

  /// How the axes were found; null: the scan says them.
  const Orientation* orientation() const { return orientation_.get(); }

  /// Records the scan promises; -1: it does not say.
  std::int64_t promised() const { return reader_->promised(); }
  bool is_standard_input() const { return path_ == "-"; }
  /// Records passed over after the last point.
  std::int64_t skipped_at_end() const { return reader_->skipped() - skipped_seen_; }
  std::int64_t skipped() const { return reader_->skipped(); }
  /// What is wrong with the scan, once the points before it have been given out; empty: nothing so far.
  const std::string& damage() const { return damage_; }

 private:
  struct Kept {
    io::ScanRecord record;
    std::int64_t skipped;
  };
  bool read(Kept& kept);
  bool read_scan(Kept& kept);
  /// All points from the beginning, without moving on; not of standard input.
  void read_again(std::int64_t most, const std::function<void(const model::SensorPoint&)>& take) const;

  std::string path_;
  io::ScanOptions options_;
  std::unique_ptr<io::ScanReader> reader_;
  std::deque<Kept> ahead_;
  std::int64_t skipped_seen_ = 0;
  std::string damage_;
  std::unique_ptr<Orientation> orientation_;
  std::unique_ptr<PointSpool> spool_;  ///< of standard input, once it is oriented
};

}  // namespace limpet::app
