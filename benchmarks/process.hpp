// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <chrono>

#include <nlohmann/json.hpp>

/// Every measurement is made in a process of its own, so that its memory is its own: the program starts
/// itself with a request and reads one line of JSON as the answer.
namespace limpet::benchmarks {

using Json = nlohmann::json;

/// Does what is asked in a process of its own. The answer holds "failed" with a reason instead when the
/// process exceeds the time limit, which ends it, or fails otherwise; then what it told last is "so_far".
Json ask_process(const Json& request, double limit_seconds);
/// In the process that was asked: what is known before the answer, should there be none.
void tell_so_far(const Json&);

/// The last line that is a JSON object of our own: libraries may print others. Null if there is none.
Json last_told(const std::string& text);

/// Peak and present resident memory of this process, MB (10⁶ bytes).
double peak_megabytes();
double resident_megabytes();

/// Time that passes.
class WallWatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// Time that this process's one thread computes, whatever else the machine does.
class CpuWatch {
 public:
  double seconds() const { return now() - start_; }

 private:
  static double now();
  double start_ = now();
};

}  // namespace limpet::benchmarks
