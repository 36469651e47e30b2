// Copyright the limpet authors. GPL-3.0-or-later.
#include <cstdio>
#include <limpet/app/arguments.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/app/outputs.hpp>
#include <limpet/app/progress.hpp>
#include <limpet/evaluation/label_overlaps.hpp>
#include <limpet/evaluation/region_score.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/label_source.hpp>
#include <limpet/io/native.hpp>
#include <limpet/io/text.hpp>
#include <nlohmann/json.hpp>
#include <set>

namespace limpet::app {
namespace {

using evaluation::kNoRegion;
using evaluation::RegionFate;
using evaluation::RegionScore;

/// The identities of the polygons of a native model; nothing when none is given.
std::optional<std::set<std::int64_t>> polygons_of(const std::string& path) {
  if (path.empty()) return std::nullopt;
  refuse_folder(path);
  std::set<std::int64_t> polygons;
  for (const auto& segment : io::load_native(path).polygon_segments) {
    polygons.insert(static_cast<std::int64_t>(segment.id));
  }
  return polygons;
}

std::string name_of(const std::string& path) { return path == "-" ? "standard input" : path; }

evaluation::CountedOverlaps read_overlaps(const CompareArguments& args) {
  const auto polygons = polygons_of(args.labels.polygons);
  io::LabelSource found(args.model, ""), truth(args.truth, args.labels.column);
  // What was found may come as a list or as a scan: 0 is in no segment.
  const evaluation::RegionLabels found_regions{{{0, 0}}, polygons};
  const evaluation::RegionLabels true_regions{args.labels.none.value_or(evaluation::usual_none(truth)), {}};
  Progress progress("comparing", -1, args.quiet);
  return evaluation::count_overlaps({truth, true_regions, name_of(args.truth)},
                                    {found, found_regions, name_of(args.model)},
                                    [&](std::int64_t records) { progress.step(records); });
}

const char* text_of(RegionFate fate, bool is_true) {
  switch (fate) {
    case RegionFate::correct:
      return "correct";
    case RegionFate::over_segmented:
      return is_true ? "over_segmented" : "piece";
    case RegionFate::under_segmented:
      return is_true ? "merged" : "under_segmented";
    case RegionFate::unmatched:
      return is_true ? "missed" : "noise";
  }
  return "";
}

using Json = nlohmann::ordered_json;

Json label_json(std::int64_t label) { return label == kNoRegion ? Json(nullptr) : Json(label); }

Json to_json(const evaluation::TrueRegion& region) {
  return {{"label", region.label},
          {"points", region.points},
          {"fate", text_of(region.fate, true)},
          {"found", region.found},
          {"main_found", label_json(region.main_found)},
          {"covered", region.covered()},
          {"covered_by_main", region.covered_by_main()}};
}

Json to_json(const evaluation::FoundRegion& region) {
  return {{"label", region.label},
          {"points", region.points},
          {"fate", text_of(region.fate, false)},
          {"truth", region.truth},
          {"main_true", label_json(region.main_true)},
          {"purity", region.purity()}};
}

std::string to_json(const RegionScore& score, const LabelArguments& args, std::int64_t records, bool within) {
  Json json;
  json["records"] = records;
  json["points"] = score.points;
  json["points_left_out"] = score.left_out;
  json["overlap"] = args.overlap;
  json["true_regions"] = score.truth.size();
  json["found_regions"] = score.found.size();
  json["correct"] = score.correct;
  json["over_segmented"] = score.over_segmented;
  json["under_segmented"] = score.under_segmented;
  json["missed"] = score.missed;
  json["noise"] = score.noise;
  json["merged"] = score.merged;
  json["pieces"] = score.pieces;
  json["correct_share"] = score.correct_share();
  json["purity"] = score.purity;
  json["covered"] = score.covered;
  json["within_bounds"] = within;
  json["truth"] = Json::array();
  for (const auto& region : score.truth) json["truth"].push_back(to_json(region));
  json["found"] = Json::array();
  for (const auto& region : score.found) json["found"].push_back(to_json(region));
  return json.dump(2) + "\n";
}

void print(const RegionScore& score) {
  std::printf("true regions %zu: %d correct, %d over-segmented, %d merged, %d missed\n", score.truth.size(),
              score.correct, score.over_segmented, score.merged, score.missed);
  std::printf("found regions %zu: %d correct, %d pieces, %d under-segmented, %d noise\n", score.found.size(),
              score.correct, score.pieces, score.under_segmented, score.noise);
  std::printf("covered: %.1f %% of the points of true regions; pure: %.1f %% of the points of found ones\n",
              100 * score.covered, 100 * score.purity);
}

}  // namespace

int run_by_labels(const CompareArguments& args) {
  if (args.max_distance || args.faces_exact) {
    throw UsageError("--max-distance and --faces compare surfaces; they do not go with --labels");
  }
  refuse_folder(args.model);
  refuse_folder(args.truth);
  if (!args.json.empty() && args.json != "-") require_writable(args.json);
  const evaluation::CountedOverlaps overlaps = read_overlaps(args);
  if (overlaps.records == 0) throw io::InputError(name_of(args.model), "holds no label");
  const LabelArguments& labels = args.labels;
  RegionScore score;
  try {
    score = evaluation::score_regions(overlaps.overlaps, {labels.overlap, labels.min_true, labels.min_found});
  } catch (const std::invalid_argument& error) {
    throw UsageError("--overlap " + io::short_text(labels.overlap) + ": " + error.what());
  }
  if (score.truth.empty()) {
    throw io::InputError(name_of(args.truth), "tells no region of " + std::to_string(labels.min_true) +
                                                  " points or more; see --column, --none and --min-true");
  }
  const bool within = !labels.min_correct || score.correct_share() >= *labels.min_correct;
  Outputs outputs;
  if (!args.json.empty())
    outputs.attempt(args.json,
                    [&] { save_text(args.json, to_json(score, labels, overlaps.records, within)); });
  if (!args.quiet && args.json != "-") print(score);
  if (!within) {
    std::fprintf(stderr, "limpet: outside the bounds: %.4g of the true regions correct, --min-correct %.4g\n",
                 score.correct_share(), *labels.min_correct);
  }
  outputs.require_all();
  return within ? kDone : kFallsShort;
}

}  // namespace limpet::app
