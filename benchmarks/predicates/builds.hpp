// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "../child.hpp"
#include "../process.hpp"
#include "../report_page.hpp"

/// What all parts of the report have in common.
namespace limpet::benchmarks {

struct PredicatesOptions {
  std::string folder;              ///< for the report
  std::string scratch;             ///< for scans, cases and models: below folder, taken away at the end
  std::string data;                ///< real scans; those that are absent are left out
  std::string commit = "unknown";  ///< as it is to be named
  bool full = false;
  std::vector<std::string> parts;
};

/// The three builds of geometry/, the exact one first.
inline constexpr std::array kBuilds = {"exact", "float-grid", "float"};
/// By their places in kBuilds.
inline constexpr std::array<std::size_t, 2> kFloatBuilds = {1, 2};

/// Programs of the build folder this program lies in.
std::string model_program(std::size_t build);
std::string replay_program(std::size_t build);
std::string operations_program(std::size_t build);
/// The exact build that counts what its filters did.
std::string counted_model_program();
std::string counted_operations_program();

/// A regime of coordinates, and whether inputs are in general position or degenerate.
struct Setting {
  std::string regime;  ///< grid, free or far
  bool general = false;
  std::string position() const { return general ? "general" : "degenerate"; }
};
std::vector<Setting> all_settings();

/// The lines of output that are JSON objects.
std::vector<Json> told_lines(const std::string& output);

/// Calls f(build) for all builds, in another order each round: what else the machine does falls on all.
template <class F>
void in_turn(int round, F&& f) {
  for (std::size_t k = 0; k < kBuilds.size(); ++k) f((k + static_cast<std::size_t>(round)) % kBuilds.size());
}

/// Replays a file of cases through all builds in turn, `rounds` times; for each build what each case came to:
/// the fastest "us" of all rounds, the rest of the first round, which is judged. A case that did not end
/// has "ended".
std::array<std::vector<Json>, kBuilds.size()> replay_in_turn(const std::string& cases, std::size_t count,
                                                             int rounds, int repeats);
/// One round of it by any program that tells the same; `so_far` may be empty.
void replay_once(std::vector<std::string> command, std::size_t count, std::vector<Json>& so_far);

void add_broken_laws(const PredicatesOptions&, ReportPage&);
void add_operation_costs(const PredicatesOptions&, ReportPage&);
void add_runs(const PredicatesOptions&, ReportPage&);
void add_unions(const PredicatesOptions&, ReportPage&);
void add_corpus(const PredicatesOptions&, ReportPage&);
void add_filters(const PredicatesOptions&, ReportPage&);

}  // namespace limpet::benchmarks
