// Copyright the limpet authors. GPL-3.0-or-later.
//
// What exactness costs, and what goes wrong without it: limpet, limpet-float-grid and limpet-float, in
// processes of their own, on the same operations, pairs of polygons, streams and scans (docs/predicates.md).
//
//     limpet_predicates report --out DIR [--full] [--data DIR] [--parts laws,runs,...]
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "../program.hpp"
#include "builds.hpp"
#include "union_answers.hpp"

namespace limpet::benchmarks {
namespace {

using Part = void (*)(const PredicatesOptions&, ReportPage&);

/// In the order in which they are measured.
const std::vector<std::pair<std::string, Part>>& all_parts() {
  static const std::vector<std::pair<std::string, Part>> parts{
      {"laws", add_broken_laws}, {"operations", add_operation_costs},
      {"runs", add_runs},        {"unions", add_unions},
      {"corpus", add_corpus},    {"filters", add_filters}};
  return parts;
}

void write_report(PredicatesOptions options) {
  ReportPage report(
      options.folder, options.commit,
      "# Exactness, measured\n\nWhat is measured, and how to read it: docs/predicates.md.\n",
      {"runs", "runs_faults", "operations", "laws", "laws_by_operation", "unions", "corpus", "filters"});
  options.scratch = options.folder + "/scratch";
  std::filesystem::create_directories(options.scratch);
  for (const auto& [name, add] : all_parts())
    if (options.parts.empty() ||
        std::find(options.parts.begin(), options.parts.end(), name) != options.parts.end())
      add(options, report);
  std::filesystem::remove_all(options.scratch);
}

int run(int argc, char** argv) {
  CLI::App app{"What exactness costs, and what goes wrong without it"};
  app.require_subcommand(1);
  PredicatesOptions options;
  const char* data = std::getenv("LIMPET_DATA");
  options.data = data ? data : "../shared/data";
  std::vector<std::string> names;
  for (const auto& [name, add] : all_parts()) names.push_back(name);
  auto* report = app.add_subcommand("report", "Measures all, or some parts");
  report->add_option("--out", options.folder, "Folder of the report")->required();
  report->add_option("--data", options.data, "Folder of real scans; those that are absent are left out");
  report->add_option("--commit", options.commit, "As it is to be named in the report");
  report->add_flag("--full", options.full, "More of everything: hours");
  report->add_option("--parts", options.parts)->delimiter(',')->check(CLI::IsMember(names));
  report->callback([&] { write_report(options); });

  auto* boost = app.add_subcommand("boost")->group("");
  std::string file;
  bool integers = false, judge = false;
  int repeats = 1;
  boost->add_option("FILE", file)->required();
  boost->add_flag("--integers,!--no-integers", integers);
  boost->add_option("--repeats", repeats);
  boost->add_flag("--judge", judge);
  boost->callback([&] { replay_by_boost(file, integers, repeats, judge); });
  CLI11_PARSE(app, argc, argv);
  return 0;
}

}  // namespace
}  // namespace limpet::benchmarks

int main(int argc, char** argv) {
  return limpet::benchmarks::told_in_a_line("limpet_predicates",
                                            [&] { return limpet::benchmarks::run(argc, argv); });
}
