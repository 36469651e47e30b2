// Copyright the limpet authors. GPL-3.0-or-later.
//
// Random degenerate streams of readings, judged by the oracle after every set (tests/cases/stream_case.hpp).
// Each stream runs in a process of its own, so that a crash or a hang is counted and not fatal.
//
//   limpet_stream_trials --help
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "../tests/cases/minimise.hpp"
#include "../tests/cases/stream_case.hpp"
#include "../tests/geometry/perimeter_shapes.hpp"
#include "program.hpp"
#include "shared_figures.hpp"

namespace limpet::benchmarks {
namespace {

using cases::StreamCase;
using cases::StreamFigures;

constexpr unsigned kSecondsPerStream = 60;

/// What random bytes stand for.
StreamCase stream(std::uint64_t seed) {
  shapes::Random random(seed);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(random.whole(200, 6000)));
  for (auto& b : bytes) b = static_cast<std::uint8_t>(random.bits());
  return cases::stream_of(bytes);
}

struct Options {
  std::uint64_t sets = 10'000, seed = 1;
  std::string json, found = "found";  ///< cases that break a law: found-SEED.case
};

int run(const Options& o) {
  auto& figures = shared_figures<StreamFigures>();
  std::uint64_t streams = 0, broken = 0, crashes = 0, hangs = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (std::uint64_t seed = o.seed << 32; figures.sets < o.sets; ++seed, ++streams) {
    StreamCase c = stream(seed);
    const std::string verdict = cases::verdict_aside(
        [&] {
          const auto law = broken_law(c, &figures);
          return law ? law->law : std::string();
        },
        kSecondsPerStream);
    if (verdict.empty()) continue;
    ++(verdict == "crash" ? crashes : verdict == "hang" ? hangs : broken);
    c.law = verdict;
    const std::string path = o.found + "-" + std::to_string(seed) + ".case";
    std::ofstream(path) << to_text(c);
    std::fprintf(stderr, "%s: %s\n", path.c_str(), verdict.c_str());
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const auto number = [](auto n) { return std::to_string(n); };
  const std::string text = "{\"seed\": " + number(o.seed) + ", \"streams\": " + number(streams) +
                           ", \"sets\": " + number(figures.sets) + ", \"broken\": " + number(broken) +
                           ", \"crashes\": " + number(crashes) + ", \"hangs\": " + number(hangs) +
                           ", \"longest_set_ms\": " + number(static_cast<double>(figures.longest_ns) * 1e-6) +
                           ", \"seconds\": " + number(seconds.count()) + "}\n";
  std::fputs(text.c_str(), stdout);
  if (!o.json.empty() && !(std::ofstream(o.json) << text)) return 2;
  return broken + crashes + hangs > 0;
}

}  // namespace
}  // namespace limpet::benchmarks

int main(int argc, char** argv) {
  CLI::App app{"Random degenerate streams of readings, judged by the oracle after every set"};
  limpet::benchmarks::Options options;
  app.add_option("--sets", options.sets, "How many (default 10000)");
  app.add_option("--seed", options.seed, "Of the streams (default 1)");
  app.add_option("--found", options.found, "Cases that break a law go to FOUND-SEED.case");
  app.add_option("--json", options.json, "Write the figures there, too");
  CLI11_PARSE(app, argc, argv);
  return limpet::benchmarks::told_in_a_line(
      "limpet_stream_trials", [&] { return limpet::benchmarks::run(options); }, 2);
}
