// Copyright the limpet authors. GPL-3.0-or-later.
//
// Whole runs of `limpet model` by each build, in turn.
#include "runs.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "case_list.hpp"
#include "instructions.hpp"

namespace limpet::benchmarks {
namespace {

constexpr ChildLimits kRunLimits{.seconds = 1800, .cpu_seconds = 120, .megabytes = 6000, .with_errors = true};
constexpr double kLong = 2;  ///< seconds

Json json_file(const std::string& path) {
  if (!std::filesystem::exists(path)) return {};
  return Json::parse(load_text(path), nullptr, false);
}

/// An exception that nothing caught is told as a bug.
std::string ending(const ChildEnd& end) {
  return end.output.find("a bug in limpet") != std::string::npos ? "exception" : end.how();
}

std::vector<std::string> model_command(const RunScan& scan, std::size_t build, const std::string& stem) {
  std::vector<std::string> words{model_program(build), "model"};
  for (const std::string& word : scan.arguments()) words.push_back(word);
  words.insert(words.end(), {"-o", stem + ".limpet", "--json", stem + ".json", "-q"});
  return words;
}

void model_once(const RunScan& scan, std::size_t build, const std::string& stem, RunResult& result) {
  std::filesystem::remove(stem + ".json");
  std::filesystem::remove(stem + ".limpet");
  const ChildEnd end = run_program(model_command(scan, build, stem), kRunLimits);
  const std::string ended = ending(end);
  // 1: it fell short, which is told by its broken laws below.
  if (ended != "done" && ended != "exit 1") {
    result.ended = ended;
    return;
  }
  result.cpu_seconds.push_back(end.cpu_seconds);
  const Json summary = json_file(stem + ".json");
  if (!summary.is_object()) return;
  result.model_seconds.push_back(summary.at("seconds"));
  Json counts;
  for (const char* key : {"segments", "polygons", "holes", "shared_edges", "open_edges", "corner_vertices"})
    counts[key] = summary.at(key);
  result.summary = counts.dump();
  result.polygons = summary.at("polygons");
  result.closed = summary.at("closed");
}

/// By the exact build's oracle and judge, whoever made the model.
void judge(const RunScan& scan, const std::string& stem, RunResult& result) {
  const std::string model = stem + ".limpet", json = stem + "_judged.json";
  if (!std::filesystem::exists(model)) return;
  std::filesystem::remove(json);
  const ChildEnd checked = run_program({model_program(0), "check", model, "-q", "--json", json}, kRunLimits);
  const Json laws = json_file(json);
  if (laws.is_object()) {
    result.violations = laws.at("violations");
    std::map<std::string, int> counts;
    for (const Json& b : laws.at("broken")) ++counts[b.at("law")];
    for (const auto& [law, count] : counts)
      result.laws += (result.laws.empty() ? "" : ", ") + law + " " + std::to_string(count);
  } else if (!checked.done()) {
    result.violations = 1, result.laws = "cannot be judged (" + checked.how() + ")";
  }
  if (scan.truth.empty()) return;
  std::filesystem::remove(json);
  run_program({model_program(0), "compare", model, scan.truth, "-q", "--json", json}, kRunLimits);
  const Json compared = json_file(json);
  if (!compared.is_object()) return;
  result.true_faces = compared.at("true_faces");
  const Json &there = compared.at("model_to_truth").at("max"),
             &back = compared.at("truth_to_model").at("max");
  if (there.is_number() && back.is_number())
    result.distance = std::max(there.get<double>(), back.get<double>()) / scan.resolution;
}

RunResults measure(const RunScan& scan, int rounds, const PredicatesOptions& options) {
  RunResults results;
  const auto stem = [&](std::size_t build) { return options.scratch + "/model_" + kBuilds[build]; };
  std::fprintf(stderr, "runs: %s, %s\n", scan.name.c_str(), scan.regime.c_str());
  for (int round = 0; round < rounds; ++round) {
    // What takes long needs no repetition, and the report no hours.
    const auto& times = results[0].cpu_seconds;
    if (!options.full && !times.empty() && times.front() > kLong) break;
    in_turn(round, [&](std::size_t build) {
      if (results[build].ended != "hang") model_once(scan, build, stem(build), results[build]);
    });
  }
  for (std::size_t build = 0; build < kBuilds.size(); ++build) {
    judge(scan, stem(build), results[build]);
    if (results[build].ended != "done") continue;
    if (scan.counted || instruction_counter() == "perf")
      if (const auto count = count_instructions(model_command(scan, build, stem(build)), options.scratch))
        results[build].instructions = *count;
  }
  return results;
}

}  // namespace

void add_runs(const PredicatesOptions& options, ReportPage& report) {
  std::vector<RunScan> scans = simulated_scans(options);
  for (const RunScan& scan : real_scans(options)) scans.push_back(scan);
  if (instruction_counter() == "callgrind")
    for (const RunScan& scan : small_scans(options)) scans.push_back(scan);
  std::vector<RunResults> results;
  for (const RunScan& scan : scans)
    results.push_back(measure(scan, scan.counted ? 1 : options.full ? 7 : 3, options));
  const std::string& counter = instruction_counter();
  report.add("What exactness costs in whole runs",
             "`limpet model` with each build in turn, processor time of the whole program: exact over float; "
             "median over the scans, the smallest and the largest; and of all scans together. Runs that did "
             "not end have none. Instructions: " +
                 (counter == "perf"        ? std::string("by the processor's counter.")
                  : counter == "callgrind" ? std::string("by callgrind, on small scans.")
                                           : std::string("not counted here.")),
             run_cost_table(scans, results), "runs", true);
  report.add(
      "What whole runs end in",
      "Runs that ended otherwise than they should; models that break a law by the exact oracle, how many "
      "laws in all; of simulated scans, models with another number of faces than the truth, further than "
      "λ from it, or open where the exact build's is closed; models with other counts of segments, edges "
      "or corners than the exact build's. Each run: runs_all.csv.",
      run_fault_table(scans, results), "runs_faults");
  report.add("Each run", "", run_table(scans, results), "runs_all");
}

}  // namespace limpet::benchmarks
