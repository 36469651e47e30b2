// Copyright the limpet authors. GPL-3.0-or-later.
//
// Replays cases through the build of geometry/ that it is linked with, each in a process of its own; one line
// of JSON a case.
//
//   limpet_replay_ARITHMETIC perimeters FILE [--repeats N] [--judge] [--together]
//   limpet_replay_ARITHMETIC cases FILE...
//   limpet_replay_ARITHMETIC streams [--count N] [--seed N]
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <limits>

#include "../../tests/cases/any_case.hpp"
#include "../../tests/model/random_streams.hpp"
#include "../child.hpp"
#include "../process.hpp"
#include "../program.hpp"
#include "case_list.hpp"

namespace limpet::benchmarks {
namespace {

using cases::Outcome;
using cases::PerimeterCase;
using cases::PerimeterTrial;

constexpr ChildLimits kLimits{.seconds = 600, .cpu_seconds = 20, .megabytes = 4000, .with_errors = false};
constexpr std::array kOutcomes = {"changed", "nothing", "refused"};

struct Arguments {
  std::vector<std::string> files;
  int repeats = 1;
  bool judge = false;     ///< say which law broke, and the area
  bool together = false;  ///< all in this process: what counts instructions wants one
  std::uint64_t seed = 1;
  int count = 100;
};

/// The only step of a case, several times from the same start. The fastest counts.
Json measured(const PerimeterCase& c, const Arguments& args) {
  Json said;
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < args.repeats; ++k) {
    std::optional<PerimeterTrial> trial;
    try {
      trial.emplace(c.start, c.gap, c.area_tolerance, c.step_tolerance);
    } catch (const cases::CaseError&) {
    }
    if (!trial || !trial->prepare(c.steps.at(0))) return {{"outcome", "unfit"}};  // no polygon, it says
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    const Outcome outcome = trial->apply();
    best = std::min(best, std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
    if (k + 1 < args.repeats) continue;
    said = {{"outcome", kOutcomes[static_cast<std::size_t>(outcome)]}, {"attempts", trial->attempts()}};
    if (!args.judge) continue;
    shapes::Random places(std::uint64_t{1});
    const auto law = trial->judge(places, true);
    said["law"] = law ? cases::kPerimeterLaws[static_cast<std::size_t>(*law)] : "";
    said["area"] = cases::area_of(trial->polygon().boundary());
  }
  said["us"] = best;
  return said;
}

void tell(const std::function<Json()>& ask) {
  const ChildEnd end = run_child([&] { std::cout << ask().dump() << std::endl; }, kLimits);
  Json told = last_told(end.output);
  if (!end.done() || told.is_null()) told = {{"ended", end.how()}};
  std::cout << told.dump() << '\n';
}

void replay_perimeters(const Arguments& args) {
  for (const PerimeterCase& c : load_cases(args.files.at(0)))
    if (args.together)
      std::cout << measured(c, args).dump() << '\n';
    else
      tell([&] { return measured(c, args); });
}

Json verdict(const std::optional<cases::BrokenLaw>& broken) {
  return {{"law", broken ? broken->law : ""}, {"what", broken ? broken->what : ""}};
}

void replay_cases(const Arguments& args) {
  for (const std::string& path : args.files)
    tell([&] {
      return cases::with_case(load_text(path), [](const auto& c) { return verdict(broken_law(c)); });
    });
}

void replay_streams(const Arguments& args) {
  for (int k = 0; k < args.count; ++k)
    tell([&] {
      const auto stream = model::testing::random_stream(args.seed + static_cast<std::uint64_t>(k));
      return verdict(broken_law(cases::StreamCase{stream.parameters, stream.sets, {}}));
    });
}

int run(int argc, char** argv) {
  Arguments args;
  CLI::App app{"Replays cases through one build of geometry/"};
  app.require_subcommand(1);
  auto* perimeters = app.add_subcommand("perimeters", "Cases of one step each, timed");
  perimeters->add_option("FILE", args.files)->required()->expected(1);
  perimeters->add_option("--repeats", args.repeats)->check(CLI::Range(1, 1'000'000));
  perimeters->add_flag("--judge", args.judge);
  perimeters->add_flag("--together", args.together);
  perimeters->callback([&] { replay_perimeters(args); });
  auto* of_any_kind = app.add_subcommand("cases", "Cases of any kind, judged");
  of_any_kind->add_option("FILE", args.files)->required();
  of_any_kind->callback([&] { replay_cases(args); });
  auto* streams = app.add_subcommand("streams", "Random degenerate streams, judged");
  streams->add_option("--count", args.count);
  streams->add_option("--seed", args.seed);
  streams->callback([&] { replay_streams(args); });
  CLI11_PARSE(app, argc, argv);
  return 0;
}

}  // namespace
}  // namespace limpet::benchmarks

int main(int argc, char** argv) {
  return limpet::benchmarks::told_in_a_line(
      "limpet_replay", [&] { return limpet::benchmarks::run(argc, argv); }, 2);
}
