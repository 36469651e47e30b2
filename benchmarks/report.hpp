// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>
#include <vector>

#include "sections.hpp"

namespace limpet::benchmarks {

struct ReportOptions {
  std::string folder;  ///< made if need be
  std::string commit = "unknown";
  bool full = false;  ///< up to 10⁸ points and 5,001 faces
  std::vector<std::string> parts{"default", "latency",   "hostile",    "streams",
                                 "sizes",   "polyhedra", "redundancy", "throughput"};
};

/// Measures the parts; leaves report.md and, for each table, a .csv and a .md in the folder. Parts that are
/// not measured stay in report.md as they are.
void write_report(const ReportOptions&, Limits);

}  // namespace limpet::benchmarks
