// Copyright the limpet authors. GPL-3.0-or-later.
//
// How fast are points modelled, in how much memory, and how late? Beside the least that a point costs and
// beside CGAL's plane detectors and its PolyFit, which see the same cloud.
//
//     limpet_bench throughput --shapes cube,city:100 --points 1000000 [--orders shuffled,raster] [--runs 3]
//                             [--no-cgal | --contestants limpet,ransac] [--noise 0.002] [--csv FILE]
//     limpet_bench default [--full]                            `limpet model` as it comes, beside CGAL's
//     limpet_bench streams --shapes cube --points 10000000     one long stream, looked at on its way
//     limpet_bench sizes --boxes 1,10,100                      cities, as many points for each face
//     limpet_bench latency --boxes 200                         how long one set of 26 takes
//     limpet_bench hostile [--shapes holes,noise] [--full]     the same of clouds that are hard on a model
//     limpet_bench view --boxes 9,200,1000                     how long questions to a model take
//     limpet_bench redundancy                                   the thresholds of thesis §2.9
//     limpet_bench polyhedra --shapes cube,step_hole           whole polyhedra beside PolyFit's
//     limpet_bench report --out DIR [--full]                   all of these: report.md, CSV files
//
// Every measurement runs in a process of its own (process.hpp). docs/benchmarks.md says what figures mean.
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>

#include <CLI/CLI.hpp>

#include "contestants.hpp"
#include "program.hpp"
#include "report.hpp"
#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

Json answer_cloud(const Json& request) {
  const ScanCase scan_case(request.at("spec").get<CloudSpec>());
  return {{"points", write_cloud(scan_case, request.at("cloud"))},
          {"faces", scan_case.faces.size()},
          {"resolution", scan_case.resolution}};
}

/// In the process that measures.
Json answer(const Json& request) {
  const std::string what = request.at("what");
  if (what == "cloud") return answer_cloud(request);
  if (what == "limpet") return answer_limpet(request);
  if (what == "default") return answer_default(request);
  if (what == "region_growing") return answer_region_growing(request);
  if (what == "ransac") return answer_ransac(request);
  if (what == "polyfit") return answer_polyfit(request);
  if (what == "judgement") return answer_judgement(request);
  if (what == "stream") return answer_stream(request);
  if (what == "latency") return answer_latency(request);
  if (what == "hostile") return answer_hostile(request);
  if (what == "view") return answer_view(request);
  throw std::invalid_argument("no such measurement: " + what);
}

void show(const Table& table, const std::string& csv) {
  std::fputs((table.markdown() + "\n").c_str(), stdout);
  if (!csv.empty()) table.write_csv(csv);
}

struct Arguments {
  Limits limits;
  std::string csv;
  std::vector<std::string> shapes{"cube", "city:100"};
  std::vector<std::int64_t> points{1'000'000};
  std::int64_t first_mark = 100'000;
  double noise_ratio = 0.002;
  bool no_cgal = false;
  ThroughputOptions throughput;
  std::vector<std::string> orders{"shuffled", "raster"};
  DefaultRunOptions default_run;
  SizeOptions sizes;
  LatencyOptions latency;
  HostileOptions hostile;
  ViewOptions view;
  PolyhedraOptions polyhedra;
  RedundancyOptions redundancy;
  std::string request;
  ReportOptions report;
};

