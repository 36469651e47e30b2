// Copyright the limpet authors. GPL-3.0-or-later.
//
// Thesis Table 1: range images of objects from one side, with the occluded faces as initial segments. The
// thesis's objects are not known but for their pictures, so the counts stand beside each other and no more.
#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

struct Object {
  std::string name, shape;
  double scale;
  /// Of the scanner, in the object's frame. Empty: the mesh itself is felt, since one side of it shadows
  /// another in part, and what no image shows could be neither felt nor known.
  std::string direction;
  bool is_curved;
  std::int64_t thesis_sets;
  double thesis_seconds;  ///< a step
};

const std::vector<Object>& objects() {
  static const std::vector<Object> all{
      {"Cube", "cube", 1, "[-0.6, 0.5, -0.62]", false, 693, 0.0753},
      {"Block1 (L)", "L", 0.95, "[-0.55, 0.5, -0.67]", false, 910, 0.0779},
      {"Block2 (step)", "step", 0.633, "[-0.55, 0.5, -0.67]", false, 938, 0.1143},
      {"cylinder on a block", "drum:64", 1, "", true, 13004, 0.5834},
      {"sphere", "sphere:64", 1, "[-0.6, 0.5, -0.62]", true, 13004, 0.5834}};
  return all;
}

SceneText scene_of(const RunPlan& plan, const Table1Options& options, const Object& object) {
  SceneText scene = scene_of(plan, object.shape);
  scene.set("world", "scale", object.scale);
  if (object.direction.empty()) return scene;
  scene.set("world", "pitch", options.pitch)
      .set_text("world", "direction", object.direction)
      .set_text("initial", "occluded", "true");
  return scene;
}

}  // namespace

Measured measure_table1(RunPlan const& plan, const Table1Options& options) {
  Measured measured;
  Table table({{"object"},
               {"strategy"},
               {"ended"},
               {"closed"},
               {"sets_median"},
               {"sets_worst"},
               {"thesis_sets"},
               {"felt_area", 3},
               {"sets_per_area"},
               {"coverage_worst_%", 4},
               {"collisions"},
               {"clearance_worst", 3},
               {"seconds_a_step", 2},
               {"thesis_seconds", 4},
               {"violations"}});
  for (const std::string& strategy : options.strategies) {
    std::vector<RunCase> cases;
    RunPlan of_strategy = plan;
    of_strategy.strategy = strategy;
    std::vector<Object> wanted;
    for (const Object& object : objects()) {
      if (object.is_curved && !options.curved) continue;
      wanted.push_back(object);
      add_runs(of_strategy, object.name, scene_of(of_strategy, options, object), cases);
    }
    const auto made = make_runs(cases, plan.workers);
    measured.runs.insert(measured.runs.end(), made.begin(), made.end());
    const auto groups = grouped(made);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const RunGroup& g = groups[i];
      const auto sets = [](const RunFigures& f) { return static_cast<double>(f.sets); };
      table.add({g.name, strategy, g.share([](const RunFigures& f) { return f.complete(); }),
                 g.share([](const RunFigures& f) { return f.closed; }), std::int64_t(g.median(sets)),
                 std::int64_t(g.most(sets)), wanted[i].thesis_sets,
                 g.median([](const RunFigures& f) { return f.area; }),
                 std::int64_t(g.median([](const RunFigures& f) { return double(f.sets) / f.area; })),
                 100 * g.least([](const RunFigures& f) { return f.coverage_total; }),
                 g.sum(&RunFigures::collisions), g.least([](const RunFigures& f) { return f.clearance; }),
                 g.median([](const RunFigures& f) { return f.seconds_per_set(); }), wanted[i].thesis_seconds,
                 g.sum(&RunFigures::violations)});
    }
  }
  measured.tables.push_back({"Range images from one side, beside thesis Table 1 (" + seeds_text(plan) +
                                 "); coverage is of all the surface",
                             table});
  return measured;
}

}  // namespace limpet::benchmarks
