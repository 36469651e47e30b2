// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/follow_summary.hpp>

#include <cstdio>
#include <limpet/io/text.hpp>
#include <limpet/survey/noise_law.hpp>
#include <nlohmann/json.hpp>

namespace limpet::app {
namespace {

using survey::quantile;

std::string microseconds(const std::vector<double>& times) {
  char text[80];
  std::snprintf(text, sizeof text, "%.0f us (99 %%: %.0f)", quantile(times, 0.5), quantile(times, 0.99));
  return text;
}

double length_of(const std::vector<Eigen::Vector3d>& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  return length;
}

}  // namespace

std::string to_json(const FollowSummary& s) {
  nlohmann::ordered_json json;
  const FollowOutcome& run = s.run;
  json["sets"] = run.path.size();
  json["readings"] = run.readings;
  if (s.has_switches) json["link_sensors"] = "switches";
  json["points_confirmed"] = s.model.confirmed;
  json["ended"] = run.ended;
  if (run.collision)
    json["collision"] = {{"set", run.collision->set},
                         {"part", run.collision->part},
                         {"with", run.collision->with},
                         {"depth", run.collision->depth}};
  json["closed"] = s.model.closed();
  json["polygons"] = s.model.polygons;
  json["open_edges"] = s.model.open_edges;
  json["path_length"] = length_of(run.path);
  json["unreachable"] = run.marks.unreachable_segments.size() + run.marks.unreachable_edges.size();
  json["unclosable"] = run.marks.unclosable_edges.size();
  if (!run.stuck_sensors.empty()) json["stuck_sensors"] = run.stuck_sensors;
  if (!run.stuck_joints.empty()) json["stuck_joints"] = run.stuck_joints;
  if (s.truth) {
    json["coverage"] = s.truth->coverage;
    json["coverage_total"] = s.truth->coverage_total;
    json["reachable"] = s.truth->reachable_share;
    json["doubtful"] = s.truth->doubtful_share;
    json["collisions"] = s.truth->collisions + (s.links ? s.links->collisions + s.links->self_collisions : 0);
    json["clearance_control_point"] = s.truth->clearance_control_point;
    json["clearance_links"] = s.links ? s.links->to_surface : s.truth->clearance_control_point;
    if (s.links) json["clearance_of_itself"] = s.links->to_itself;
    if (s.links) json["clearance_links_model"] = run.link_clearance;
    json["false_unreachable"] = s.truth->false_unreachable;
    json["isomorphic"] = s.truth->isomorphic;
    if (s.truth->tour) {
      json["tour_sets"] = s.truth->tour->sets;
      json["tour_length"] = s.truth->tour->path_length;
    }
  }
  if (!run.step_us.empty()) {
    json["step_us_median"] = quantile(run.step_us, 0.5);
    json["step_us_p99"] = quantile(run.step_us, 0.99);
  }
  json["model_us_median"] = quantile(run.model_us, 0.5);
  json["model_us_p99"] = quantile(run.model_us, 0.99);
  json["modes"] = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < run.steps_in_mode.size(); ++i)
    if (run.steps_in_mode[i] > 0)
      json["modes"][std::string(following::name_of(static_cast<following::Mode>(i)))] = run.steps_in_mode[i];
  json["violations"] = s.model.violations;
  json["resolution"] = s.model.resolution.fixed;
  json["noise"] = s.model.noise.fixed;
  json["tolerance"] = s.model.tolerance;
  json["seconds"] = s.seconds;
  json["peak_memory_bytes"] = peak_memory_bytes();
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string to_text(const FollowSummary& s) {
  char line[240];
  std::snprintf(line, sizeof line, "%s after %s sets, a path of %.4g\n", s.run.ended.c_str(),
                io::grouped(static_cast<std::int64_t>(s.run.path.size())).c_str(), length_of(s.run.path));
  std::string text = line;
  if (s.truth) {
    std::snprintf(line, sizeof line,
                  "of the reachable surface %.2f %% is modelled (of all of it %.2f %%); %s\n",
                  100 * s.truth->coverage, 100 * s.truth->coverage_total,
                  s.truth->isomorphic ? "the model has the faces and edges of the truth"
                                      : "its faces and edges are not those of the truth");
    text += line;
    std::snprintf(line, sizeof line, "%s collisions; the control point came as near as %.3g to the surface\n",
                  io::grouped(static_cast<std::int64_t>(s.truth->collisions)).c_str(),
                  s.truth->clearance_control_point);
    text += line;
  }
  if (s.links) {
    std::snprintf(line, sizeof line,
                  "the links came as near as %.3g to the surface (%s touches) and %.3g to each other (%s)\n",
                  s.links->to_surface, io::grouped(static_cast<std::int64_t>(s.links->collisions)).c_str(),
                  s.links->to_itself,
                  io::grouped(static_cast<std::int64_t>(s.links->self_collisions)).c_str());
    text += line;
  }
  const std::size_t marked = s.run.marks.unreachable_segments.size() + s.run.marks.unreachable_edges.size();
  if (marked + s.run.marks.unclosable_edges.size() > 0)
    text += "given up: " + io::grouped(static_cast<std::int64_t>(marked)) +
            " edges or segments as unreachable, " +
            io::grouped(static_cast<std::int64_t>(s.run.marks.unclosable_edges.size())) +
            " edges as unclosable\n";
  for (const std::size_t joint : s.run.stuck_joints)
    text += "joint " + std::to_string(joint) +
            " did not move when it was told to: it was held still once that was seen\n";
  for (const std::size_t sensor : s.run.stuck_sensors)
    text += "sensor " + std::to_string(sensor) +
            " said the same distance wherever it was: its readings were left out once that was seen\n";
  if (!s.run.step_us.empty()) text += "a step takes " + microseconds(s.run.step_us) + " to decide\n";
  return text + "a set takes " + microseconds(s.run.model_us) + " to model\n" + to_text(s.model);
}

}  // namespace limpet::app
