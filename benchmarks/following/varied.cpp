// Copyright the limpet authors. GPL-3.0-or-later.
#include "varied.hpp"

#include <algorithm>

namespace limpet::benchmarks {
namespace {

std::string name_of(const Variation& v) { return v.what + " " + v.value; }

std::vector<Variation> asked_for(const VariedOptions& options, const std::vector<Variation>& all) {
  std::vector<Variation> rows;
  for (const Variation& v : all)
    if (&v == &all.front() || options.only.empty() ||
        std::find(options.only.begin(), options.only.end(), v.what) != options.only.end())
      rows.push_back(v);
  return rows;
}

std::vector<Json> row_of(const Variation& v, const RunGroup& g, double usual_sets) {
  const double sets = g.median([](const RunFigures& f) { return double(f.sets) / f.area; });
  return {v.what,
          v.value,
          g.share([](const RunFigures& f) { return f.complete(); }),
          g.share([](const RunFigures& f) { return f.closed; }),
          g.share([](const RunFigures& f) { return f.isomorphic; }),
          std::int64_t(sets),
          usual_sets > 0 ? Json(sets / usual_sets) : Json(),
          100 * g.least([](const RunFigures& f) { return f.coverage; }),
          g.median([](const RunFigures& f) { return f.clearance; }),
          g.least([](const RunFigures& f) { return f.clearance; }),
          g.sum(&RunFigures::collisions),
          g.sum(&RunFigures::false_unreachable),
          g.sum(&RunFigures::violations)};
}

}  // namespace

Measured measure_varied(const RunPlan& plan, const VariedOptions& options, const std::vector<Variation>& all,
                        const std::string& title) {
  const auto rows = asked_for(options, all);
  std::vector<RunCase> cases;
  for (const Variation& v : rows) {
    if (!v.why_not.empty()) continue;
    for (const std::string& world : options.worlds) {
      SceneText scene = scene_of(plan, world);
      v.change(scene);
      add_runs(plan, name_of(v), scene, cases);
    }
  }
  Measured measured;
  measured.runs = make_runs(cases, plan.workers);
  Table table({{"what"},
               {"value"},
               {"ended"},
               {"closed"},
               {"isomorphic"},
               {"sets_per_area"},
               {"of_usual", 3},
               {"coverage_worst_%", 4},
               {"clearance_median", 3},
               {"clearance_worst", 3},
               {"collisions"},
               {"false_marks"},
               {"violations"}});
  const auto groups = grouped(measured.runs);
  const double usual = groups.front().median([](const RunFigures& f) { return double(f.sets) / f.area; });
  auto group = groups.begin();
  for (const Variation& v : rows)
    if (v.why_not.empty())
      table.add(row_of(v, *group++, usual));
    else
      table.add({v.what, v.value, v.why_not, Json(), Json(), Json(), Json(), Json(), Json(), Json(), Json(),
                 Json(), Json()});
  std::string worlds;
  for (const std::string& world : options.worlds) worlds += (worlds.empty() ? "" : ", ") + world;
  measured.tables.push_back(
      {title + " (" + plan.strategy + "; " + worlds + "; " + seeds_text(plan) + "); clearance over δ − λ",
       table});
  return measured;
}

}  // namespace limpet::benchmarks
