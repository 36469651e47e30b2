// Copyright the limpet authors. GPL-3.0-or-later.
#include "child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "process.hpp"

namespace limpet::benchmarks {
namespace {

constexpr int kThrew = 70, kNoProgram = 127;

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

void limit(__rlimit_resource what, double to) {
  const rlimit both{static_cast<rlim_t>(to), static_cast<rlim_t>(to) + (what == RLIMIT_CPU)};
  ::setrlimit(what, &both);
}

[[noreturn]] void run_and_exit(const std::function<void()>& body, const ChildLimits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // whoever stops the report stops what it waits for
  limit(RLIMIT_CORE, 0);
  if (limits.cpu_seconds > 0) limit(RLIMIT_CPU, limits.cpu_seconds + 1);
  if (limits.megabytes > 0) limit(RLIMIT_AS, limits.megabytes * 1e6);
  try {
    body();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    ::_exit(kThrew);
  }
  std::cout.flush();
  std::fflush(nullptr);
  ::_exit(0);
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

std::string signal_name(int signal) {
  const char* name = ::sigabbrev_np(signal);
  return name ? std::string("SIG") + name : "signal " + std::to_string(signal);
}

std::string ChildEnd::how() const {
  if (hang) return "hang";
  if (signal != 0) return signal_name(signal);
  if (exit_code == kThrew) return "exception";
  return exit_code == 0 ? "done" : "exit " + std::to_string(exit_code);
}

ChildEnd run_child(const std::function<void()>& body, const ChildLimits& limits) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  std::cout.flush();
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    if (limits.with_errors) ::dup2(ends[1], STDERR_FILENO);
    ::close(ends[0]);
    ::close(ends[1]);
    run_and_exit(body, limits);
  }
  ::close(ends[1]);
  ChildEnd end;
  end.output = read_all(ends[0], limits.seconds, end.hang);
  ::close(ends[0]);
  if (end.hang) ::kill(child, SIGKILL);
  int status = 0;
  rusage used{};
  while (::wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
  }
  end.cpu_seconds = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  end.hang = end.hang || end.signal == SIGXCPU;
  return end;
}

ChildEnd run_program(const std::vector<std::string>& command, const ChildLimits& limits) {
  return run_child(
      [&] {
        std::vector<char*> words;
        for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
        words.push_back(nullptr);
        ::execvp(words[0], words.data());
        ::_exit(kNoProgram);
      },
      limits);
}

}  // namespace limpet::benchmarks
