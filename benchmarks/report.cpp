// Copyright the limpet authors. GPL-3.0-or-later.
#include "report.hpp"

#include <algorithm>
#include <map>

#include "report_page.hpp"

namespace limpet::benchmarks {
namespace {

void add_throughput(const ReportOptions& options, const Limits& limits, ReportPage& report) {
  // At 10⁵ points a smaller city, and no room, so that λ stays well below what is to be seen.
  struct Entry {
    const char* shape;
    std::int64_t points;
    double noise_ratio = 0.002;
  };
  constexpr double kFineNoise = 0.0005;  // σ ≤ λ/10
  constexpr std::int64_t kMany = 1'000'000;
  ThroughputTables tables;
  for (const Entry& e :
       {Entry{"cube", 100'000}, Entry{"step_hole", 100'000, kFineNoise}, Entry{"city:20", 100'000},
        Entry{"cube", kMany}, Entry{"step_hole", kMany, kFineNoise}, Entry{"city:100", kMany},
        Entry{"room", kMany}})
    for (const char* order : {"shuffled", "raster"}) {
      ThroughputOptions throughput;
      if (e.points == kMany && !options.full) throughput.runs = 1;
      // The order hardly matters to the peers, and it is their time that the report takes.
      if (order == std::string("raster") && !options.full) throughput.contestants = {"limpet"};
      measure_throughput({.shape = e.shape, .order = order, .points = e.points, .noise_ratio = e.noise_ratio},
                         throughput, limits, tables);
      report.add("Throughput", "Planes found in the same cloud, each contestant in a process of its own.",
                 tables.contestants, "throughput");
      report.add("Where the time goes", "Nanoseconds per point of limpet, by stage.", tables.stages,
                 "stages");
    }
}

void add_default(const ReportOptions& options, const Limits& limits, ReportPage& report) {
  report.add(
      "The default run",
      "`limpet model SCAN` with nothing given: reading the file, choosing λ, noise and tolerance, putting "
      "the points in order, updates and finishing; of the others finding planes alone.",
      measure_default_run({.full = options.full}, limits), "default");
}

void add_streams(const ReportOptions& options, const Limits& limits, ReportPage& report) {
  const std::int64_t points = options.full ? 100'000'000 : 10'000'000;
  report.add(
      "Against the length of the stream",
      "Points made on the fly, 1 % outliers, the same λ all along; memory is the peak so far.",
      measure_streams({stream_of("cube", points, 100'000), stream_of("city:100", points, 1'000'000)}, limits),
      "streams", true);
}

void add_sizes(const ReportOptions& options, const Limits& limits, ReportPage& report) {
  SizeOptions sizes;
  sizes.throughput.contestants = {"limpet", "region_growing"};
  sizes.throughput.runs = options.full ? 3 : 1;
  sizes.throughput.stages = options.full;
  if (options.full) sizes.boxes = {1, 3, 10, 30, 100, 300, 1000};
  const ThroughputTables tables = measure_sizes(sizes, limits);
  report.add("Against the size of the model", "Cities of n boxes, about 1,000 points for each face.",
             tables.contestants, "sizes", true);
  if (!tables.stages.empty())
    report.add("Where the time goes in larger models", "Nanoseconds per point of limpet, by stage.",
               tables.stages, "sizes_stages");
}

void add_latency(const ReportOptions& options, const Limits& limits, ReportPage& report) {
  LatencyOptions latency;
  if (options.full) latency.boxes = 1000;
  report.add("Latency of a set of 26 readings",
             "Microseconds, while the model is built and after the whole city has been seen.",
             measure_latency(latency, limits), "latency");
}

void add_hostile(const ReportOptions& options, const Limits& limits, ReportPage& report) {
  const HostileTables tables = measure_hostile({.full = options.full}, limits);
  report.add("Hostile streams",
             "Sets of 26 readings of clouds that are hard on a model, in random order; processor time.",
             tables.times, "hostile");
  report.add("How hostile streams grow",
             "By stage: all of its time and the most that it took of one set, at the largest size, and the "
             "exponents by which they grow with the number of points.",
             tables.growth, "hostile_growth");
}

void add_polyhedra(const ReportOptions& options, const Limits& limits, ReportPage& report) {
  PolyhedraOptions polyhedra;
  if (!options.full) polyhedra.shapes = {"cube", "L", "step_hole", "city:3"}, polyhedra.points = {20'000};
  Table table = polyhedra_table();
  measure_polyhedra(polyhedra, limits, table);
  report.add("Whole polyhedra",
             "limpet's models beside PolyFit's; distances in units of λ, times in seconds.", table,
             "polyhedra");
}

void add_redundancy(const ReportOptions& options, const Limits&, ReportPage& report) {
  RedundancyOptions redundancy;
  if (!options.full) redundancy.seeds = 2;
  report.add("Redundant segments",
             "ψ and φ of thesis §2.9: segments deleted, polygons left over that no face asks for, faces "
             "missing, and points that fitted nowhere.",
             measure_redundancy(redundancy), "redundancy");
}

}  // namespace

void write_report(const ReportOptions& options, Limits limits) {
  if (options.full) limits.peer_seconds = std::max(limits.peer_seconds, 1800.0);
  ReportPage report(options.folder, options.commit,
                    "# limpet, measured\n\nWhat the figures mean: docs/benchmarks.md.\n",
                    {"default", "throughput", "stages", "streams", "sizes", "sizes_stages", "latency",
                     "hostile", "hostile_growth", "polyhedra", "redundancy"});
  using Part = void (*)(const ReportOptions&, const Limits&, ReportPage&);
  const std::map<std::string, Part> parts{{"default", add_default},       {"latency", add_latency},
                                          {"hostile", add_hostile},       {"streams", add_streams},
                                          {"sizes", add_sizes},           {"polyhedra", add_polyhedra},
                                          {"redundancy", add_redundancy}, {"throughput", add_throughput}};
  for (const std::string& name : options.parts) parts.at(name)(options, limits, report);
}

}  // namespace limpet::benchmarks
