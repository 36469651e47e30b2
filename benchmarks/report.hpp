// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>

#include "sections.hpp"

namespace limpet::benchmarks {

struct ReportOptions {
  std::string folder;  ///< made if need be
  std::string commit = "unknown";
  bool full = false;  ///< up to 10⁸ points and 5,001 faces: about an hour instead of a quarter
};

/// All sections; report.md and a CSV for each table in the folder, rewritten after each section so that a run
/// that is stopped leaves what it had.
void write_report(const ReportOptions&, Limits);

}  // namespace limpet::benchmarks
