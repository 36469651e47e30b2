// Copyright the limpet authors. GPL-3.0-or-later.
#include "minimise.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <stdexcept>

namespace limpet::cases {
namespace {

std::string read_all(int from) {
  std::string text;
  char buffer[256];
  for (;;) {
    const ssize_t n = ::read(from, buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return text;
    text.append(buffer, static_cast<std::size_t>(n));
  }
}

}  // namespace

std::string verdict_aside(const std::function<std::string()>& trial, unsigned seconds) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    ::close(ends[0]);
    // Of its own time: a loaded machine is no hang. What a crash says is not asked for.
    const itimerval limit{{0, 0}, {static_cast<time_t>(seconds), 0}};
    ::setitimer(ITIMER_VIRTUAL, &limit, nullptr);
    if (!std::freopen("/dev/null", "w", stderr)) ::_exit(1);
    std::string verdict;
    try {
      verdict = trial();
    } catch (const std::exception&) {
      verdict = "invalid";  // no case at all: reduced too far
    }
    const auto written = ::write(ends[1], verdict.data(), verdict.size());
    ::_exit(written == static_cast<ssize_t>(verdict.size()) ? 0 : 1);
  }
  ::close(ends[1]);
  std::string verdict = read_all(ends[0]);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return verdict;
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGVTALRM ? "hang" : "crash";
}

}  // namespace limpet::cases
