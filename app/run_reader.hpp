// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/app/run_file.hpp>
#include <memory>
#include <string>

namespace limpet::app {

/// Reads a recorded run, set by set (docs/run_format.md). All errors are io::InputError with file, line and
/// what is wrong.
class RunReader {
 public:
  /// Reads the head.
  explicit RunReader(const std::string& path);
  ~RunReader();

  const RunHead& head() const { return head_; }
  /// The next set; its points are placed by its configuration, to the bit as they were. False when there are
  /// no more.
  bool next(RunSet&);
  /// How the run ended, once next() has been false. A file without an end is of a run that was cut short: the
  /// reason is interrupted, and is_whole() is false.
  const RunEnd& end() const { return end_; }
  bool is_whole() const { return whole_; }

 private:
  struct State;

  std::unique_ptr<State> state_;
  RunHead head_;
  RunEnd end_;
  bool whole_ = false;
};

/// Do the first bytes of this file say that it is a recorded run?
bool is_run(const std::string& path);

/// A warning on standard error, in one line.
void warn_of_run(const std::string& path, const std::string& what);

/// Reads a run from end to end, as a check, and counts its sets. Errors: io::InputError.
std::int64_t count_sets(const std::string& path);

}  // namespace limpet::app
