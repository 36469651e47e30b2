// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdio>
#include <exception>

namespace limpet::benchmarks {

/// What a benchmark's main() does: whatever is thrown ends it with one line, and this exit code.
template <class Run>
int told_in_a_line(const char* name, Run&& run, int failed = 1) {
  try {
    return run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return failed;
  }
}

}  // namespace limpet::benchmarks
