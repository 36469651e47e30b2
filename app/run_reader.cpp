// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/run_reader.hpp>

#include <algorithm>
#include <initializer_list>
#include <limpet/io/text.hpp>
#include <stdexcept>

#include "run_fields_internal.hpp"

namespace limpet::app {
namespace {

using Eigen::Vector3d;
using internal::RunFields;

/// Runs `check` and says what it finds with the line.
template <class Check>
void require(RunFields& fields, const Check& check) {
  try {
    check();
  } catch (const std::invalid_argument& error) {
    fields.fail(error.what());
  }
}

/// The next field, which is one of these words.
std::string one_of(RunFields& fields, std::initializer_list<std::string_view> words) {
  const std::string_view found = fields.word();
  std::string known;
  for (const std::string_view word : words) {
    if (found == word) return std::string(word);
    known += (known.empty() ? "" : ", ") + std::string(word);
  }
  fields.fail(io::in_quotes(found) + " is none of " + known);
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
  fields.done();
  fields.line("neighbours");
  p.neighbours = one_of(fields, {"yes", "no"}) == "yes";
  fields.done();
  fields.line("rules");
  require(fields, [&] { p.rules = model::Rules::parse(fields.word()); });
  fields.done();
  require(fields, [&] { const model::Model model(p); });
  return p;
}

following::Strategy read_strategy(RunFields& fields) {
  fields.line("strategy");
  const bool thesis = one_of(fields, {"frontier", "thesis"}) == "thesis";
  fields.done();
  return thesis ? following::Strategy::thesis : following::Strategy::frontier;
}

following::Parameters read_following(RunFields& fields) {
  following::Parameters p;
  fields.line("follow");
  p.resolution = fields.real(), p.angle_rad = fields.real();
  p.follow_distance = fields.real(), p.max_step = fields.real(), p.stray_limit = fields.real();
  const auto period = fields.integer<std::int64_t>();
  if (period < 0 || period > 1'000'000'000) fields.fail("a progress period like that makes no sense");
  p.progress_period = static_cast<int>(period);
  p.sensing_range = fields.real();
  fields.done();
  require(fields, [&] { require_sound(p); });
  return p;
}

kinematics::Joint::Kind read_kind(RunFields& fields) {
  using Kind = kinematics::Joint::Kind;
  const std::string kind = one_of(fields, {"fixed", "prismatic", "revolute"});
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

kinematics::RangeSensor read_sensor(RunFields& fields, std::size_t links) {
  fields.line("sensor");
  kinematics::RangeSensor sensor;
  sensor.link = fields.index(links, "link");
  sensor.position = fields.vector(), sensor.axis = fields.vector(), sensor.range = fields.real();
  fields.done();
  return sensor;
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
  while (robot.sensors.size() < sensors) robot.sensors.push_back(read_sensor(fields, links));
  fields.line("ceilings");
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

RunHead read_head(RunFields& fields) {
  RunHead head;
  read_version(fields);
  fields.line("arithmetic");
  head.arithmetic = one_of(fields, {"exact", "float-grid", "float"});
  fields.done();
  fields.line("seed");
  head.seed = fields.integer<std::uint64_t>();
  fields.done();
  head.model = read_model(fields);
  head.strategy = read_strategy(fields);
  head.following = read_following(fields);
  head.robot = read_robot(fields);
  head.initial = read_initial(fields);
  require(fields, [&] { model_before(head); });
  return head;
}

std::optional<following::Mode> read_mode(RunFields& fields) {
  if (fields.optional("-")) return std::nullopt;
  const std::string token(fields.word());
  for (std::size_t i = 0; i < following::kModeCount; ++i) {
    std::string name(following::name_of(static_cast<following::Mode>(i)));
    std::replace(name.begin(), name.end(), ' ', '_');
    if (name == token) return static_cast<following::Mode>(i);
  }
  fields.fail("there is no motion mode " + io::in_quotes(token));
}

void read_set(RunFields& fields, const kinematics::Robot& robot, RunSet& set) {
  set.mode = read_mode(fields);
  set.sensed.measured.resize(static_cast<Eigen::Index>(robot.joint_count()));
  for (double& position : set.sensed.measured) position = fields.real();
  set.control_point = fields.vector();
  const kinematics::Posture posture(robot, set.sensed.measured);
  set.sensed.points.clear(), set.sensed.sensors.clear();
  for (std::size_t left = fields.count(); left > 0; --left) {
    const std::size_t sensor = fields.index(robot.sensors.size(), "sensor");
    set.sensed.sensors.push_back(sensor);
    set.sensed.points.push_back(posture.sensor_point(sensor, fields.real()));
    if (fields.optional("at")) set.sensed.points.back().position = fields.vector();
  }
  fields.done();
}

template <class Id>
void read_ids(RunFields& fields, std::vector<Id>& ids) {
  for (std::size_t left = fields.count(); left > 0; --left) ids.push_back({fields.integer<std::uint64_t>()});
  fields.done();
}

}  // namespace

struct RunReader::State {
  explicit State(const std::string& path) : fields(path) {}

  /// What follows the sets. False when the file is cut short there.
  bool read_end(RunEnd& end) {
    read_ids(fields, end.marks.unreachable_segments);
    if (!fields.line_if_any("unreachable_edges")) return false;
    read_ids(fields, end.marks.unreachable_edges);
    if (!fields.line_if_any("unclosable_edges")) return false;
    read_ids(fields, end.marks.unclosable_edges);
    if (!fields.line_if_any("end")) return false;
    end.reason = one_of(fields, {"complete", "max-sets", "interrupted", "stopped"});
    const std::size_t promised = fields.count();
    if (promised != sets)
      fields.fail("the run had " + std::to_string(promised) + " sets, and there are " + std::to_string(sets));
    if (!fields.optional("-") && fields.integer<std::uint64_t>() != fields.digest())
      fields.fail("the lines before are not as they were written");
    fields.done();
    fields.nothing_more();
    return true;
  }

  RunFields fields;
  std::size_t sets = 0;
  bool over = false;
};

RunReader::RunReader(const std::string& path)
    : state_(std::make_unique<State>(path)), head_(read_head(state_->fields)) {
  end_.reason = "interrupted";
}

RunReader::~RunReader() = default;

bool RunReader::next(RunSet& set) {
  RunFields& fields = state_->fields;
  if (state_->over) return false;
  state_->over = !fields.next();
  if (state_->over) return false;
  if (fields.optional("set")) {
    read_set(fields, head_.robot, set);
    ++state_->sets;
    return true;
  }
  if (!fields.optional("unreachable_segments"))
    fields.fail("expected 'set' or 'unreachable_segments', found " + io::in_quotes(fields.word()));
  whole_ = state_->read_end(end_);
  state_->over = true;
  return false;
}

bool is_run(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string start(kRunMagic.size(), '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == kRunMagic;
}

std::int64_t count_sets(const std::string& path) {
  RunReader reader(path);
  std::int64_t sets = 0;
  for (RunSet set; reader.next(set);) ++sets;
  return sets;
}

}  // namespace limpet::app
