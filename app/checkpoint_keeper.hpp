// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <functional>
#include <limpet/app/checkpoint.hpp>
#include <string>

namespace limpet::app {

/// Writes the checkpoints of a run when they are due. Where one cannot be written, the run goes on: it says
/// so once and tries again the next time.
class CheckpointKeeper {
 public:
  /// `path` empty: keeps none. `every` so many sets, > 0. `scan`: see save_checkpoint().
  CheckpointKeeper(std::string path, std::int64_t every, std::string scan)
      : path_(std::move(path)), every_(every), scan_(std::move(scan)) {}

  bool on() const { return !path_.empty(); }
  bool due(std::int64_t sets) const { return on() && sets % every_ == 0; }
  /// Neither a full disk nor memory that does not hold the state a second time ends the run.
  void keep(const std::function<Checkpoint()>& taken);
  /// Why the last one could not be written; empty: it could, or none was due.
  const std::string& failure() const { return failure_; }

 private:
  std::string path_;
  std::int64_t every_;
  std::string scan_;
  std::string failure_;
};

}  // namespace limpet::app
