// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>
#include <vector>

#include "run_scans.hpp"

namespace limpet::benchmarks {

/// What one build made of one scan.
struct RunResult {
  std::string ended = "done";         ///< "exception", the name of a signal, "hang", "exit 2"
  std::vector<double> cpu_seconds;    ///< of each round
  std::vector<double> model_seconds;  ///< of each round: without reading arguments, the oracle and writing
  Json instructions;                  ///< null: not counted
  int violations = 0;                 ///< the exact oracle's count of broken laws
  std::string laws;                   ///< which
  Json polygons, true_faces, closed;  ///< null: not known
  Json distance;                      ///< largest, either way, in λ; null: not known, or no area
  std::string summary;                ///< counts by which models are compared with the exact build's

  /// Broken, or not what the truth asks for.
  bool faces_wrong() const { return true_faces.is_number() && polygons != true_faces; }
  bool far_off() const { return true_faces.is_number() && !(distance.is_number() && distance <= 1.0); }
};
using RunResults = std::array<RunResult, kBuilds.size()>;

/// A row for each run.
Table run_table(const std::vector<RunScan>&, const std::vector<RunResults>&);
/// Simulated and real scans in each regime: what exactness costs.
Table run_cost_table(const std::vector<RunScan>&, const std::vector<RunResults>&);
/// And how often the result is wrong.
Table run_fault_table(const std::vector<RunScan>&, const std::vector<RunResults>&);

}  // namespace limpet::benchmarks
