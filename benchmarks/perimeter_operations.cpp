// Copyright the limpet authors. GPL-3.0-or-later.
//
// Random degenerate perimeter operations; the whole polygon is judged from scratch after each. Batches run in
// child processes, so that a crash or a hang is counted and not fatal.
//
//   limpet_perimeter_operations --help
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include "../tests/cases/perimeter_script.hpp"
#include "child.hpp"
#include "perimeter_figures.hpp"
#include "program.hpp"
#include "shared_figures.hpp"

namespace limpet::benchmarks {
namespace {

using namespace geometry;
using namespace shapes;

using cases::Outcome;
using cases::PerimeterCase;
using cases::PerimeterLaw;
using cases::PerimeterScript;
using cases::PerimeterTrial;
using cases::Regime;

constexpr std::size_t kBatch = 2000;
constexpr double kSecondsPerBatch = 20, kMegabytes = 4000;
constexpr std::uint64_t kSlow_ns = 20'000'000;

struct Options {
  std::uint64_t operations = 20000, seed = 1;
  std::optional<std::uint64_t> replay;  ///< one batch alone, whose first broken law becomes a case
  std::string json, found = "found.case";
  Regime regime = Regime::any;
  bool general = false;
};

/// Operations on one polygon after the other.
class Batch {
 public:
  /// The case that ran when a law broke is written to `found`, if that is given.
  Batch(std::uint64_t seed, const Options& options, Figures& figures, std::string found)
      : script_(shapes::Random(seed), options.regime, options.general),
        places_(seed + 1),
        figures_(figures),
        found_(std::move(found)) {}

  void run(std::size_t operations) {
    while (operations > 0) {
      case_ = script_.begin();
      try {
        PerimeterTrial trial(case_.start, case_.gap);
        for (std::int64_t k = script_.random().whole(1, 40); k > 0 && operations > 0; --k, --operations)
          if (!step(trial)) break;
      } catch (const cases::CaseError&) {  // what the script made up is none: not an operation's fault
      }
    }
  }

 private:
  /// Whether the polygon is fit for another one.
  bool step(PerimeterTrial& trial) {
    case_.steps.push_back(script_.next(trial.polygon()));
    const auto kind = static_cast<std::size_t>(case_.steps.back().operation);
    figures_.running = kind;
    if (!trial.prepare(case_.steps.back())) return true;
    if (!found_.empty()) keep_case();
    const auto begin = std::chrono::steady_clock::now();
    const Outcome outcome = trial.apply();
    const auto ns = static_cast<std::uint64_t>(
        std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - begin)
            .count());
    count(trial, kind, outcome, ns);
    // The float builds would be judged by their own predicates alone otherwise.
    const bool thorough = places_.chance(1.0 / 16) || std::string(geometry::arithmetic()) != "exact";
    figures_.audited += thorough;
    const auto broken = trial.judge(places_, thorough);
    if (!broken) return trial.polygon().edge_count() < 3000;
    ++figures_.broken[kind][static_cast<std::size_t>(*broken)];
    if (!found_.empty()) {
      case_.law = cases::kPerimeterLaws[static_cast<std::size_t>(*broken)];
      keep_case();
      std::fprintf(stderr, "%s: broke the law '%s'\n", found_.c_str(), case_.law.c_str());
      found_.clear();
    }
    return false;
  }

  void count(const PerimeterTrial& trial, std::size_t kind, Outcome outcome, std::uint64_t ns) {
    ++figures_.operations;
    ++figures_.outcome[kind][static_cast<std::size_t>(outcome)];
    figures_.total_ns[kind] += ns;
    figures_.longest_ns[kind] = std::max(figures_.longest_ns[kind], ns);
    figures_.slow[kind] += ns > kSlow_ns;
    if (trial.attempts() > 0 && outcome == Outcome::changed)
      ++figures_.unite_attempt[std::min<std::size_t>(trial.attempts(), 7)];
    if (kind == static_cast<std::size_t>(cases::Operation::merge))
      ++figures_.merger[static_cast<std::size_t>(trial.merger())];
    figures_.edges_max = std::max<std::uint64_t>(figures_.edges_max, trial.polygon().edge_count());
    figures_.holes_max = std::max<std::uint64_t>(figures_.holes_max, trial.polygon().hole_count());
  }

