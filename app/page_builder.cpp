// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>
#include <cstdint>
#include <limpet/following/follower.hpp>
#include <limpet/model/open_edges.hpp>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "page_builder_internal.hpp"

namespace limpet::app::internal {
namespace {

using drawing::TimelineEvent;
using nlohmann::json;

constexpr double kDegrees = 180 / std::numbers::pi;

json numbers_of(const Eigen::Isometry3d& pose) {
  json numbers = json::array();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) numbers.push_back(pose.linear()(row, column));
  for (int k = 0; k < 3; ++k) numbers.push_back(pose.translation()[k]);
  return numbers;
}

/// null where there is no limit
json limit_of(double position) { return std::isfinite(position) ? json(position) : json(); }

json json_of(const kinematics::Link& link) {
  static constexpr const char* kKinds[] = {"fixed", "prismatic", "revolute"};
  json capsules = json::array();
  for (const model::Capsule& part : link.body)
    capsules.push_back(
        {{"a", internal::json_of(part.a)}, {"b", internal::json_of(part.b)}, {"radius", part.radius}});
  return {{"name", link.name},
          {"parent", link.parent ? static_cast<std::int64_t>(*link.parent) : -1},
          {"kind", kKinds[static_cast<std::size_t>(link.joint.kind)]},
          {"axis", internal::json_of(link.joint.axis)},
          {"low", limit_of(link.joint.low)},
          {"high", limit_of(link.joint.high)},
          {"mounting", numbers_of(link.mounting)},
          {"capsules", std::move(capsules)}};
}

/// A range sensor or a switch.
template <class Mounted>
json json_of_mounted(const Mounted& sensor) {
  return {{"link", sensor.link},
          {"position", internal::json_of(sensor.position)},
          {"axis", internal::json_of(sensor.axis)},
          {"range", sensor.range}};
}

json refusals() {
  json all = json::array();
  for (std::size_t i = 0; i < model::kRefusals; ++i) {
    const auto refusal = static_cast<model::Refusal>(i);
    all.push_back({{"name", model::name(refusal)}, {"words", model::words(refusal)}});
  }
  return all;
}

/// The edges of a mesh where one of its faces ends.
std::vector<std::uint32_t> face_ends(const simulation::Mesh& mesh) {
  std::map<std::pair<int, int>, std::vector<int>> faces_at;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      faces_at[std::minmax(a, b)].push_back(mesh.face_of_triangle[t]);
    }
  std::vector<std::uint32_t> ends;
  for (const auto& [edge, faces] : faces_at)
    if (faces.size() != 2 || faces[0] != faces[1])
      ends.insert(ends.end(),
                  {static_cast<std::uint32_t>(edge.first), static_cast<std::uint32_t>(edge.second)});
  return ends;
}

}  // namespace

json json_of(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

json json_of(const kinematics::Robot& robot) {
  json links = json::array(), sensors = json::array(), switches = json::array();
  for (const kinematics::Link& link : robot.links) links.push_back(json_of(link));
  for (const kinematics::RangeSensor& sensor : robot.sensors) sensors.push_back(json_of_mounted(sensor));
  for (const kinematics::ProximitySwitch& s : robot.switches) switches.push_back(json_of_mounted(s));
  json all = {{"name", robot.name},
              {"links", std::move(links)},
              {"sensors", std::move(sensors)},
              {"control_point",
               {{"link", robot.control_point.link}, {"position", json_of(robot.control_point.position)}}}};
  if (!switches.empty()) all["switches"] = std::move(switches);
  return all;
}

PageBuilder::PageBuilder(const std::string& kind, const std::string& name,
                         const model::Parameters& parameters, const drawing::TimelineSpace& space)
    : space_(space) {
  head = {{"kind", kind},
          {"name", name},
          {"program", "limpet " LIMPET_VERSION},
          {"resolution", parameters.resolution},
          {"angle_deg", parameters.angle_rad * kDegrees},
          {"noise", {parameters.noise, parameters.noise_per_range, parameters.noise_per_range2}},
          {"tolerance", parameters.tolerance},
          {"unit", space.step},
          {"origin", json_of(space.origin)},
          {"finished", false},
          {"refusals", refusals()}};
  for (std::size_t i = 0; i < following::kModeCount; ++i)
    head["modes"].push_back(following::name_of(static_cast<following::Mode>(i)));
  for (std::size_t i = 0; i < drawing::kTimelineEventKinds; ++i)
    head["event_kinds"].push_back(drawing::name_of(static_cast<TimelineEvent::Kind>(i)));
}

void PageBuilder::add_truth(const std::string& name, const simulation::Mesh& mesh) {
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;
  for (const Eigen::Vector3d& vertex : mesh.vertices) drawing::append(positions, vertex - space_.origin);
  for (const auto& triangle : mesh.triangles)
    for (const int corner : triangle) triangles.push_back(static_cast<std::uint32_t>(corner));
  head["truth"] = {{"name", name}};
  data.put("truth_position", positions);
  data.put("truth_triangle", triangles);
  data.put("truth_line", face_ends(mesh));
}

void PageBuilder::add(const drawing::Timeline& timeline) {
  Eigen::AlignedBox3d box = timeline.box();
  if (box.isEmpty()) box.extend(space_.origin);
  head["box"] = {{"low", json_of(box.min())}, {"high", json_of(box.max())}};
  head["steps"] = timeline.steps();
  std::vector<std::uint32_t> steps, first, second;
  std::vector<std::uint8_t> kinds;
  for (const TimelineEvent& event : timeline.events()) {
    steps.push_back(event.step);
    kinds.push_back(static_cast<std::uint8_t>(event.kind));
    first.push_back(static_cast<std::uint32_t>(event.a));
    second.push_back(static_cast<std::uint32_t>(event.b));
  }
  data.put("timeline", timeline.stream());
  data.put("area", timeline.area());
  data.put("open_length", timeline.open_length());
  data.put("event_step", steps);
  data.put("event_kind", kinds);
  data.put("event_a", first);
  data.put("event_b", second);
}

}  // namespace limpet::app::internal
