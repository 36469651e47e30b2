// Copyright the limpet authors. GPL-3.0-or-later.
//
// How often each predicate's filter gave no answer, and exact numbers had to: counted by the exact build
// itself, in its own filter and in those of CGAL (CGAL_PROFILE), and told at the program's end.
#include <cstdio>
#include <map>
#include <regex>
#include <sstream>

#include "run_scans.hpp"

namespace limpet::benchmarks {
namespace {

/// Of one filter: how often it was asked, and gave no answer.
struct Stage {
  double calls = 0, failures = 0;
};
using Stages = std::map<std::string, Stage>;

/// CGAL writes 1.234.567.
double number(std::string text) {
  std::erase(text, '.');
  return std::stod(text);
}

/// The filter that a line of CGAL's counters is about; empty: none. "intervals" decide a predicate where the
/// doubles before them did not, or where points are lazy; exact numbers follow. Lazy numbers are made exact
/// where they must be rounded the same everywhere: that is no failure, and CGAL does not count it as one.
std::string filter_of(const std::string& line) {
  static const std::regex own(R"(limpet::geometry::internal::orientation_filter)");
  static const std::regex semi_static(R"(semi-static failures.*: (\w+))");
  static const std::regex predicate(
      R"(EP = CGAL::\w+::(\w+)<CGAL::Simple_cartesian<(CGAL::Mpzf|__gmp_expr))");
  static const std::regex construction(R"(failures/calls.*Lazy_(construction|exact_nt))");
  std::smatch match;
  if (std::regex_search(line, own)) return "1 orientation: own filter, doubles";
  if (std::regex_search(line, match, semi_static))
    return "2 " + match[1].str() + ": CGAL's static filter, doubles";
  if (std::regex_search(line, match, predicate)) return "3 " + match[1].str() + ": intervals";
  return std::regex_search(line, construction) ? "4 lazy constructions: intervals" : "";
}

void add(const std::string& told, Stages& stages) {
  static const std::regex two(R"(\] +([\d.]+) / +([\d.]+) )"),
      three(R"(\] +([\d.]+) / +([\d.]+) / +([\d.]+) )");
  std::istringstream lines(told);
  for (std::string line; std::getline(lines, line);) {
    const std::string filter = filter_of(line);
    std::smatch match;
    if (filter.empty() || line.find("attempts/calls") != std::string::npos) {
      // failures / attempts / calls; those not attempted count as failures
      if (filter.empty() || !std::regex_search(line, match, three)) continue;
      stages[filter].calls += number(match[3]);
      stages[filter].failures += number(match[3]) - number(match[2]) + number(match[1]);
    } else if (std::regex_search(line, match, two)) {
      stages[filter].calls += number(match[2]);
      stages[filter].failures += number(match[1]);
    }
  }
}

void count(const std::vector<std::string>& command, Stages& stages) {
  ChildLimits limits;
  limits.cpu_seconds = 300;
  limits.with_errors = true;
  const ChildEnd end = run_program(command, limits);
  // A model that falls short (1) is counted like any other; no program, or a scan that is refused, is not.
  if (end.signal != 0 || end.hang || end.exit_code > 1)
    throw std::runtime_error(command[0] + ": " + end.how());
  add(end.output, stages);
}

void add_rows(Table& table, const std::string& where, const std::string& regime, const Stages& stages) {
  for (const auto& [filter, stage] : stages)
    table.add({where, regime, filter.substr(2), stage.calls, stage.failures,
               stage.calls > 0 ? 100 * stage.failures / stage.calls : 0.0});
}

}  // namespace

void add_filters(const PredicatesOptions& options, ReportPage& report) {
  Table table({{"where"}, {"regime"}, {"filter"}, {"calls", 1}, {"no_answer", 1}, {"percent", 2}});
  for (const Setting& setting : all_settings()) {
    std::fprintf(stderr, "filters: %s operations, %s\n", setting.position().c_str(), setting.regime.c_str());
    std::vector<std::string> command{counted_operations_program(),   "--replay", "1",           "--found",
                                     options.scratch + "/none.case", "--regime", setting.regime};
    if (setting.general) command.push_back("--general");
    Stages stages;
    count(command, stages);
    add_rows(table, setting.position() + " operations", setting.regime, stages);
  }
  std::map<std::pair<std::string, std::string>, Stages> runs;
  auto scans = small_scans(options);
  for (auto& scan : real_scans(options)) scans.push_back(scan);
  for (const RunScan& scan : scans) {
    std::fprintf(stderr, "filters: %s, %s\n", scan.name.c_str(), scan.regime.c_str());
    std::vector<std::string> command{counted_model_program(), "model"};
    const auto arguments = scan.arguments();
    command.insert(command.end(), arguments.begin(), arguments.end());
    command.insert(command.end(), {"-o", options.scratch + "/counted.limpet", "--quiet"});
    count(command, runs[{scan.source + " scans", scan.regime}]);
  }
  for (const auto& [where, stages] : runs) add_rows(table, where.first, where.second, stages);
  report.add(
      "How often filters gave no answer",
      "A predicate is decided by the first of its stages that is certain; what intervals leave open, exact "
      "numbers decide. 2,000 operations a row, and whole runs.",
      table, "filters");
}

}  // namespace limpet::benchmarks
