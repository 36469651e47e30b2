// Copyright the limpet authors. GPL-3.0-or-later.
//
// How well does a simulated robot follow a surface? Every run is judged by the truth.
//
//     limpet_following_bench worlds [--worlds cube,L] [--noise 0,0.002] [--ceilings 1,2]
//     limpet_following_bench table1 [--robots point,arm] [--avoidance programme,thesis]
//                                                         range images, beside thesis Table 1
//     limpet_following_bench parts FILE…                  mesh files, λ by the object
//     limpet_following_bench sensitivity [--only γ,μ]     each parameter at ½ to twice its usual value
//     limpet_following_bench faults                       poor sensors
//     limpet_following_bench memory [--sets 100000]       a run that goes on and on
//
// for all: --strategy, --starts, --first-seed, --workers, --oracle, --json FILE, --scenes FOLDER.
// docs/benchmarks.md says what the figures mean.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "../program.hpp"
#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

struct Arguments {
  RunPlan plan;
  std::string json, scenes, request;
  std::vector<std::string> files;
  WorldOptions worlds;
  Table1Options table1;
  VariedOptions varied;
  MemoryOptions memory;
};

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

/// The scene of each run as a file for `limpet follow`.
void write_scenes(const std::vector<MadeRun>& runs, const std::string& folder) {
  std::filesystem::create_directories(folder);
  for (std::size_t i = 0; i < runs.size(); ++i)
    write(folder + "/" + std::to_string(i + 1) + ".toml", "# " + runs[i].wanted.name + ", seed " +
                                                              std::to_string(runs[i].wanted.seed) + "\n" +
                                                              runs[i].wanted.scene);
}

Json to_json(const Measured& measured, const RunPlan& plan) {
  Json tables = Json::array();
  for (const auto& [title, table] : measured.tables)
    tables.push_back({{"title", title}, {"table", table.json()}});
  return {{"strategy", plan.strategy}, {"tables", tables}, {"runs", to_json(measured.runs)}};
}

void show(const Measured& measured, const Arguments& args) {
  for (const auto& [title, table] : measured.tables)
    std::printf("%s\n\n%s\n", title.c_str(), table.markdown().c_str());
  if (const std::string faults = faults_text(measured.runs); !faults.empty())
    std::printf("Runs that fell short:\n\n%s", faults.c_str());
  if (!args.json.empty()) write(args.json, to_json(measured, args.plan).dump(1) + "\n");
  if (!args.scenes.empty()) write_scenes(measured.runs, args.scenes);
}

/// In the process that measures.
Json answer(const Json& request) {
  const std::string what = request.at("what");
  if (what == "run") return measure_run(request.at("case").get<RunCase>());
  if (what == "memory") return answer_memory(request);
  throw std::invalid_argument("no such measurement: " + what);
}

CLI::App* add_section(CLI::App& app, Arguments& args, const std::string& name, const std::string& what,
                      const std::function<Measured()>& measure) {
  auto* c = app.add_subcommand(name, what);
  c->callback([&args, measure] { show(measure(), args); });
  return c;
}

void add_plan(CLI::App& app, Arguments& args) {
  RunPlan& plan = args.plan;
  app.add_option("--strategy", plan.strategy)->check(CLI::IsMember({"frontier", "thesis"}));
  app.add_option("--starts", plan.starts, "runs of each kind, with a start, heading and noise of their own")
      ->check(CLI::PositiveNumber);
  app.add_option("--first-seed", plan.first_seed);
  app.add_option("--resolution", plan.resolution, "λ; of parts by the object");
  app.add_option("--max-sets", plan.max_sets, "a run ends after so many");
  app.add_option("--max-seconds", plan.max_seconds, "and after so long");
  app.add_option("--oracle", plan.oracle_every, "the oracle judges the model after every so many sets");
  app.add_flag("--tour", plan.tour, "compare with offline tours: slow");
  app.add_option("--workers", plan.workers, "processes at a time; times are right with 1")
      ->check(CLI::Range(1, 64));
  app.add_option("--json", args.json, "all figures, and the scenes that they are of");
  app.add_option("--scenes", args.scenes,
                 "a folder for the scenes, from which `limpet follow` makes the runs");
}

void add_sections(CLI::App& app, Arguments& args) {
  const auto noise = [&args](CLI::App* c) {
    c->add_option("--noise", args.plan.noise, "standard deviation of a reading");
  };
  auto* worlds = add_section(app, args, "worlds", "Named shapes, from random starts",
                             [&args] { return measure_worlds(args.plan, args.worlds); });
  worlds->add_option("--worlds", args.worlds.worlds)->delimiter(',');
  worlds->add_option("--noise", args.worlds.noise, "standard deviations of a reading")->delimiter(',');
  worlds->add_option("--ceilings", args.worlds.ceilings, "γ, in λ")->delimiter(',');

  auto* table1 =
      add_section(app, args, "table1", "Range images from one side, beside thesis Table 1", [&args] {
        args.plan.noise = 0;
        return measure_table1(args.plan, args.table1);
      });
  table1->add_option("--robots", args.table1.robots)->delimiter(',')->check(CLI::IsMember({"point", "arm"}));
  table1->add_option("--strategies", args.table1.strategies)->delimiter(',');
  table1->add_option("--avoidance", args.table1.avoidance, "how an arm's links are kept off")
      ->delimiter(',')
      ->check(CLI::IsMember({"programme", "thesis"}));
  table1->add_option("--pitch", args.table1.pitch, "of the range images");
  table1->add_flag("!--no-curved", args.table1.curved);

  auto* parts = add_section(app, args, "parts", "Mesh files", [&args, &app] {
    if (app.count("--resolution") == 0) args.plan.resolution = 0;
    return measure_parts(args.plan, args.files);
  });
  parts->add_option("FILE", args.files)->required()->check(CLI::ExistingFile);
  noise(parts);

  auto* sensitivity = add_section(app, args, "sensitivity", "Each parameter at 1/2 to twice its usual value",
                                  [&args] { return measure_sensitivity(args.plan, args.varied); });
  auto* faults = add_section(app, args, "faults", "Poor sensors",
                             [&args] { return measure_faults(args.plan, args.varied); });
  for (auto* c : {sensitivity, faults}) {
    c->add_option("--worlds", args.varied.worlds)->delimiter(',');
    c->add_option("--only", args.varied.only, "rows of these names")->delimiter(',');
    noise(c);
  }

  auto* memory = add_section(app, args, "memory", "A run that goes on and on",
                             [&args] { return measure_memory(args.plan, args.memory); });
  memory->add_option("--worlds", args.memory.worlds)->delimiter(',');
  memory->add_option("--sets", args.memory.sets);
  memory->add_option("--every", args.memory.every, "sets between two looks");
  noise(memory);
}

int run(int argc, char** argv) {
  Arguments args;
  CLI::App app{"Measures how well a simulated robot follows surfaces"};
  app.require_subcommand(1);
  app.fallthrough();
  add_plan(app, args);
  add_sections(app, args);
  auto* c = app.add_subcommand("answer")->group("");
  c->add_option("request", args.request)->required();
  c->callback([&args] { std::cout << answer(Json::parse(args.request)).dump() << std::endl; });
  CLI11_PARSE(app, argc, argv);
  return 0;
}

}  // namespace
}  // namespace limpet::benchmarks

int main(int argc, char** argv) {
  return limpet::benchmarks::told_in_a_line("limpet_following_bench",
                                            [&] { return limpet::benchmarks::run(argc, argv); });
}
