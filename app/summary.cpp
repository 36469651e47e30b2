// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/summary.hpp>
#include <limpet/io/text.hpp>

#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <limpet/app/progress.hpp>
#include <limpet/io/lifted.hpp>
#include <limpet/io/native.hpp>
#include <limpet/io/welded.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

namespace limpet::app {
namespace {

std::string angle_line(const SuggestedAngle& found) {
  char line[160];
  std::snprintf(line, sizeof line,
                "most of them lie at bends of %.1f degrees and more, which --angle %g would tell apart\n",
                found.least_bend_deg, found.angle_deg);
  return line;
}

}  // namespace

Summary summarise(const model::ModelRecord& model, std::span<const model::OpenEdge> open_edges) {
  Summary s;
  s.points = model.points;
  s.refused = model.refused;
  s.expired = model.expired;
  s.sets = model.sets;
  s.resolution = survey::resolution_of(model.parameters);
  s.noise = survey::noise_of(model.parameters);
  s.tolerance = model.parameters.tolerance;
  s.polygons = static_cast<std::int64_t>(model.polygon_segments.size());
  s.segments = s.polygons + static_cast<std::int64_t>(model.point_segments.size());
  for (const auto& segment : model.point_segments) s.loose += segment.moments.count;
  std::int64_t shared = 0;
  for (const auto& segment : model.polygon_segments) {
    s.confirmed += segment.confirmed;
    s.holes += static_cast<std::int64_t>(segment.cycles.size()) - 1;
    for (const auto& cycle : segment.cycles) {
      for (const auto& vertex : cycle) ++(vertex.partner != 0 ? shared : s.open_edges);
    }
  }
  s.shared_edges = shared / 2;
  for (const model::OpenEdge& open : open_edges) ++s.open_because[open.refusal];
  s.redundant_by_count = model.redundant_by_count;
  s.redundant_by_position = model.redundant_by_position;
  const std::vector<io::LiftedPolygon> polygons = io::lift(model);
  s.suggested_angle = suggested_angle(polygons, open_edges);
  const auto welds = io::weld(polygons, model.parameters.resolution);
  s.corner_vertices = welds.corners;
  s.corner_distance = welds.corner_distance;
  return s;
}

std::string to_json(const Summary& s) {
  nlohmann::ordered_json json;
  json["points"] = s.points;
  json["points_loose"] = s.loose;
  json["points_refused"] = s.refused;
  json["points_expired"] = s.expired;
  json["points_confirmed"] = s.confirmed;
  json["sets"] = s.sets;
  json["segments"] = s.segments;
  json["polygons"] = s.polygons;
  json["holes"] = s.holes;
  json["shared_edges"] = s.shared_edges;
  json["open_edges"] = s.open_edges;
  json["open_because"] = nlohmann::ordered_json::object();
  for (const auto& [refusal, count] : s.open_because) json["open_because"][name(refusal)] = count;
  json["suggested_angle_deg"] = nullptr;
  if (s.suggested_angle) json["suggested_angle_deg"] = s.suggested_angle->angle_deg;
  json["redundant_by_count"] = s.redundant_by_count;
  json["redundant_by_position"] = s.redundant_by_position;
  json["corner_vertices"] = s.corner_vertices;
  json["corner_distance"] = s.corner_distance;
  json["closed"] = s.closed();
  json["seconds"] = s.seconds;
  json["points_per_second"] = s.seconds > 0 ? static_cast<double>(s.points) / s.seconds : 0.0;
  json["peak_memory_bytes"] = peak_memory_bytes();
  json["violations"] = s.violations;
  json["resolution"] = s.resolution.fixed;
  json["resolution_per_range"] = s.resolution.per_range;
  json["noise"] = s.noise.fixed;
  json["noise_per_range"] = s.noise.per_range;
  json["noise_per_range2"] = s.noise.per_range2;
  json["tolerance"] = s.tolerance;
  json["order"] = s.in_arrival_order ? "arrival" : "curve";
  json["order_disk_bytes"] = s.order_disk_bytes;
  json["axes_guessed"] = s.axes_guessed;
  json["interrupted"] = s.interrupted;
  json["damage"] = s.damage;
  // Names and messages may hold bytes that are no UTF-8.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string to_text(const Summary& s) {
  std::ostringstream text;
  text << io::grouped(s.points) << " points in " << io::grouped(s.sets)
       << " sets: " << io::grouped(s.polygons) << (s.polygons == 1 ? " polygon" : " polygons");
  if (s.holes > 0) text << " with " << io::grouped(s.holes) << (s.holes == 1 ? " hole" : " holes");
  text << ", " << io::grouped(s.shared_edges) << " shared edges, " << io::grouped(s.corner_vertices)
       << " corners, ";
  text << (s.closed() ? "closed" : io::grouped(s.open_edges) + " open edges") << "\n";
  if (!s.open_because.empty()) {
    text << "open because:";
    for (const auto& [refusal, count] : s.open_because)
      text << (refusal == s.open_because.begin()->first ? " " : ", ") << io::grouped(count) << " "
           << words(refusal);
    text << "\n";
  }
  if (s.suggested_angle) text << angle_line(*s.suggested_angle);
  if (s.redundant_by_count + s.redundant_by_position > 0) {
    text << "redundant segments deleted: " << io::grouped(s.redundant_by_count) << " by their points, "
         << io::grouped(s.redundant_by_position) << " by position\n";
  }
  if (s.confirmed > 0) text << "on faces known beforehand: " << io::grouped(s.confirmed) << " points\n";
  if (s.loose + s.refused + s.expired > 0) {
    text << "in no polygon: " << io::grouped(s.loose) << " points loose, " << io::grouped(s.expired)
         << " given up as outliers; " << io::grouped(s.refused) << " records were no point\n";
  }
  if (s.order_disk_bytes > 0)
    text << "put in order through " << io::grouped(s.order_disk_bytes / 1'000'000)
         << " MB of temporary files\n";
  char line[160];
  std::snprintf(
      line, sizeof line, "resolution %s, noise %s, tolerance %.4g; %.2f s, %s points/s, %s MB\n",
      short_text(s.resolution).c_str(), short_text(s.noise).c_str(), s.tolerance, s.seconds,
      io::grouped(s.seconds > 0 ? std::llround(static_cast<double>(s.points) / s.seconds) : 0).c_str(),
      io::grouped(peak_memory_bytes() / 1'000'000).c_str());
  text << line;
  text << (s.violations == 0 ? "the oracle finds nothing broken\n"
                             : "the oracle finds " + io::grouped(s.violations) + " broken laws\n");
  return text.str();
}

std::int64_t peak_memory_bytes() {
  struct rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

std::vector<audit::Violation> judge(const model::ModelRecord& model) {
  std::stringstream text;
  io::write_native(text, model);
  return audit::judge(audit::parse_document(text));
}

}  // namespace limpet::app
