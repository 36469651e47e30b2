// Copyright the limpet authors. GPL-3.0-or-later.
//
// Random operations in each build, from the same seeds: which laws break.
#include <cstdio>

#include "../../tests/cases/perimeter_case.hpp"
#include "builds.hpp"

namespace limpet::benchmarks {
namespace {

constexpr std::uint64_t kOperationsOfAll = 5000, kOperationsOfFull = 50'000;

std::string listed(const Json& signals) {
  std::string text;
  for (const auto& [name, count] : signals.items())
    text += (text.empty() ? "" : ", ") + name + " " + count.dump();
  return text;
}

/// How often each law broke in one operation, and of how many.
struct Broken {
  std::array<std::uint64_t, cases::kPerimeterLaws.size()> laws{};
  std::uint64_t operations = 0;
  void add(const Json& kind) {
    for (std::size_t law = 0; law < laws.size(); ++law)
      laws[law] += kind.at(std::string("broken_") + cases::kPerimeterLaws[law]).get<std::uint64_t>();
    for (const char* outcome : {"changed", "nothing_to_do", "refused"})
      operations += kind.at(outcome).get<std::uint64_t>();
  }
  void append_to(std::vector<Json>& row) const {
    for (const std::uint64_t count : laws) row.emplace_back(count);
  }
};

std::vector<Table::Column> with_laws(std::vector<Table::Column> columns) {
  for (const char* law : cases::kPerimeterLaws) columns.push_back({law});
  return columns;
}

}  // namespace

void add_broken_laws(const PredicatesOptions& options, ReportPage& report) {
  auto columns = with_laws({{"position"}, {"regime"}, {"build"}, {"operations"}});
  columns.insert(columns.end(), {{"hangs"}, {"crashes"}, {"signals"}});
  Table table(columns);
  std::array<std::array<Broken, cases::kOperations.size()>, kBuilds.size()> by_operation;
  for (const Setting& setting : all_settings())
    for (std::size_t build = 0; build < kBuilds.size(); ++build) {
      std::fprintf(stderr, "laws: %s, %s, %s\n", setting.position().c_str(), setting.regime.c_str(),
                   kBuilds[build]);
      const std::uint64_t wanted = options.full ? kOperationsOfFull : kOperationsOfAll;
      std::vector<std::string> command{operations_program(build), "--operations", std::to_string(wanted),
                                       "--regime", setting.regime};
      if (setting.general) command.push_back("--general");
      const ChildEnd end = run_program(command, {});
      const Json told = Json::parse(end.output, nullptr, false);
      if (!told.is_object()) throw std::runtime_error(command[0] + ": " + end.how());
      Broken all;
      for (std::size_t k = 0; k < cases::kOperations.size(); ++k) {
        const Json& kind = told.at("kinds").at(cases::kOperations[k]);
        all.add(kind);
        by_operation[build][k].add(kind);
      }
      std::vector<Json> row{setting.position(), setting.regime, kBuilds[build], told.at("operations")};
      all.append_to(row);
      row.insert(row.end(), {told.at("hangs"), told.at("crashes"), listed(told.at("signals"))});
      table.add(row);
    }
  report.add("What random operations break",
             "Operations on growing polygons, from the same seeds in each build; the whole polygon is judged "
             "after each, and given up once a law broke. Counts by law.",
             table, "laws", true);
  Table operations(with_laws({{"operation"}, {"build"}, {"operations"}}));
  for (std::size_t k = 0; k < cases::kOperations.size(); ++k)
    for (std::size_t build = 0; build < kBuilds.size(); ++build) {
      std::vector<Json> row{cases::kOperations[k], kBuilds[build], by_operation[build][k].operations};
      by_operation[build][k].append_to(row);
      operations.add(row);
    }
  report.add("The same by operation", "All regimes together.", operations, "laws_by_operation");
}

}  // namespace limpet::benchmarks
