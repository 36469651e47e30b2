// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace limpet::app {

/// One line on standard error that is written over and over: how far, how fast, how long still. Silent
/// unless standard error is a terminal, and for the first second.
class Progress {
 public:
  /// `total` is in the same unit as step()'s `done`; -1: not known.
  Progress(std::string doing, std::int64_t total, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Cheap enough to be called for each set.
  void step(std::int64_t done, const std::string& note = {});
  /// Takes the line away.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  void show(std::int64_t done, const std::string& note, double seconds);

  std::string doing_;
  std::int64_t total_;
  bool on_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now(), next_ = start_ + std::chrono::seconds(1);
};

/// "1:02:03", "2:03" or "3 s".
std::string duration_text(double seconds);

}  // namespace limpet::app
