// Copyright the limpet authors. GPL-3.0-or-later.
//
// What exactness costs in single operations: the same recorded steps in each build.
#include <algorithm>
#include <cstdio>

#include "builds.hpp"
#include "case_list.hpp"
#include "instructions.hpp"
#include "ratios.hpp"
#include "record.hpp"

namespace limpet::benchmarks {
namespace {

using cases::PerimeterCase;

struct Effort {
  std::size_t each = 100;  ///< cases of every operation
  int rounds = 3, repeats = 5;
  std::size_t counted = 12;  ///< of every operation, whose instructions are counted
};

/// Did both builds do the same to a case? Only then their times compare.
bool same_work(const Json& a, const Json& b) {
  return a.contains("us") && b.contains("us") && a["outcome"] == b["outcome"] &&
         a["attempts"] == b["attempts"];
}

/// Instructions of an operation alone in some cases, in each build; nothing where not counted.
std::array<Json, kBuilds.size()> count_each(const std::vector<PerimeterCase>& some,
                                            const PredicatesOptions& options) {
  std::array<Json, kBuilds.size()> counted;
  if (some.empty()) return counted;
  const std::string path = options.scratch + "/counted.cases";
  save_cases(path, some);
  for (std::size_t build = 0; build < kBuilds.size(); ++build)
    if (const auto count = count_instructions_within(
            "limpet::cases::PerimeterTrial::apply()",
            {replay_program(build), "perimeters", path, "--together"}, options.scratch))
      counted[build] = *count;
  return counted;
}

void add_rows(const Setting& setting, const Effort& effort, const PredicatesOptions& options, Table& table) {
  const std::string path = options.scratch + "/operations.cases";
  const auto list = record_operations(setting, effort.each, 1);
  save_cases(path, list);
  const auto told = replay_in_turn(path, list.size(), effort.rounds, effort.repeats);
  for (std::size_t k = 0; k < cases::kOperations.size(); ++k) {
    std::vector<double> us;
    std::array<std::vector<double>, kBuilds.size()> ratios;
    std::array<std::size_t, kBuilds.size()> other{};
    std::vector<PerimeterCase> some;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (static_cast<std::size_t>(list[i].steps[0].operation) != k) continue;
      if (told[0][i].contains("us")) us.push_back(told[0][i]["us"]);
      bool all_same = true;
      for (const std::size_t build : kFloatBuilds)
        if (same_work(told[0][i], told[build][i]))
          ratios[build].push_back(told[0][i]["us"].get<double>() / told[build][i]["us"].get<double>());
        else
          ++other[build], all_same = false;
      if (all_same && some.size() < effort.counted) some.push_back(list[i]);
    }
    const auto counted = count_each(some, options);
    std::vector<Json> row{setting.position(), setting.regime, cases::kOperations[k], us.size(),
                          spread_of(us).median};
    for (const std::size_t build : kFloatBuilds) {
      const Spread s = spread_of(ratios[build]);
      row.insert(row.end(), {s.median, s.low, s.high, quotient(counted[0], counted[build]), other[build]});
    }
    table.add(row);
  }
}

}  // namespace

void add_operation_costs(const PredicatesOptions& options, ReportPage& report) {
  Effort effort;
  if (options.full) effort = {.each = 1000, .rounds = 5, .repeats = 20, .counted = 200};
  std::vector<Table::Column> columns{{"position"}, {"regime"}, {"operation"}, {"cases"}, {"exact_us"}};
  for (const std::size_t build : kFloatBuilds)
    for (const char* what : {"time_ratio", "low", "high", "instructions_ratio", "other"})
      columns.push_back({std::string(what) + "_" + kBuilds[build]});
  Table table(columns);
  for (const Setting& setting : all_settings()) {
    std::fprintf(stderr, "operations: %s, %s\n", setting.position().c_str(), setting.regime.c_str());
    add_rows(setting, effort, options, table);
  }
  report.add(
      "What exactness costs in an operation",
      "The same steps in each build, each from the polygon that the exact build had come to. Ratios are "
      "exact over float: the median over the cases, and where a tenth is below and above; instructions "
      "of a sample by callgrind. *Other*: cases that the float build ended in another way; they have no "
      "ratio.",
      table, "operations", true);
}

}  // namespace limpet::benchmarks
