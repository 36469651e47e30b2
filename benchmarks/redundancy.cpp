// Copyright the limpet authors. GPL-3.0-or-later.
//
// How the thresholds of thesis §2.9 behave: what they delete, what is left that no face asks for, and what is
// lost. Twice: with all rules, and without those that leave ψ and φ little to do.
#include <algorithm>
#include <cstdio>

#include <limpet/evaluation/judgement.hpp>
#include <limpet/evaluation/planar_face.hpp>
#include <limpet/evaluation/topology.hpp>

#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

/// Of one scan or the sum of several.
struct Tally {
  std::int64_t points = 0, by_count = 0, by_position = 0, given_up = 0;
  int extra = 0, missing = 0, runs = 0, same_topology = 0;

  void add(const Tally& o) {
    points += o.points, by_count += o.by_count, by_position += o.by_position, given_up += o.given_up;
    extra += o.extra, missing += o.missing, runs += o.runs, same_topology += o.same_topology;
  }
};

Tally outcome_of(const ScanCase& scan_case, const std::string& rules, double psi, double phi) {
  std::vector<simulation::LabelledPoint> labelled;
  scan_case.scan([&](const simulation::LabelledPoint& p) { labelled.push_back(p); });
  model::Parameters parameters = scan_case.parameters();
  parameters.rules = model::Rules::parse(rules);
  parameters.redundancy_count = psi;
  parameters.redundancy_ratio = phi;
  model::Model model(parameters);
  constexpr std::size_t kReadings = 26;
  std::vector<model::SensorPoint> set;
  for (std::size_t i = 0; i < labelled.size(); i += kReadings) {
    set.clear();
    for (std::size_t k = i; k < std::min(i + kReadings, labelled.size()); ++k)
      set.push_back(labelled[k].point);
    model.update(set);
  }
  model.finish();

  const auto record = model.record();
  const auto counts = model.counts();
  const auto report =
      evaluation::judge_faces(evaluation::planar_faces(record), scan_case.scene.mesh, labelled,
                              {.resolution = scan_case.resolution, .noise = scan_case.noise});
  const auto topology = evaluation::judge_topology(record, scan_case.scene.mesh, report);
  return {counts.points,
          counts.redundant_by_count,
          counts.redundant_by_position,
          counts.expired,
          report.extra,
          report.counted - report.represented,
          1,
          topology.isomorphic};
}

}  // namespace

Table measure_redundancy(const RedundancyOptions& options) {
  Table table({{"rules"},
               {"psi", 3},
               {"phi", 3},
               {"deleted_by_count"},
               {"deleted_by_position"},
               {"left_over"},
               {"faces_missing"},
               {"points_given_up_percent", 2},
               {"same_topology"},
               {"runs"}});
  for (const auto& rules : options.rules)
    for (const double psi : options.psi)
      for (const double phi : options.phi) {
        if (psi == 0 && phi != options.phi.front()) continue;  // nothing is deleted by either
        Tally sum;
        for (const auto& shape : options.shapes)
          for (const auto& order : options.orders)
            for (int seed = 1; seed <= options.seeds; ++seed)
              sum.add(outcome_of(ScanCase({.shape = shape,
                                           .order = order,
                                           .points = options.points,
                                           .noise_ratio = options.noise_ratio,
                                           .outliers = options.outliers,
                                           .seed = static_cast<std::uint64_t>(seed)}),
                                 rules, psi, phi));
        std::fprintf(stderr, "%s, psi %g, phi %g\n", rules.c_str(), psi, phi);
        table.add({rules, psi, psi == 0 ? Json() : Json(phi), sum.by_count, sum.by_position, sum.extra,
                   sum.missing, 100.0 * static_cast<double>(sum.given_up) / static_cast<double>(sum.points),
                   sum.same_topology, sum.runs});
      }
  return table;
}

}  // namespace limpet::benchmarks
