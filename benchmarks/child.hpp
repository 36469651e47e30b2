// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <functional>
#include <string>
#include <vector>

/// Processes of their own, whose end is part of the measurement.
namespace limpet::benchmarks {

struct ChildLimits {
  double seconds = 3600;     ///< that pass; beyond that it is ended
  double cpu_seconds = 0;    ///< of its own, so that a busy machine is no hang; 0: no limit
  double megabytes = 0;      ///< of address space; 0: no limit
  bool with_errors = false;  ///< its standard error is part of the output
};

struct ChildEnd {
  std::string output;      ///< its standard output
  double cpu_seconds = 0;  ///< user and system
  bool hang = false;       ///< beyond a limit of time
  int signal = 0;          ///< that ended it; 0: none
  int exit_code = 0;

  bool done() const { return !hang && signal == 0 && exit_code == 0; }
  /// "done", "exit 2", "SIGSEGV", "hang"; "exception" where run_child's body threw.
  std::string how() const;
};

/// Runs `body` in a copy of this process; what it prints on standard output is its output.
ChildEnd run_child(const std::function<void()>& body, const ChildLimits&);

/// Runs a program: its path and arguments.
ChildEnd run_program(const std::vector<std::string>& command, const ChildLimits&);

/// "SIGSEGV" and the like.
std::string signal_name(int signal);

}  // namespace limpet::benchmarks
