// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <functional>
#include <limpet/io/scan_reader.hpp>
#include <limpet/survey/backlog.hpp>
#include <limpet/survey/orientation.hpp>
#include <memory>
#include <string>
#include <vector>

namespace limpet::survey {

/// Readings in one set, the unit of an update, where nothing else is asked for: one from each sensor of the
/// thesis's mobile robot.
inline constexpr std::size_t kSetSize = 26;

/// A sensor point of a scan.
struct Reading {
  model::SensorPoint point;
  std::int64_t skipped = 0;  ///< records that are no point and were passed over just before it
  std::int64_t place = 0;    ///< among the scan's points, from 0
};

/// The points of a scan, in order, which can be looked at before they are read: a file is read a second time;
/// what comes only once (standard input, a pipe, a terminal) is kept as far as it has been read (Backlog).
/// Both give the same points, and the same choices.
class PointStream {
 public:
  /// `path` "-" is standard input. `stop`, where there is one, is asked now and then whether a long pass
  /// through the scan, or the wait for the next points, is to end early. Errors: io::InputError when the scan
  /// cannot be opened.
  explicit PointStream(const std::string& path, const io::ScanOptions& options = {},
                       std::function<bool()> stop = {});

  /// The next reading; false at the end and where the scan is damaged (see damage()).
  bool next(Reading& reading);

  /// The next set of at most `size` points; false when there is none left.
  bool next_set(std::vector<model::SensorPoint>& set, std::size_t size = kSetSize);

  /// The first point, left in place; null when there is none. Precondition: nothing has been read yet.
  const ReadPoint* first();

  /// Does the scan say the sensing axes of its points? Where it does not, orient() finds them. Precondition:
  /// nothing has been read yet.
  bool has_axes() { return first() != nullptr && first()->has_axis; }

  /// Do all axes or normals of the scan say nothing (zero, not finite)? Then it is read as one without,
  /// rather than as one that holds no point. Precondition: nothing has been read yet.
  bool axes_say_nothing() { return first() != nullptr && axes_say_nothing_; }

  /// Hands the scan's points to `take` from the beginning, at most `most` of them, without moving on.
  /// Precondition: nothing has been read yet.
  void look_ahead(std::int64_t most, const std::function<void(const model::SensorPoint&)>& take);

  /// Goes through all of the scan to find the sensing axes of its points from the shape of the surface (see
  /// Orientation); next() then hands them out. This is a guess, right for what was scanned from outside.
  /// `edge` of a voxel, scan's unit, > 0; Choice::voxel_edge suits. Precondition: nothing has been read yet.
  /// Errors: io::OutputError when there is no space for the temporary file.
  void orient(double edge);

  /// How the axes were found; null: orient() has not been called.
  const Orientation* orientation() const { return orientation_.get(); }

  /// Records the scan promises; -1: it does not say.
  std::int64_t promised() const { return reader_->promised(); }
  /// Records that are no point, so far.
  std::int64_t skipped() const { return reader_->skipped() + axisless_; }
  /// Of these, those behind the last point.
  std::int64_t skipped_at_end() const { return skipped() - skipped_seen_; }
  /// What is wrong with the scan, once the points before it have been given out; empty: nothing so far.
  const std::string& damage() const { return damage_; }
  /// The scan as messages name it: its path, or "standard input".
  std::string name() const { return path_ == "-" ? "standard input" : path_; }

 private:
  bool read(ReadPoint& read);
  bool read_record(io::ScanRecord& record);
  void settle_axes();
  bool stopped() const { return stop_ && stop_(); }
  /// All points from the beginning, without moving on. Precondition: it is a file.
  void read_again(std::int64_t most, const std::function<void(const model::SensorPoint&)>& take) const;

  std::string path_;
  io::ScanOptions options_;
  std::function<bool()> stop_;
  bool is_file_;  ///< can be read again
  std::unique_ptr<io::ScanReader> reader_;
  Backlog ahead_;
  bool settled_ = false;  ///< whether the axes that the scan promises are there
  bool axes_say_nothing_ = false;
  std::int64_t axisless_ = 0;  ///< records that would be points, had they an axis
  std::int64_t skipped_seen_ = 0;
  std::int64_t given_ = 0;  ///< points handed out
  std::string damage_;
  std::unique_ptr<Orientation> orientation_;
};

}  // namespace limpet::survey
