// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <filesystem>

#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

Table table_of(const std::vector<MadeRun>& runs) {
  Table table({{"part"},
               {"seed"},
               {"lambda", 3},
               {"ended"},
               {"sets"},
               {"closed"},
               {"isomorphic"},
               {"isomorphic_reachable"},
               {"reachable_%", 4},
               {"coverage_%", 4},
               {"collisions"},
               {"false_marks"},
               {"clearance", 3},
               {"seconds", 3},
               {"judging", 3}});
  for (const auto& [wanted, f] : runs) {
    if (!f.failed.empty()) {
      table.add({wanted.name, wanted.seed, Json(), f.failed, Json(), Json(), Json(), Json(), Json(), Json(),
                 Json(), Json(), Json(), Json(), Json()});
      continue;
    }
    table.add({wanted.name, wanted.seed, f.resolution, f.ended, f.sets, f.closed, f.isomorphic,
               f.isomorphic_reachable, 100 * f.reachable, 100 * f.coverage, f.collisions, f.false_unreachable,
               f.clearance, f.seconds, f.judge_seconds});
  }
  return table;
}

Table summary_of(const std::vector<MadeRun>& runs) {
  Table table({{"what"}, {"runs"}, {"of"}});
  std::vector<RunFigures> made;
  for (const auto& run : runs)
    if (run.figures.failed.empty()) made.push_back(run.figures);
  const auto add = [&](const char* what, bool (*is)(const RunFigures&)) {
    table.add({what, std::count_if(made.begin(), made.end(), is), runs.size()});
  };
  add("complete", [](const RunFigures& f) { return f.complete(); });
  add("no collision", [](const RunFigures& f) { return f.collisions == 0; });
  add("clearance of δ − λ kept", [](const RunFigures& f) { return f.clearance >= 1; });
  add("coverage of 99.5 % or more", [](const RunFigures& f) { return f.coverage >= 0.995; });
  add("no false mark", [](const RunFigures& f) { return f.false_unreachable == 0; });
  add("closed", [](const RunFigures& f) { return f.closed; });
  add("isomorphic over what can be reached", [](const RunFigures& f) { return f.isomorphic_reachable; });
  add("no broken law", [](const RunFigures& f) { return f.violations == 0; });
  const auto throughout = [](const RunFigures& f) { return f.reachable_throughout; };
  table.add({"isomorphic, of those reachable throughout",
             std::count_if(made.begin(), made.end(), [](const RunFigures& f) { return f.isomorphic; }),
             std::count_if(made.begin(), made.end(), throughout)});
  return table;
}

}  // namespace

Measured measure_parts(const RunPlan& plan, const std::vector<std::string>& files) {
  std::vector<RunCase> cases;
  for (const std::string& file : files)
    add_runs(plan, std::filesystem::path(file).stem().string(), scene_of(plan, file), cases);
  Measured measured;
  measured.runs = make_runs(cases, plan.workers);
  measured.tables.push_back({"Parts (" + plan.strategy + ", " + seeds_text(plan) + "); clearance over δ − λ",
                             table_of(measured.runs)});
  measured.tables.push_back({"All of them", summary_of(measured.runs)});
  return measured;
}

}  // namespace limpet::benchmarks
