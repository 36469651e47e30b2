// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>
#include <vector>

#include "run_figures.hpp"

namespace limpet::benchmarks {

/// A run that has been made.
struct MadeRun {
  RunCase wanted;
  RunFigures figures;
};

/// Makes the runs, each in a process of its own, so many at a time, and tells each on standard error as it
/// ends. The result is in the order of the cases. A run that crashes or hangs is one with `failed`.
std::vector<MadeRun> make_runs(const std::vector<RunCase>&, int workers);

/// The runs of one name, which must follow one another.
struct RunGroup {
  std::string name;
  std::vector<RunFigures> runs;      ///< those that have not failed
  std::vector<std::uint64_t> seeds;  ///< of these
  int wanted = 0;

  using Number = double (*)(const RunFigures&);
  double median(Number) const;
  double least(Number) const;
  double most(Number) const;
  int count(bool (*)(const RunFigures&)) const;
  std::int64_t sum(std::int64_t RunFigures::*) const;
  /// "9 of 10".
  std::string share(bool (*)(const RunFigures&)) const;
};
std::vector<RunGroup> grouped(const std::vector<MadeRun>&);

/// One line for each run that did not do what it should: it failed, did not end by itself, collided, broke a
/// law or left reachable surface, with its seed. Empty: there is none.
std::string faults_text(const std::vector<MadeRun>&);

/// For --json: all figures, and the scenes that give them again.
Json to_json(const std::vector<MadeRun>&);

}  // namespace limpet::benchmarks