void add_throughput(CLI::App& app, Arguments& args) {
  auto* c = app.add_subcommand("throughput", "Contestants on the same clouds");
  c->add_option("--shapes", args.shapes)->delimiter(',');
  c->add_option("--orders", args.orders, "shuffled, raster, sampled")->delimiter(',');
  c->add_option("--points", args.points)->delimiter(',');
  c->add_option("--noise", args.noise_ratio, "as a fraction of the shape's size");
  c->add_option("--runs", args.throughput.runs, "of limpet: the best of so many counts");
  c->add_option("--peer-runs", args.throughput.peer_runs, "of the others");
  c->add_option("--contestants", args.throughput.contestants)
      ->delimiter(',')
      ->check(CLI::IsMember(contestant_names()));
  c->add_flag("--no-cgal", args.no_cgal);
  c->add_option("--csv", args.csv);
  c->callback([&args] {
    if (args.no_cgal) args.throughput.contestants = {"limpet"};
    ThroughputTables tables;
    for (const auto& shape : args.shapes)
      for (const auto points : args.points)
        for (const auto& order : args.orders)
          measure_throughput(
              {.shape = shape, .order = order, .points = points, .noise_ratio = args.noise_ratio},
              args.throughput, args.limits, tables);
    show(tables.contestants, args.csv);
    std::puts("limpet's nanoseconds per point, by stage:\n");
    show(tables.stages, "");
  });
}

void add_streams(CLI::App& app, Arguments& args) {
  auto* c = app.add_subcommand("streams", "One long stream, looked at on its way");
  c->add_option("--shapes", args.shapes)->delimiter(',');
  c->add_option("--points", args.points)->expected(1);
  c->add_option("--first-mark", args.first_mark, "where it is looked at first; λ suits so many points");
  c->add_option("--csv", args.csv);
  c->callback([&args] {
    std::vector<StreamOptions> streams;
    for (const auto& shape : args.shapes)
      streams.push_back(stream_of(shape, args.points.at(0), args.first_mark));
    show(measure_streams(streams, args.limits), args.csv);
  });
}

void add_default(CLI::App& app, Arguments& args) {
  auto* c = app.add_subcommand("default", "limpet model as it comes, beside CGAL's detectors");
  c->add_flag("--full", args.default_run.full, "10^7 points, 5001 faces");
  c->add_option("--runs", args.default_run.throughput.runs);
  c->add_option("--contestants", args.default_run.throughput.contestants)
      ->delimiter(',')
      ->check(CLI::IsMember(contestant_names()));
  c->add_option("--csv", args.csv);
  c->callback([&args] { show(measure_default_run(args.default_run, args.limits), args.csv); });
}

void add_sizes(CLI::App& app, Arguments& args) {
  auto* c = app.add_subcommand("sizes", "Cities of n boxes, as many points for each face");
  c->add_option("--boxes", args.sizes.boxes)->delimiter(',');
  c->add_option("--orders", args.sizes.orders)->delimiter(',');
  c->add_option("--runs", args.sizes.throughput.runs);
  c->add_option("--contestants", args.sizes.throughput.contestants)
      ->delimiter(',')
      ->check(CLI::IsMember(contestant_names()));
  c->add_option("--csv", args.csv);
  c->callback([&args] { show(measure_sizes(args.sizes, args.limits).contestants, args.csv); });
}

void add_latency(CLI::App& app, Arguments& args) {
  auto* c = app.add_subcommand("latency", "How long one set of 26 takes, in a city");
  c->add_option("--boxes", args.latency.boxes);
  c->add_option("--orders", args.latency.orders, "sampled, raster")->delimiter(',');
  c->add_option("--csv", args.csv);
  c->callback([&args] { show(measure_latency(args.latency, args.limits), args.csv); });
}

void add_hostile(CLI::App& app, Arguments& args) {
  auto* c = app.add_subcommand("hostile", "How long one set of 26 takes, of clouds that are hard on a model");
  c->add_option("--shapes", args.hostile.shapes)
      ->delimiter(',')
      ->check(CLI::IsMember({"holes", "combs", "planes", "noise", "city:200"}));
  c->add_flag("--full", args.hostile.full, "larger ones, too");
  c->add_option("--csv", args.csv);
  c->callback([&args] {
    const HostileTables tables = measure_hostile(args.hostile, args.limits);
    show(tables.times, args.csv);
    std::puts("How this grows with the number of points, by stage:\n");
    show(tables.growth, "");
  });
}

