// Copyright the limpet authors. GPL-3.0-or-later.
#include "process.hpp"

#include <ctime>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "child.hpp"

namespace limpet::benchmarks {
namespace {

/// From /proc/self/status. (ru_maxrss will not do: it outlives exec, so a child would inherit its parent's.)
double status_megabytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key + ":")) return std::stod(line.substr(key.size() + 1)) * 1024 / 1e6;
  throw std::runtime_error("no " + key + " in /proc/self/status");
}

}  // namespace

Json last_told(const std::string& text) {
  Json told;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    Json json = Json::parse(line, nullptr, false);
    if (json.is_object()) told = std::move(json);
  }
  return told;
}

Json ask_process(const Json& request, double limit_seconds) {
  const ChildEnd end = run_program({"/proc/self/exe", "answer", request.dump()}, {.seconds = limit_seconds});
  Json told = last_told(end.output);
  const auto failed = [&told](const std::string& why) -> Json { return {{"failed", why}, {"so_far", told}}; };
  if (end.hang) return failed("more than " + std::to_string(static_cast<int>(limit_seconds)) + " s");
  if (end.signal != 0) return failed("signal " + std::to_string(end.signal));
  if (end.exit_code != 0 || told.is_null()) return failed("status " + std::to_string(end.exit_code));
  return told;
}

void tell_so_far(const Json& so_far) { std::cout << so_far.dump() << std::endl; }

double CpuWatch::now() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double peak_megabytes() { return status_megabytes("VmHWM"); }
double resident_megabytes() { return status_megabytes("VmRSS"); }

}  // namespace limpet::benchmarks
