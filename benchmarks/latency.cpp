// Copyright the limpet authors. GPL-3.0-or-later.
#include <cstdio>

#include "contestants.hpp"
#include "latencies.hpp"
#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

Json update_by(model::Model& model, const ScanCase& scan_case) {
  Latencies wall, cpu;
  std::vector<model::SensorPoint> set;
  scan_case.scan([&](const simulation::LabelledPoint& p) {
    set.push_back(p.point);
    if (set.size() < kSet) return;
    const CpuWatch cpu_watch;
    const WallWatch wall_watch;
    model.update(set);
    wall.add(wall_watch.seconds());
    cpu.add(cpu_watch.seconds());
    set.clear();
  });
  return {{"wall", wall.summary()}, {"cpu", cpu.summary()}, {"polygons", model.counts().polygons}};
}

}  // namespace

/// The whole scene is scanned; then it is scanned again, with other noise and other points.
Json answer_latency(const Json& request) {
  const auto spec = request.at("spec").get<CloudSpec>();
  CloudSpec again = spec;
  again.points = request.at("points_after");
  again.points_for_resolution = spec.points;
  again.seed = spec.seed + 1;
  const ScanCase build(spec);
  model::Model model(build.parameters());
  Json answer;
  answer["build"] = update_by(model, build);
  answer["after"] = update_by(model, ScanCase(again));
  answer["faces"] = build.faces.size();
  return answer;
}

Table measure_latency(const LatencyOptions& options, const Limits& limits) {
  Table table({{"shape"},
               {"true_faces"},
               {"order"},
               {"phase"},
               {"polygons"},
               {"sets"},
               {"clock"},
               {"median_us", 3},
               {"q90_us", 3},
               {"q99_us", 3},
               {"q99.9_us", 3},
               {"q99.99_us", 3},
               {"worst_us", 3},
               {"over_1_ms"},
               {"note"}});
  const std::string shape = "city:" + std::to_string(options.boxes);
  for (const auto& order : options.orders) {
    const CloudSpec spec{
        .shape = shape, .order = order, .points = options.points_per_face * (5 * options.boxes + 1)};
    std::fprintf(stderr, "latency, %s, %s\n", shape.c_str(), order.c_str());
    const Json answer = ask_process(
        {{"what", "latency"}, {"spec", spec}, {"points_after", options.points_after}}, limits.own_seconds);
    if (answer.contains("failed")) {
      table.add({shape, {}, order, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, answer["failed"]});
      continue;
    }
    for (const char* phase : {"build", "after"})
      for (const char* clock : {"wall", "cpu"}) {
        const Json& a = answer[phase][clock];
        table.add({shape,
                   answer["faces"],
                   order,
                   phase,
                   answer[phase]["polygons"],
                   a["sets"],
                   clock,
                   a["median"],
                   a["q90"],
                   a["q99"],
                   a["q999"],
                   a["q9999"],
                   a["worst"],
                   a["over_a_millisecond"],
                   {}});
      }
  }
  return table;
}

}  // namespace limpet::benchmarks