void add_view(CLI::App& app, Arguments& args) {
  auto* c = app.add_subcommand("view", "How long questions to a model take, in cities");
  c->add_option("--boxes", args.view.boxes)->delimiter(',');
  c->add_option("--csv", args.csv);
  c->callback([&args] { show(measure_view(args.view, args.limits), args.csv); });
}

void add_polyhedra(CLI::App& app, Arguments& args) {
  PolyhedraOptions& options = args.polyhedra;
  auto* c = app.add_subcommand("polyhedra", "Whole polyhedra, beside PolyFit's");
  c->add_option("--shapes", options.shapes)->delimiter(',');
  c->add_option("--points", options.points, "for up to 16 faces; for more as many for each")->delimiter(',');
  c->add_option("--contestants", options.contestants)
      ->delimiter(',')
      ->check(CLI::IsMember({"limpet", "polyfit"}));
  c->add_option("--csv", args.csv);
  c->callback([&args] {
    Table table = polyhedra_table();
    measure_polyhedra(args.polyhedra, args.limits, table);
    show(table, args.csv);
  });
}

void add_redundancy(CLI::App& app, Arguments& args) {
  RedundancyOptions& options = args.redundancy;
  auto* c = app.add_subcommand("redundancy", "How psi and phi behave (thesis 2.9)");
  c->add_option("--shapes", options.shapes)->delimiter(',');
  c->add_option("--orders", options.orders)->delimiter(',');
  c->add_option("--points", options.points);
  c->add_option("--noise", options.noise_ratio, "as a fraction of the shape's size");
  c->add_option("--outliers", options.outliers, "fraction");
  c->add_option("--rules", options.rules, "sets of rules, each an argument");
  c->add_option("--psi", options.psi)->delimiter(',');
  c->add_option("--phi", options.phi)->delimiter(',');
  c->add_option("--seeds", options.seeds);
  c->add_option("--csv", args.csv);
  c->callback([&args] { show(measure_redundancy(args.redundancy), args.csv); });
}

void add_report(CLI::App& app, Arguments& args) {
  auto* c = app.add_subcommand("report", "All of these");
  c->add_option("--out", args.report.folder)->required();
  c->add_option("--commit", args.report.commit, "as it is to be named in the report");
  c->add_flag("--full", args.report.full, "10^8 points, cities of up to 1000 boxes, more runs; hours");
  c->add_option("--parts", args.report.parts)
      ->delimiter(',')
      ->check(CLI::IsMember(
          {"default", "latency", "hostile", "streams", "sizes", "polyhedra", "redundancy", "throughput"}));
  c->callback([&args] { write_report(args.report, args.limits); });
}

int run(int argc, char** argv) {
  Arguments args;
  CLI::App app{"Measures how fast points are modelled, in how much memory, and how late"};
  app.require_subcommand(1);
  app.fallthrough();
  app.add_option("--limit", args.limits.peer_seconds, "seconds for one process of a peer");
  app.add_option("--scratch", args.limits.scratch, "folder for clouds, 56 bytes a point");
  add_default(app, args);
  add_throughput(app, args);
  add_streams(app, args);
  add_sizes(app, args);
  add_latency(app, args);
  add_hostile(app, args);
  add_view(app, args);
  add_polyhedra(app, args);
  add_redundancy(app, args);
  add_report(app, args);
  auto* c = app.add_subcommand("answer")->group("");
  c->add_option("request", args.request)->required();
  c->callback([&args] { std::cout << answer(Json::parse(args.request)).dump() << std::endl; });
  CLI11_PARSE(app, argc, argv);
  return 0;
}

}  // namespace
}  // namespace limpet::benchmarks

int main(int argc, char** argv) {
  return limpet::benchmarks::told_in_a_line("limpet_bench",
                                            [&] { return limpet::benchmarks::run(argc, argv); });
}
