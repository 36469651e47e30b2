// Copyright the limpet authors. GPL-3.0-or-later.
#include "report.hpp"

#include <ctime>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace limpet::benchmarks {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::string text(32, '\0');
  text.resize(std::strftime(text.data(), text.size(), "%Y-%m-%d", std::gmtime(&now)));
  return text;
}

class Report {
 public:
  explicit Report(const ReportOptions& options) : folder_(options.folder) {
    std::filesystem::create_directories(folder_);
    text_ = "# limpet, measured\n\nCommit " + options.commit + ", " + today() + ", " + processor() + ", " +
            std::to_string(std::thread::hardware_concurrency()) + " cores, g++ " __VERSION__ "." +
            (options.full ? " The full report." : "") + " What the figures mean: docs/benchmarks.md.\n";
  }

  void add(const std::string& title, const std::string& said, const Table& table, const std::string& name) {
    text_ += "\n## " + title + "\n\n" + said + "\n\n" + table.markdown();
    table.write_csv(folder_ + "/" + name + ".csv");
    std::ofstream file(folder_ + "/report.md");
    file << text_;
    if (!file.flush()) throw std::runtime_error("cannot write " + folder_ + "/report.md");
  }

 private:
  std::string folder_, text_;
};

void add_throughput(const ReportOptions& options, const Limits& limits, Report& report) {
  ThroughputTables tables;
  for (const std::int64_t points : {100'000, 1'000'000})
    for (const char* shape : {"cube", "step_hole", "city:100", "room"})
      for (const char* order : {"shuffled", "raster"}) {
        if (shape == std::string("room") && points < 1'000'000) continue;  // too few for its small faces
        ThroughputOptions throughput;
        // The peers hardly mind the order; it is their time that the report takes.
        if (!options.full && order == std::string("raster")) throughput.contestants = {"limpet"};
        if (options.full) throughput.peer_runs = 3;
        // σ ≤ λ/10, for all shapes.
        const double noise_ratio = shape == std::string("step_hole") ? 0.0005 : 0.002;
        measure_throughput({.shape = shape, .order = order, .points = points, .noise_ratio = noise_ratio},
                           throughput, limits, tables);
      }
  report.add("Throughput", "Planes found in the same cloud, each contestant in a process of its own.",
             tables.contestants, "throughput");
  report.add("Where the time goes", "Nanoseconds per point of limpet, by stage.", tables.stages, "stages");
}

void add_streams(const ReportOptions& options, const Limits& limits, Report& report) {
  const std::int64_t points = options.full ? 100'000'000 : 10'000'000;
  report.add(
      "Against the length of the stream",
      "Points made on the fly, 1 % outliers, the same λ all along; memory is the peak so far.",
      measure_streams({stream_of("cube", points, 100'000), stream_of("city:100", points, 1'000'000)}, limits),
      "streams");
}

void add_sizes(const ReportOptions& options, const Limits& limits, Report& report) {
  SizeOptions sizes;
  sizes.throughput.contestants = {"limpet", "region_growing"};
  sizes.throughput.runs = options.full ? 3 : 1;
  sizes.throughput.stages = options.full;
  if (options.full) sizes.boxes = {1, 3, 10, 30, 100, 300, 1000};
  const ThroughputTables tables = measure_sizes(sizes, limits);
  report.add("Against the size of the model", "Cities of n boxes, about 1,000 points for each face.",
             tables.contestants, "sizes");
  if (!tables.stages.empty())
    report.add("Where the time goes in larger models", "Nanoseconds per point of limpet, by stage.",
               tables.stages, "sizes_stages");
}

void add_latency(const ReportOptions& options, const Limits& limits, Report& report) {
  LatencyOptions latency;
  if (options.full) latency.boxes = 1000;
  report.add("Latency of a set of 26 readings",
             "Microseconds, while the model is built and after the whole city has been seen.",
             measure_latency(latency, limits), "latency");
}

}  // namespace

void write_report(const ReportOptions& options, Limits limits) {
  if (options.full) limits.seconds = std::max(limits.seconds, 1200.0);
  Report report(options);
  add_latency(options, limits, report);
  add_streams(options, limits, report);
  add_sizes(options, limits, report);
  add_throughput(options, limits, report);
}

}  // namespace limpet::benchmarks
