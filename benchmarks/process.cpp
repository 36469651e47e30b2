// Copyright the limpet authors. GPL-3.0-or-later.
#include "process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <ctime>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace limpet::benchmarks {
namespace {

/// From /proc/self/status. (ru_maxrss will not do: it outlives exec, so a child would inherit its parent's.)
double status_megabytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key + ":")) return std::stod(line.substr(key.size() + 1)) * 1024 / 1e6;
  throw std::runtime_error("no " + key + " in /proc/self/status");
}

/// The output up to its end, or nothing more after the time limit.
std::string read_all(int from, double limit_seconds, bool& late) {
  const WallWatch watch;
  std::string text;
  for (;;) {
    const double left = limit_seconds - watch.seconds();
    pollfd ready{from, POLLIN, 0};
    if (left <= 0 || ::poll(&ready, 1, static_cast<int>(left * 1000) + 1) == 0) {
      late = true;
      return text;
    }
    std::array<char, 4096> bytes;
    const ssize_t count = ::read(from, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(bytes.data(), static_cast<std::size_t>(count));
  }
}

/// The last line that is one of ours: libraries may print others.
Json last_told(const std::string& text) {
  Json told;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    Json json = Json::parse(line, nullptr, false);
    if (json.is_object()) told = std::move(json);
  }
  return told;
}

}  // namespace

Json ask_process(const Json& request, double limit_seconds) {
  std::array<int, 2> pipe_ends{};
  if (::pipe(pipe_ends.data()) != 0) throw std::runtime_error("no pipe");
  const std::string text = request.dump();
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // whoever stops the report stops what it waits for
    ::dup2(pipe_ends[1], STDOUT_FILENO);
    ::close(pipe_ends[0]);
    ::close(pipe_ends[1]);
    ::execl("/proc/self/exe", "limpet_bench", "answer", text.c_str(), nullptr);
    ::_exit(127);
  }
  ::close(pipe_ends[1]);
  bool late = false;
  const std::string answer = read_all(pipe_ends[0], limit_seconds, late);
  ::close(pipe_ends[0]);
  if (late) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  Json told = last_told(answer);
  const auto failed = [&told](const std::string& why) -> Json { return {{"failed", why}, {"so_far", told}}; };
  if (late) return failed("more than " + std::to_string(static_cast<int>(limit_seconds)) + " s");
  if (WIFSIGNALED(status)) return failed("signal " + std::to_string(WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0 || told.is_null())
    return failed("status " + std::to_string(WEXITSTATUS(status)));
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
