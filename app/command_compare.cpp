// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>
#include <cstdio>
#include <limpet/app/arguments.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/app/file_roles.hpp>
#include <limpet/app/outputs.hpp>
#include <limpet/evaluation/judgement.hpp>
#include <limpet/evaluation/subject.hpp>
#include <limpet/io/text.hpp>
#include <limpet/simulation/scene.hpp>
#include <nlohmann/json.hpp>
#include <optional>

namespace limpet::app {
namespace {

nlohmann::ordered_json to_json(const evaluation::DistanceSummary& d) {
  // JSON has no infinity: a model without area has null distances.
  const auto number = [](double x) {
    return std::isfinite(x) ? nlohmann::ordered_json(x) : nlohmann::ordered_json(nullptr);
  };
  return {{"max", number(d.max)},
          {"mean", number(d.mean)},
          {"median", number(d.median)},
          {"p90", number(d.p90)},
          {"p99", number(d.p99)}};
}

void print_row(const char* name, const evaluation::DistanceSummary& d) {
  std::printf("%s  mean %-10.4g median %-10.4g 90 %% %-10.4g 99 %% %-10.4g max %.4g\n", name, d.mean,
              d.median, d.p90, d.p99, d.max);
}

}  // namespace

int run(const CompareArguments& args) {
  FileRoles files;
  files.reads("MODEL", args.model);
  files.reads("TRUTH", args.truth);
  files.reads("--polygons", args.labels.polygons);
  files.writes("--json", args.json);
  files.require_apart();
  if (args.by_labels) return run_by_labels(args);
  refuse_folder(args.model);
  refuse_folder(args.truth);
  const evaluation::Subject subject = evaluation::load_subject(args.model);
  const simulation::Mesh truth = simulation::make_scene(args.truth).mesh;
  const evaluation::Comparison c = evaluation::compare(subject.faces, truth);
  const double worst = std::max(c.model_to_truth.max, c.truth_to_model.max);
  const bool near = !args.max_distance || worst <= *args.max_distance;
  const bool faces = !args.faces_exact || c.polygons == c.true_faces;

  Outputs outputs;
  if (!args.json.empty()) {
    nlohmann::ordered_json json;
    json["model_to_truth"] = to_json(c.model_to_truth);
    json["truth_to_model"] = to_json(c.truth_to_model);
    json["polygons"] = c.polygons;
    json["true_faces"] = c.true_faces;
    json["model_area"] = c.model_area;
    json["true_area"] = c.true_area;
    json["open_edges"] = subject.open_edges;
    json["closed"] = subject.closed();
    json["within_bounds"] = near && faces;
    outputs.attempt(args.json, [&] { save_text(args.json, json.dump(2) + "\n"); });
  }
  if (!args.quiet && args.json != "-") {
    print_row("model to truth:", c.model_to_truth);
    print_row("truth to model:", c.truth_to_model);
    std::printf("polygons %ld, true faces %ld; area %.6g, true area %.6g; %s\n",
                static_cast<long>(c.polygons), static_cast<long>(c.true_faces), c.model_area, c.true_area,
                subject.closed() ? "closed" : (std::to_string(subject.open_edges) + " open edges").c_str());
  }
  if (!near) {
    std::fprintf(stderr,
                 "limpet: outside the bounds: the largest distance %.6g is above --max-distance %.6g\n",
                 worst, *args.max_distance);
  }
  if (!faces) {
    std::fprintf(stderr, "limpet: outside the bounds: %ld polygons for %ld true faces\n",
                 static_cast<long>(c.polygons), static_cast<long>(c.true_faces));
  }
  outputs.require_all();
  return near && faces ? kDone : kFallsShort;
}

}  // namespace limpet::app
