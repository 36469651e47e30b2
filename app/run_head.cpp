// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/io/text.hpp>
#include <stdexcept>

#include "run_head_internal.hpp"

namespace limpet::app::internal {
namespace {

/// Runs `check` and says what it finds with the line.
template <class Check>
void require(RunFields& fields, const Check& check) {
  try {
    check();
  } catch (const std::invalid_argument& error) {
    fields.fail(error.what());
  }
}

void read_version(RunFields& fields) {
  if (!fields.next() || !fields.optional("limpet") || !fields.optional("run"))
    fields.fail("is no recorded run of limpet");
  const std::string_view format = fields.word();
  if (format != kRunFormat) fields.fail("the format " + io::in_quotes(format) + " is not known here");
  fields.done();
}

double real_line(RunFields& fields, std::string_view word) {
  fields.line(word);
  const double value = fields.real();
  fields.done();
  return value;
}

model::Parameters read_model(RunFields& fields) {
  model::Parameters p;
  p.resolution = real_line(fields, "resolution");
  p.angle_rad = real_line(fields, "angle");
  fields.line("noise");
  p.noise = fields.real(), p.noise_per_range = fields.real(), p.noise_per_range2 = fields.real();
  fields.done();
  p.input_quantum = real_line(fields, "quantum");
  p.tolerance = real_line(fields, "tolerance");
  fields.line("patience");
  p.outlier_patience = fields.integer<std::int64_t>();
  fields.done();
  fields.line("redundancy");
  p.redundancy_count = fields.real(), p.redundancy_ratio = fields.real();
  if (p.redundancy_count < 0 || p.redundancy_ratio < 0) fields.fail("ψ and φ must be 0 or more");
  fields.done();
  fields.line("neighbours");
  p.neighbours = fields.one_of({"yes", "no"}) == "yes";
  fields.done();
  fields.line("rules");
  require(fields, [&] { p.rules = model::Rules::parse(fields.word()); });
  fields.done();
  require(fields, [&] { const model::Model model(p); });
  return p;
}

following::Strategy read_strategy(RunFields& fields) {
  fields.line("strategy");
  const bool thesis = fields.one_of({"frontier", "thesis"}) == "thesis";
  fields.done();
  return thesis ? following::Strategy::thesis : following::Strategy::frontier;
}

/// What else there is of them follows from the parameters of following.
following::LinkParameters read_links(RunFields& fields, const following::Parameters& p) {
  const bool thesis = fields.one_of({"programme", "thesis"}) == "thesis";
  following::LinkParameters links = following::usual_link_parameters(
      p, thesis ? following::Redundancy::thesis : following::Redundancy::programme);
  links.objective.gain = fields.real();
  const auto exponent = fields.integer<std::int64_t>();
  links.objective.influence = fields.real();
  if (exponent < 1 || exponent > 1000) fields.fail("g must be from 1 to 1000");
  links.objective.exponent = static_cast<int>(exponent);
  if (!(links.objective.influence > 0)) fields.fail("√(2 d₀) must be more than 0");
  return links;
}

void read_following(RunFields& fields, RunHead& head) {
  following::Parameters p;
  fields.line("follow");
  p.resolution = fields.real(), p.angle_rad = fields.real();
  p.follow_distance = fields.real(), p.max_step = fields.real(), p.stray_limit = fields.real();
  const auto period = fields.integer<std::int64_t>();
  if (period < 0 || period > 1'000'000'000) fields.fail("a progress period like that makes no sense");
  p.progress_period = static_cast<int>(period);
  p.sensing_range = fields.real();
  if (fields.optional("links")) head.links = read_links(fields, p);
  fields.done();
  require(fields, [&] { require_sound(p); });
  head.following = p;
}

kinematics::Joint::Kind read_kind(RunFields& fields) {
  using Kind = kinematics::Joint::Kind;
  const std::string kind = fields.one_of({"fixed", "prismatic", "revolute"});
  return kind == "fixed" ? Kind::fixed : kind == "prismatic" ? Kind::prismatic : Kind::revolute;
}

model::Capsule read_capsule(RunFields& fields) {
  fields.line("capsule");
  model::Capsule capsule;
  capsule.a = fields.vector(), capsule.b = fields.vector(), capsule.radius = fields.real();
  fields.done();
  return capsule;
}

kinematics::Link read_link(RunFields& fields, std::size_t links_before) {
  fields.line("link");
  kinematics::Link link;
  link.name = fields.word();
  if (!fields.optional("-")) link.parent = fields.index(links_before, "link before it");
  link.joint.kind = read_kind(fields);
  link.joint.axis = fields.vector();
  link.joint.low = fields.any_real(), link.joint.high = fields.any_real();
  for (int row = 0; row < 3; ++row) {
    link.mounting.linear().row(row) = fields.vector();
    link.mounting.translation()[row] = fields.real();
  }
  const std::size_t parts = fields.count();
  fields.done();
  while (link.body.size() < parts) link.body.push_back(read_capsule(fields));
  return link;
}

/// A range sensor or a switch.
template <class Mounted>
Mounted read_mounted(RunFields& fields, std::string_view word, std::size_t links) {
  fields.line(word);
  Mounted sensor;
  sensor.link = fields.index(links, "link");
  sensor.position = fields.vector(), sensor.axis = fields.vector(), sensor.range = fields.real();
  fields.done();
  return sensor;
}

/// A robot without switches has no line of them. Then comes that of the ceilings.
void read_switches(RunFields& fields, kinematics::Robot& robot) {
  if (!fields.next()) fields.fail("expected 'switches' or 'ceilings', and the file ends here");
  if (fields.optional("ceilings")) return;
  if (!fields.optional("switches"))
    fields.fail("expected 'switches' or 'ceilings', found " + io::in_quotes(fields.word()));
  const std::size_t switches = fields.count();
  if (switches == 0) fields.fail("a robot without switches has no such line");
  fields.done();
  while (robot.switches.size() < switches)
    robot.switches.push_back(read_mounted<kinematics::ProximitySwitch>(fields, "switch", robot.links.size()));
  fields.line("ceilings");
}

kinematics::Robot read_robot(RunFields& fields) {
  kinematics::Robot robot;
  fields.line("robot");
  robot.name = fields.word();
  const std::size_t links = fields.count();
  fields.done();
  while (robot.links.size() < links) robot.links.push_back(read_link(fields, robot.links.size()));
  fields.line("control_point");
  robot.control_point.link = fields.index(links, "link");
  robot.control_point.position = fields.vector();
  fields.done();
  fields.line("sensors");
  const std::size_t sensors = fields.count();
  fields.done();
  while (robot.sensors.size() < sensors)
    robot.sensors.push_back(read_mounted<kinematics::RangeSensor>(fields, "sensor", links));
  read_switches(fields, robot);
  robot.ceilings.prismatic = fields.any_real(), robot.ceilings.revolute_rad = fields.any_real();
  fields.done();
  require(fields, [&] { require_sound(robot); });
  return robot;
}

std::size_t count_line(RunFields& fields, std::string_view word) {
  fields.line(word);
  const std::size_t count = fields.count();
  fields.done();
  return count;
}

std::vector<model::InitialFace> read_initial(RunFields& fields) {
  std::vector<model::InitialFace> faces;
  for (std::size_t left = count_line(fields, "initial"); left > 0; --left) {
    auto& cycles = faces.emplace_back().cycles;
    for (std::size_t more = count_line(fields, "face"); more > 0; --more) {
      auto& cycle = cycles.emplace_back();
      for (std::size_t corners = count_line(fields, "cycle"); corners > 0; --corners) {
        fields.line("vertex");
        cycle.push_back(fields.vector());
        fields.done();
      }
    }
  }
  return faces;
}

}  // namespace

RunHead read_head(RunFields& fields) {
  RunHead head;
  read_version(fields);
  fields.line("arithmetic");
  head.arithmetic = fields.one_of({"exact", "float-grid", "float"});
  fields.done();
  fields.line("seed");
  head.seed = fields.integer<std::uint64_t>();
  fields.done();
  head.model = read_model(fields);
  head.strategy = read_strategy(fields);
  read_following(fields, head);
  head.robot = read_robot(fields);
  head.initial = read_initial(fields);
  require(fields, [&] { model_before(head); });
  return head;
}

}  // namespace limpet::app::internal
