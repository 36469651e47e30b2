// Copyright the limpet authors. GPL-3.0-or-later.
#include <cstdio>
#include <limpet/app/arguments.hpp>
#include <limpet/app/check_evidence.hpp>
#include <limpet/app/page_links.hpp>
#include <limpet/app/progress.hpp>
#include <limpet/app/scan_choices.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/text.hpp>
#include <nlohmann/json.hpp>
#include <utility>

namespace limpet::app {
namespace {

using evaluation::Evidence;
using evaluation::PolygonEvidence;

constexpr std::int64_t kMostReadings = 20'000'000;  ///< they are all kept: some 4 GB

/// What `limpet model` was given, as far as the model and these arguments tell.
ModelArguments as_modelled(const CheckArguments& args, const model::Parameters& parameters) {
  ModelArguments modelled;
  modelled.scan = args.scan;
  modelled.viewpoint = args.viewpoint;
  modelled.orient = args.orient;
  modelled.resolution = survey::resolution_of(parameters);
  modelled.tolerance = parameters.tolerance;
  modelled.noise = survey::noise_of(parameters);
  return modelled;
}

void require_ranges(survey::PointStream& scan, const survey::NoiseLaw& noise) {
  if (noise.varies() && scan.first()->point.range == 0)
    throw io::InputError(scan.name(),
                         "does not say from how far its points were sensed, and the model's noise grows with "
                         "that; give --viewpoint as for limpet model");
}

std::vector<model::SensorPoint> read_all(survey::PointStream& scan, bool quiet) {
  Progress progress("reading", scan.promised(), quiet);
  std::vector<model::SensorPoint> readings;
  survey::Reading reading;
  while (scan.next(reading)) {
    if (static_cast<std::int64_t>(readings.size()) == kMostReadings)
      throw io::InputError(scan.name(), "holds more than " + io::grouped(kMostReadings) +
                                            " points, too many to judge a model by at once");
    readings.push_back(reading.point);
    progress.step(static_cast<std::int64_t>(readings.size()));
  }
  progress.clear();
  if (!scan.damage().empty()) throw io::InputError(scan.damage());
  return readings;
}

nlohmann::ordered_json place_to_json(const Eigen::Vector3d& p) {
  return nlohmann::ordered_json::array({p.x(), p.y(), p.z()});
}

nlohmann::ordered_json polygon_to_json(const PolygonEvidence& polygon) {
  return {{"id", polygon.id},
          {"area", polygon.area},
          {"readings", polygon.readings},
          {"density", polygon.density},
          {"given", polygon.given},
          {"empty_centre", place_to_json(polygon.emptiest.centre)},
          {"empty_radius", polygon.emptiest.radius},
          {"empty_expected", polygon.emptiest.expected},
          {"empty_excused", polygon.emptiest.excused},
          {"empty_area", polygon.empty_area},
          {"rays_on", polygon.rays_on},
          {"rays_through", polygon.rays_through},
          {"beyond_chance", polygon.beyond_chance},
          {"unsupported", polygon.unsupported},
          {"transparent", polygon.transparent}};
}

std::string place_text(const Eigen::Vector3d& p) {
  return "(" + io::short_text(p.x()) + ", " + io::short_text(p.y()) + ", " + io::short_text(p.z()) + ")";
}

/// "holds no reading within 0.4 of (1, 2, 3), where 60 are expected"
std::string disc_text(const evaluation::EmptyDisc& disc) {
  return "no reading within " + io::short_text(disc.radius) + " of " + place_text(disc.centre) + ", where " +
         io::short_text(disc.expected) + " are expected";
}

std::string percent(double share) { return io::short_text(100 * share) + " %"; }

}  // namespace

Evidence judge_by_scan(const CheckArguments& args, const model::ModelRecord& model) {
  refuse_folder(args.scan);
  const ModelArguments modelled = as_modelled(args, model.parameters);
  survey::PointStream scan = open_scan(modelled);
  survey::require_points(scan);
  require_ranges(scan, *modelled.noise);
  warn_of_axes(scan);
  const survey::Choice choice = choose(scan, modelled);
  if (choice.voxel_edge > 0) orient(scan, modelled, choice.voxel_edge);
  return evaluation::judge_evidence(model, read_all(scan, args.quiet));
}

nlohmann::ordered_json evidence_json(const Evidence& evidence) {
  nlohmann::ordered_json json;
  json["within_bounds"] = evidence.within_bounds();
  json["readings"] = evidence.readings;
  json["explained"] = evidence.explained;
  json["explained_share"] = evidence.explained_share();
  json["chance"] = evidence.chance;
  json["bound"] = evaluation::kSupportMargin * evidence.chance;
  json["beyond_chance"] = evidence.beyond_chance;
  json["unsupported"] = evidence.unsupported;
  json["empty_area"] = evidence.empty_area;
  json["emptiest"] = evidence.emptiest < 0 ? 0 : evidence.polygons[evidence.emptiest].id;
  json["rays"] = evidence.rays;
  json["transparent"] = evidence.transparent;
  json["polygons"] = nlohmann::ordered_json::array();
  for (const PolygonEvidence& polygon : evidence.polygons)
    json["polygons"].push_back(polygon_to_json(polygon));
  return json;
}

std::string evidence_text(const Evidence& evidence, const std::string& name, const std::string& page,
                          bool quiet) {
  std::string text;
  const auto see = [&](std::uint64_t polygon) {
    return page.empty() ? std::string() : "; see " + page_link(page, "polygon", polygon);
  };
  const auto say = [&](const std::string& line) { text += name + ": " + line + "\n"; };
  for (const PolygonEvidence& polygon : evidence.polygons) {
    const std::string who = "polygon " + std::to_string(polygon.id) + ": ";
    if (polygon.unsupported) say("unsupported: " + who + disc_text(polygon.emptiest) + see(polygon.id));
    if (polygon.transparent)
      say("transparent: " + who + io::grouped(polygon.rays_through) + " rays pass through it, " +
          io::grouped(polygon.rays_on) + " end on it" + see(polygon.id));
  }
  if (quiet) return text;
  if (evidence.emptiest >= 0) {
    const PolygonEvidence& worst = evidence.polygons[evidence.emptiest];
    say("support: " + io::grouped(evidence.beyond_chance) + " of " +
        io::grouped(static_cast<std::int64_t>(evidence.polygons.size())) +
        " polygons have an empty disc beyond chance (" + io::short_text(evidence.chance) +
        " readings expected in it; the bound is " +
        io::short_text(evaluation::kSupportMargin * evidence.chance) + "), " +
        io::short_text(evidence.empty_area) + " of area beyond; the emptiest: polygon " +
        std::to_string(worst.id) + ", " + disc_text(worst.emptiest) + see(worst.id));
  }
  say("explained: " + percent(evidence.explained_share()) + " of " + io::grouped(evidence.readings) +
      " readings are on a polygon");
  say(evidence.rays == 0 ? "transparent: not judged, as the scan does not say where its sensor stood"
                         : "transparent: " + io::grouped(evidence.transparent) + " polygons, by " +
                               io::grouped(evidence.rays) + " rays");
  return text;
}

}  // namespace limpet::app