  void keep_case() const { std::ofstream(found_) << to_text(case_); }

  PerimeterScript script_;
  shapes::Random places_;
  Figures& figures_;
  std::string found_;
  PerimeterCase case_;
};

std::uint64_t batch_seed(std::uint64_t seed, std::uint64_t batch) {
  return shapes::Random(seed * 1'000'003 + batch).bits();
}

/// Runs one batch in a child; what it counted before it died stays.
void run_batch(const Options& options, std::uint64_t batch, std::size_t operations, Figures& figures) {
  figures.running = kKinds;
  const ChildEnd end =
      run_child([&] { Batch(batch_seed(options.seed, batch), options, figures, {}).run(operations); },
                {.cpu_seconds = kSecondsPerBatch, .megabytes = kMegabytes});
  if (end.done()) return;
  ++(end.hang ? figures.hangs : figures.crashes);
  if (!end.hang) ++figures.signals[static_cast<std::size_t>(end.signal)];
  ++figures.operations;
  std::fprintf(stderr, "batch %llu: %s during %s\n", static_cast<unsigned long long>(batch),
               end.how().c_str(), figures.running < kKinds ? cases::kOperations[figures.running] : "setup");
}

void run_all(const Options& options, Figures& figures) {
  for (std::uint64_t batch = 0; figures.operations < options.operations; ++batch) {
    const auto before = figures.broken;
    run_batch(options, batch, std::min<std::size_t>(kBatch, options.operations - figures.operations),
              figures);
    for (std::size_t k = 0; k < kKinds; ++k)
      for (std::size_t i = 0; i < kLaws; ++i)
        if (figures.broken[k][i] != before[k][i])
          std::fprintf(stderr, "batch %llu: %s, %s\n", static_cast<unsigned long long>(batch),
                       cases::kOperations[k], cases::kPerimeterLaws[i]);
  }
}

Options options_of(int argc, char** argv) {
  CLI::App app{"Random degenerate perimeter operations, each judged from scratch"};
  Options o;
  app.add_option("--operations", o.operations, "How many (default 20000)");
  app.add_option("--seed", o.seed, "Of the batches (default 1)");
  app.add_option("--replay", o.replay, "Run this batch alone, and keep the case that breaks a law");
  app.add_option("--found", o.found, "Where to keep it (default found.case)");
  app.add_option("--json", o.json, "Write the figures there, too");
  const std::map<std::string, Regime> regimes = {
      {"grid", Regime::grid}, {"free", Regime::free}, {"far", Regime::far}, {"any", Regime::any}};
  app.add_option("--regime", o.regime, "Where coordinates lie: grid, free, far or any (default any)")
      ->transform(CLI::CheckedTransformer(regimes));
  app.add_flag("--general", o.general, "Perimeters in general position instead of degenerate ones");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  return o;
}

int run(const Options& options) {
  auto& figures = shared_figures<Figures>();
  const auto begin = std::chrono::steady_clock::now();
  if (options.replay)
    Batch(batch_seed(options.seed, *options.replay), options, figures, options.found).run(kBatch);
  else
    run_all(options, figures);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const std::string text = json_of(figures, options.seed, seconds.count());
  std::fputs(text.c_str(), stdout);
  if (!options.json.empty() && !(std::ofstream(options.json) << text)) return 2;
  return figures.faults() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace limpet::benchmarks

int main(int argc, char** argv) {
  using namespace limpet::benchmarks;
  return told_in_a_line(
      "limpet_perimeter_operations", [&] { return run(options_of(argc, argv)); }, 2);
}
