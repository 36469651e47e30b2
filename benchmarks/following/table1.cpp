// Copyright the limpet authors. GPL-3.0-or-later.
//
// Thesis Table 1: range images of objects from one side, with the occluded faces as initial segments, for the
// point robot and for the arm. The thesis's objects are not known but for their pictures, so the counts stand
// beside each other and no more.
#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

/// What the thesis has of a robot's run over an object.
struct ThesisRun {
  std::int64_t sets = 0;  ///< 0: it has none
  double seconds = 0;     ///< a step
};

struct Object {
  std::string name, shape;
  double scale;
  /// Of the scanner, in the object's frame. Empty: the mesh itself is felt, since one side of it shadows
  /// another in part, and what no image shows could be neither felt nor known.
  std::string direction;
  bool is_curved;
  ThesisRun point, arm;
};

const std::vector<Object>& objects() {
  static const std::vector<Object> all{
      {"Cube", "cube", 1, "[-0.6, 0.5, -0.62]", false, {693, 0.0753}, {779, 0.2343}},
      {"Block1 (L)", "L", 0.95, "[-0.55, 0.5, -0.67]", false, {910, 0.0779}, {1120, 0.2833}},
      {"Block2 (step)", "step", 0.633, "[-0.55, 0.5, -0.67]", false, {938, 0.1143}, {1422, 0.1983}},
      {"cylinder on a block", "drum:64", 1, "", true, {13004, 0.5834}, {}},
      {"sphere", "sphere:64", 1, "[-0.6, 0.5, -0.62]", true, {13004, 0.5834}, {}}};
  return all;
}

/// Runs that are told in rows beside each other.
struct Kind {
  std::string robot, strategy, avoidance;  ///< avoidance: of an arm
  bool is_arm() const { return robot == "arm"; }
};

std::vector<Kind> kinds_of(const Table1Options& options) {
  std::vector<Kind> kinds;
  for (const std::string& robot : options.robots)
    for (const std::string& strategy : options.strategies)
      for (const std::string& avoidance : robot == "arm" ? options.avoidance : std::vector<std::string>{""})
        kinds.push_back({robot, strategy, avoidance});
  return kinds;
}

std::vector<Object> objects_for(const Kind& kind, const Table1Options& options) {
  std::vector<Object> wanted;
  for (const Object& object : objects())
    if (!object.is_curved || (options.curved && !kind.is_arm())) wanted.push_back(object);
  return wanted;
}

SceneText scene_of(const RunPlan& plan, const Table1Options& options, const Object& object,
                   const Kind& kind) {
  SceneText scene = scene_of(plan, object.shape);
  scene.set("world", "scale", object.scale).set_text("", "strategy", quoted(kind.strategy));
  if (kind.is_arm())
    scene.set_text("robot", "kind", quoted("arm")).set_text("robot", "avoidance", quoted(kind.avoidance));
  if (object.direction.empty()) return scene;
  scene.set("world", "pitch", options.pitch)
      .set_text("world", "direction", object.direction)
      .set_text("initial", "occluded", "true");
  return scene;
}

std::vector<Json> row_of(const RunGroup& g, const Kind& kind, const ThesisRun& thesis) {
  const auto of_links = [&](const Json& value) { return kind.is_arm() ? value : Json(); };
  return {g.name,
          kind.robot,
          kind.strategy,
          kind.is_arm() ? Json(kind.avoidance) : Json(),
          g.share([](const RunFigures& f) { return f.complete(); }),
          g.share([](const RunFigures& f) { return f.closed; }),
          std::int64_t(g.median([](const RunFigures& f) { return double(f.sets); })),
          std::int64_t(g.most([](const RunFigures& f) { return double(f.sets); })),
          thesis.sets,
          g.median([](const RunFigures& f) { return f.area; }),
          std::int64_t(g.median([](const RunFigures& f) { return double(f.sets) / f.area; })),
          100 * g.least([](const RunFigures& f) { return f.coverage_total; }),
          g.sum(&RunFigures::collisions),
          g.least([](const RunFigures& f) { return f.clearance; }),
          of_links(g.sum(&RunFigures::link_collisions)),
          of_links(g.least([](const RunFigures& f) { return f.link_clearance; })),
          of_links(g.least([](const RunFigures& f) { return f.link_own_clearance; })),
          g.median([](const RunFigures& f) { return f.seconds_per_set(); }),
          thesis.seconds,
          g.sum(&RunFigures::violations)};
}

Table empty_table() {
  return Table({{"object"},
                {"robot"},
                {"strategy"},
                {"avoidance"},
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
                {"link_collisions"},
                {"link_clearance_worst", 3},
                {"link_own_clearance_worst", 3},
                {"seconds_a_step", 2},
                {"thesis_seconds", 4},
                {"violations"}});
}

}  // namespace

Measured measure_table1(const RunPlan& plan, const Table1Options& options) {
  Measured measured;
  Table table = empty_table();
  for (const Kind& kind : kinds_of(options)) {
    const std::vector<Object> wanted = objects_for(kind, options);
    std::vector<RunCase> cases;
    for (const Object& object : wanted)
      add_runs(plan, object.name, scene_of(plan, options, object, kind), cases);
    const auto made = make_runs(cases, plan.workers);
    measured.runs.insert(measured.runs.end(), made.begin(), made.end());
    const auto groups = grouped(made);
    for (std::size_t i = 0; i < groups.size(); ++i)
      table.add(row_of(groups[i], kind, kind.is_arm() ? wanted[i].arm : wanted[i].point));
  }
  measured.tables.push_back(
      {"Range images from one side, beside thesis Table 1 (" + seeds_text(plan) +
           "); coverage is of all the surface, clearance over δ − λ, that of links over λ",
       table});
  return measured;
}

}  // namespace limpet::benchmarks
