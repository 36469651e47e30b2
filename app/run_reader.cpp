// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/run_reader.hpp>

#include <algorithm>
#include <cstdio>
#include <limpet/io/text.hpp>

#include "run_fields_internal.hpp"
#include "run_head_internal.hpp"

namespace limpet::app {
namespace {

using internal::RunFields;

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

/// The switches that see something; of a robot without switches nothing is there.
void read_seeing(RunFields& fields, std::size_t switches, std::vector<std::size_t>& seeing) {
  seeing.clear();
  if (switches == 0) return;
  if (!fields.optional("seeing")) fields.fail("expected 'seeing' and which switches see something");
  for (std::size_t left = fields.count(); left > 0; --left) {
    const std::size_t i = fields.index(switches, "switch");
    if (!seeing.empty() && i <= seeing.back()) fields.fail("the switches that see something must ascend");
    seeing.push_back(i);
  }
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
  read_seeing(fields, robot.switches.size(), set.sensed.seeing);
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
    end.reason = fields.one_of({"complete", "max-sets", "interrupted", "stopped", "collision"});
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
    : state_(std::make_unique<State>(path)), head_(internal::read_head(state_->fields)) {
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

void warn_of_run(const std::string& path, const std::string& what) {
  std::fprintf(stderr, "limpet: warning: %s: %s\n", path.c_str(), what.c_str());
}

}  // namespace limpet::app
