// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>

#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

std::vector<RunCase> cases_of(const RunPlan& plan, const WorldOptions& options) {
  std::vector<RunCase> cases;
  for (const std::string& world : options.worlds)
    for (const double noise : options.noise)
      for (const double ceiling : options.ceilings) {
        SceneText scene = scene_of(plan, world);
        scene.set("errors", "noise", noise).set("robot", "ceiling", ceiling * plan.resolution);
        const std::string name =
            world + ", noise " + Json(noise).dump() + ", γ " + Json(ceiling).dump() + " λ";
        add_runs(plan, name, scene, cases);
      }
  return cases;
}

double sets_of(const RunFigures& f) { return static_cast<double>(f.sets); }
double sets_per_area(const RunFigures& f) { return static_cast<double>(f.sets) / f.area; }
double path_of(const RunFigures& f) { return f.path; }

std::uint64_t seed_of_worst(const RunGroup& group) {
  const auto worst = std::max_element(group.runs.begin(), group.runs.end(),
                                      [](const auto& a, const auto& b) { return a.sets < b.sets; });
  return worst == group.runs.end() ? 0 : group.seeds[static_cast<std::size_t>(worst - group.runs.begin())];
}

Table ways_table(const std::vector<RunGroup>& groups) {
  Table table({{"world"},
               {"ended"},
               {"closed"},
               {"isomorphic"},
               {"sets_median"},
               {"sets_worst"},
               {"its_seed"},
               {"sets_per_area"},
               {"path_median"},
               {"path_worst"},
               {"path_over_tour", 3},
               {"sets_over_tour", 3}});
  for (const RunGroup& g : groups) {
    const bool has_tour = g.most([](const RunFigures& f) { return f.tour_path; }) > 0;
    table.add({g.name, g.share([](const RunFigures& f) { return f.complete(); }),
               g.share([](const RunFigures& f) { return f.closed; }),
               g.share([](const RunFigures& f) { return f.isomorphic; }), std::int64_t(g.median(sets_of)),
               std::int64_t(g.most(sets_of)), seed_of_worst(g), std::int64_t(g.median(sets_per_area)),
               g.median(path_of), g.most(path_of),
               has_tour ? Json(g.median([](const RunFigures& f) { return f.path / f.tour_path; })) : Json(),
               has_tour ? Json(g.median([](const RunFigures& f) {
                 return double(f.sets) / double(f.tour_sets + f.tour_transit);
               }))
                        : Json()});
  }
  return table;
}

Table judged_table(const std::vector<RunGroup>& groups) {
  Table table({{"world"},
               {"coverage_worst_%", 4},
               {"collisions"},
               {"clearance_median", 3},
               {"clearance_worst", 3},
               {"runs_below_1"},
               {"unreachable"},
               {"unclosable"},
               {"false_marks"},
               {"open_edges"},
               {"models_judged"},
               {"violations"}});
  for (const RunGroup& g : groups)
    table.add({g.name, 100 * g.least([](const RunFigures& f) { return f.coverage; }),
               g.sum(&RunFigures::collisions), g.median([](const RunFigures& f) { return f.clearance; }),
               g.least([](const RunFigures& f) { return f.clearance; }),
               g.share([](const RunFigures& f) { return f.clearance < 1; }), g.sum(&RunFigures::unreachable),
               g.sum(&RunFigures::unclosable), g.sum(&RunFigures::false_unreachable),
               g.sum(&RunFigures::open_edges), g.sum(&RunFigures::oracle_models),
               g.sum(&RunFigures::violations)});
  return table;
}

/// Of each run its median, 99 % and maximum; of these over the runs the median, and of the maxima the
/// largest.
Table times_table(const std::vector<RunGroup>& groups) {
  Table table({{"world"},
               {"step"},
               {"step_99"},
               {"step_max"},
               {"asked_%"},
               {"asking"},
               {"asking_99"},
               {"asking_max"},
               {"update"},
               {"update_99"},
               {"update_max"},
               {"mean_of_all"}});
  for (const RunGroup& g : groups)
    table.add({g.name, g.median([](const RunFigures& f) { return f.step.median; }),
               g.median([](const RunFigures& f) { return f.step.p99; }),
               g.most([](const RunFigures& f) { return f.step.max; }),
               g.median([](const RunFigures& f) { return 100.0 * double(f.asking.count) / double(f.sets); }),
               g.median([](const RunFigures& f) { return f.asking.median; }),
               g.median([](const RunFigures& f) { return f.asking.p99; }),
               g.most([](const RunFigures& f) { return f.asking.max; }),
               g.median([](const RunFigures& f) { return f.update.median; }),
               g.median([](const RunFigures& f) { return f.update.p99; }),
               g.most([](const RunFigures& f) { return f.update.max; }),
               g.median([](const RunFigures& f) { return 1e6 * f.seconds_per_set(); })});
  return table;
}

}  // namespace

Measured measure_worlds(const RunPlan& plan, const WorldOptions& options) {
  Measured measured;
  measured.runs = make_runs(cases_of(plan, options), plan.workers);
  const auto groups = grouped(measured.runs);
  const std::string runs = plan.strategy + ", " + seeds_text(plan);
  measured.tables.push_back({"Ways (" + runs + ")", ways_table(groups)});
  measured.tables.push_back({"Judged by the truth; clearance over δ − λ", judged_table(groups)});
  measured.tables.push_back(
      {"Microseconds a set: next() where it does not ask what would close (step) and where it does (asking), "
       "update()",
       times_table(groups)});
  return measured;
}

}  // namespace limpet::benchmarks
