// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <functional>

#include "ratios.hpp"
#include "runs.hpp"

namespace limpet::benchmarks {
namespace {

Json least(const std::vector<double>& seconds) {
  return seconds.empty() ? Json() : Json(*std::min_element(seconds.begin(), seconds.end()));
}

/// The ratios of the single rounds: builds that ended in all of them have run side by side.
Spread rounds_of(const RunResult& exact, const RunResult& other) {
  std::vector<double> ratios;
  if (exact.cpu_seconds.size() == other.cpu_seconds.size())
    for (std::size_t k = 0; k < exact.cpu_seconds.size(); ++k)
      ratios.push_back(exact.cpu_seconds[k] / other.cpu_seconds[k]);
  return spread_of(ratios);
}

/// Calls f(source, regime, the results of its scans) for each group that has any.
void for_each_group(const std::vector<RunScan>& scans, const std::vector<RunResults>& results,
                    const std::function<void(const std::string&, const std::string&,
                                             const std::vector<const RunResults*>& timed,
                                             const std::vector<const RunResults*>& counted)>& f) {
  for (const char* source : {"simulated", "real"})
    for (const char* regime : {"grid", "free", "far"}) {
      std::vector<const RunResults*> timed, counted;
      for (std::size_t i = 0; i < scans.size(); ++i) {
        if (scans[i].source != source || scans[i].regime != regime) continue;
        if (!scans[i].counted) timed.push_back(&results[i]);
        if (results[i][0].instructions.is_number()) counted.push_back(&results[i]);
      }
      if (!timed.empty()) f(source, regime, timed, counted);
    }
}

/// exact over build, for each scan that both ended with.
std::vector<double> ratios_of(const std::vector<const RunResults*>& runs, std::size_t build,
                              const std::function<Json(const RunResult&)>& what) {
  std::vector<double> ratios;
  for (const RunResults* r : runs)
    if (const Json q = quotient(what((*r)[0]), what((*r)[build])); q.is_number()) ratios.push_back(q);
  return ratios;
}

}  // namespace

Table run_table(const std::vector<RunScan>& scans, const std::vector<RunResults>& results) {
  Table table({{"scan"},
               {"source"},
               {"regime"},
               {"build"},
               {"ended"},
               {"cpu_seconds"},
               {"exact_over_it"},
               {"low"},
               {"high"},
               {"instructions"},
               {"broken_laws"},
               {"laws"},
               {"polygons"},
               {"true_faces"},
               {"closed"},
               {"distance_in_lambda"},
               {"as_exact"}});
  for (std::size_t i = 0; i < scans.size(); ++i)
    for (std::size_t build = 0; build < kBuilds.size(); ++build) {
      const RunResult &r = results[i][build], &exact = results[i][0];
      const Spread rounds = rounds_of(exact, r);
      const auto word = [](const Json& yes) { return yes.is_boolean() ? Json(yes ? "yes" : "no") : Json(); };
      table.add({scans[i].name, scans[i].source, scans[i].regime, kBuilds[build], r.ended,
                 least(r.cpu_seconds), quotient(least(exact.cpu_seconds), least(r.cpu_seconds)), rounds.low,
                 rounds.high, r.instructions, r.violations, r.laws, r.polygons, r.true_faces, word(r.closed),
                 r.distance, r.summary == exact.summary ? "yes" : "no"});
    }
  return table;
}

Table run_cost_table(const std::vector<RunScan>& scans, const std::vector<RunResults>& results) {
  Table table({{"source"},
               {"regime"},
               {"build"},
               {"scans"},
               {"exact_seconds"},
               {"time_ratio"},
               {"least"},
               {"largest"},
               {"ratio_of_sums"},
               {"modelling_ratio"},
               {"instructions_ratio"}});
  for_each_group(
      scans, results, [&](const auto& source, const auto& regime, const auto& timed, const auto& counted) {
        for (const std::size_t build : kFloatBuilds) {
          auto ratios = ratios_of(timed, build, [](const RunResult& r) { return least(r.cpu_seconds); });
          double exact_sum = 0, other_sum = 0;
          for (const RunResults* r : timed) {
            const Json a = least((*r)[0].cpu_seconds), b = least((*r)[build].cpu_seconds);
            if (a.is_number() && b.is_number()) exact_sum += a.get<double>(), other_sum += b.get<double>();
          }
          std::sort(ratios.begin(), ratios.end());
          table.add(
              {source, regime, kBuilds[build], ratios.size(), exact_sum, spread_of(ratios).median,
               ratios.empty() ? Json() : Json(ratios.front()), ratios.empty() ? Json() : Json(ratios.back()),
               quotient(exact_sum, other_sum),
               spread_of(ratios_of(timed, build, [](const RunResult& r) { return least(r.model_seconds); }))
                   .median,
               spread_of(ratios_of(counted, build, [](const RunResult& r) {
                 return r.instructions;
               })).median});
        }
      });
  return table;
}

Table run_fault_table(const std::vector<RunScan>& scans, const std::vector<RunResults>& results) {
  Table table({{"source"},
               {"regime"},
               {"build"},
               {"runs"},
               {"exceptions"},
               {"hangs"},
               {"signals"},
               {"other_ends"},
               {"models_that_break_laws"},
               {"broken_laws"},
               {"wrong_faces"},
               {"far_off"},
               {"opened"},
               {"other_than_exact"}});
  for_each_group(scans, results, [&](const auto& source, const auto& regime, const auto& timed, const auto&) {
    for (std::size_t build = 0; build < kBuilds.size(); ++build) {
      int exceptions = 0, hangs = 0, signals = 0, ends = 0, broken = 0, laws = 0, faces = 0, far = 0,
          opened = 0, other = 0;
      for (const RunResults* all : timed) {
        const RunResult& r = (*all)[build];
        exceptions += r.ended == "exception";
        hangs += r.ended == "hang";
        signals += r.ended.starts_with("SIG");
        ends += r.ended.starts_with("exit");
        broken += r.violations > 0, laws += r.violations;
        faces += r.faces_wrong(), far += r.far_off();
        opened += (*all)[0].closed == true && r.closed == false;
        other += r.summary != (*all)[0].summary;
      }
      table.add({source, regime, kBuilds[build], timed.size(), exceptions, hangs, signals, ends, broken, laws,
                 faces, far, opened, other});
    }
  });
  return table;
}

}  // namespace limpet::benchmarks
