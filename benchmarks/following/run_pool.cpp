// Copyright the limpet authors. GPL-3.0-or-later.
#include "run_pool.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <mutex>
#include <thread>

#include <limpet/survey/noise_law.hpp>

namespace limpet::benchmarks {
namespace {

/// Beyond the run's own limit: for judging it, which has none.
constexpr double kJudging = 600;

RunFigures ask(const RunCase& wanted) {
  const Json answer = ask_process({{"what", "run"}, {"case", wanted}}, wanted.max_seconds + kJudging);
  if (!answer.contains("failed") || answer.contains("ended")) return answer.get<RunFigures>();
  RunFigures figures;
  figures.failed = answer.at("failed");
  return figures;
}

void tell(const RunCase& wanted, const RunFigures& f, std::size_t done, std::size_t all) {
  if (!f.failed.empty())
    std::fprintf(stderr, "%zu/%zu %s seed %llu: %s\n", done, all, wanted.name.c_str(),
                 static_cast<unsigned long long>(wanted.seed), f.failed.c_str());
  else
    std::fprintf(stderr, "%zu/%zu %s seed %llu: %s, %lld sets, %s, coverage %.4f, clearance %.2f, %.1f s\n",
                 done, all, wanted.name.c_str(), static_cast<unsigned long long>(wanted.seed),
                 f.ended.c_str(), static_cast<long long>(f.sets), f.closed ? "closed" : "open", f.coverage,
                 f.clearance, f.seconds + f.judge_seconds);
}

std::vector<double> numbers(const std::vector<RunFigures>& runs, RunGroup::Number number) {
  std::vector<double> values;
  for (const RunFigures& run : runs) values.push_back(number(run));
  return values;
}

std::string fault_of(const RunFigures& f) {
  std::string fault;
  const auto add = [&fault](bool is, const std::string& what) {
    if (is) fault.append(fault.empty() ? "" : ", ").append(what);
  };
  if (!f.failed.empty()) return f.failed;
  add(!f.complete(), f.ended);
  add(f.collisions > 0, std::to_string(f.collisions) + " collisions");
  add(f.link_collisions > 0, std::to_string(f.link_collisions) + " collisions of links");
  add(f.violations > 0, std::to_string(f.violations) + " broken laws");
  add(f.false_unreachable > 0, std::to_string(f.false_unreachable) + " false marks");
  add(f.coverage < 0.995, "coverage " + std::to_string(f.coverage));
  return fault;
}

}  // namespace

std::vector<MadeRun> make_runs(const std::vector<RunCase>& cases, int workers) {
  std::vector<MadeRun> made(cases.size());
  std::atomic<std::size_t> next = 0, done = 0;
  std::mutex telling;
  const auto work = [&] {
    for (std::size_t i = next++; i < cases.size(); i = next++) {
      made[i] = {cases[i], ask(cases[i])};
      const std::lock_guard lock(telling);
      tell(cases[i], made[i].figures, ++done, cases.size());
    }
  };
  std::vector<std::jthread> threads;
  for (int i = 1; i < workers; ++i) threads.emplace_back(work);
  work();
  threads.clear();
  return made;
}

double RunGroup::median(Number number) const { return survey::quantile(numbers(runs, number), 0.5); }
double RunGroup::least(Number number) const { return survey::quantile(numbers(runs, number), 0); }
double RunGroup::most(Number number) const { return survey::quantile(numbers(runs, number), 1); }

int RunGroup::count(bool (*is)(const RunFigures&)) const {
  return static_cast<int>(std::count_if(runs.begin(), runs.end(), is));
}

std::int64_t RunGroup::sum(std::int64_t RunFigures::*what) const {
  std::int64_t sum = 0;
  for (const RunFigures& run : runs) sum += run.*what;
  return sum;
}

std::string RunGroup::share(bool (*is)(const RunFigures&)) const {
  return std::to_string(count(is)) + " of " + std::to_string(wanted);
}

std::vector<RunGroup> grouped(const std::vector<MadeRun>& made) {
  std::vector<RunGroup> groups;
  for (const auto& [wanted, figures] : made) {
    if (groups.empty() || groups.back().name != wanted.name) groups.push_back({wanted.name, {}, {}, 0});
    RunGroup& group = groups.back();
    ++group.wanted;
    if (!figures.failed.empty()) continue;
    group.runs.push_back(figures);
    group.seeds.push_back(wanted.seed);
  }
  return groups;
}

std::string faults_text(const std::vector<MadeRun>& made) {
  std::string text;
  for (const auto& [wanted, figures] : made)
    if (const std::string fault = fault_of(figures); !fault.empty())
      text += wanted.name + " seed " + std::to_string(wanted.seed) + ": " + fault + "\n";
  return text;
}

Json to_json(const std::vector<MadeRun>& made) {
  Json runs = Json::array();
  for (const auto& [wanted, figures] : made) runs.push_back({{"case", wanted}, {"figures", figures}});
  return runs;
}

}  // namespace limpet::benchmarks
