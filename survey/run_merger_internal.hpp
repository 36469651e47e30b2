// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/survey/passes_internal.hpp>
#include <limpet/survey/stored_point_internal.hpp>
#include <limpet/survey/temporary_file.hpp>
#include <memory>
#include <vector>

namespace limpet::survey {

/// A reading as it lies in a temporary file while a scan is sorted.
struct StoredReading {
  std::uint64_t key;
  StoredPoint point;
  std::int64_t skipped, place;
};

/// An external merge sort of readings by key, then place, which hands them out pass by pass: the first pass
/// as the runs are merged, the others from a file for each.
class RunMerger {
 public:
  /// Adds to the present run. Precondition: in order within the run; all places of a run are below those of
  /// the next one; nothing has been taken yet. Errors: io::OutputError when there is no space.
  void add(const StoredReading& reading) { sorted_->append(reading); }
  void end_run();

  /// The next reading; false at the end. Errors: io::OutputError.
  bool next(StoredReading& reading);

  /// Written so far.
  std::int64_t bytes() const { return bytes_; }

 private:
  using File = RecordFile<StoredReading>;
  struct Run {
    RecordCursor<StoredReading> rest;
    StoredReading first;
    std::size_t number;
  };
  static bool later(const Run& a, const Run& b);

  void open_runs();
  bool next_merged(StoredReading& reading);
  void put_off(const StoredReading& reading, std::size_t pass);
  void end_merge();

  std::unique_ptr<File> sorted_ = std::make_unique<File>();  ///< all runs, one behind the other
  std::vector<std::int64_t> ends_;                           ///< of the runs, records
  std::vector<Run> heap_;                                    ///< runs that have a reading left
  bool merging_ = false;
  Passes passes_;
  std::vector<std::unique_ptr<File>> put_off_;           ///< by pass; the first has none
  std::size_t pass_ = 0;                                 ///< that is handed out
  std::unique_ptr<RecordCursor<StoredReading>> cursor_;  ///< over the file of this pass
  std::int64_t bytes_ = 0;
};

}  // namespace limpet::survey
