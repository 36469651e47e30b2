// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/run_record.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limpet/io/error.hpp>
#include <utility>

namespace limpet::app {
namespace {

using Eigen::Vector3d;

/// One line, field by field.
class Line {
 public:
  explicit Line(std::string_view word) : text_(word) {}
  Line& word(std::string_view word) {
    text_ += ' ';
    text_ += word;
    return *this;
  }
  /// A word that may hold blanks.
  Line& name(std::string_view name) {
    std::string word(name.empty() ? "-" : name);
    std::replace_if(
        word.begin(), word.end(), [](char c) { return static_cast<unsigned char>(c) <= ' '; }, '_');
    return this->word(word);
  }
  Line& real(double x) { return word(hexadecimal(x)); }
  Line& vector(const Vector3d& v) { return real(v.x()).real(v.y()).real(v.z()); }
  template <class Integer>
  Line& integer(Integer x) {
    return word(std::to_string(x));
  }
  std::string end() { return std::move(text_) + "\n"; }

 private:
  std::string text_;
};

std::string model_lines(const model::Parameters& p) {
  return Line("resolution").real(p.resolution).end() + Line("angle").real(p.angle_rad).end() +
         Line("noise").real(p.noise).real(p.noise_per_range).real(p.noise_per_range2).end() +
         Line("quantum").real(p.input_quantum).end() + Line("tolerance").real(p.tolerance).end() +
         Line("patience").integer(p.outlier_patience).end() +
         Line("redundancy").real(p.redundancy_count).real(p.redundancy_ratio).end() +
         Line("neighbours").word(p.neighbours ? "yes" : "no").end() +
         Line("rules").word(p.rules.to_string()).end();
}

std::string following_lines(const RunHead& head) {
  const following::Parameters& p = head.following;
  Line line("follow");
  line.real(p.resolution).real(p.angle_rad).real(p.follow_distance).real(p.max_step).real(p.stray_limit);
  line.integer(p.progress_period).real(p.sensing_range);
  if (head.links) {
    line.word("links").word(head.links->redundancy == following::Redundancy::thesis ? "thesis" : "programme");
    line.real(head.links->objective.gain).integer(head.links->objective.exponent);
    line.real(head.links->objective.influence);
  }
  const bool thesis = head.strategy == following::Strategy::thesis;
  return Line("strategy").word(thesis ? "thesis" : "frontier").end() + line.end();
}

std::string_view kind_of(const kinematics::Joint& joint) {
  using Kind = kinematics::Joint::Kind;
  return joint.kind == Kind::fixed ? "fixed" : joint.kind == Kind::prismatic ? "prismatic" : "revolute";
}

std::string link_lines(const kinematics::Link& link) {
  Line line("link");
  line.name(link.name).word(link.parent ? std::to_string(*link.parent) : "-");
  line.word(kind_of(link.joint)).vector(link.joint.axis).real(link.joint.low).real(link.joint.high);
  for (int row = 0; row < 3; ++row)
    line.vector(link.mounting.linear().row(row)).real(link.mounting.translation()[row]);
  std::string text = line.integer(link.body.size()).end();
  for (const model::Capsule& part : link.body)
    text += Line("capsule").vector(part.a).vector(part.b).real(part.radius).end();
  return text;
}

std::string robot_lines(const kinematics::Robot& robot) {
  std::string text = Line("robot").name(robot.name).integer(robot.links.size()).end();
  for (const kinematics::Link& link : robot.links) text += link_lines(link);
  const auto& point = robot.control_point;
  text += Line("control_point").integer(point.link).vector(point.position).end();
  text += Line("sensors").integer(robot.sensors.size()).end();
  for (const kinematics::RangeSensor& s : robot.sensors)
    text += Line("sensor").integer(s.link).vector(s.position).vector(s.axis).real(s.range).end();
  if (!robot.switches.empty()) text += Line("switches").integer(robot.switches.size()).end();
  for (const kinematics::ProximitySwitch& s : robot.switches)
    text += Line("switch").integer(s.link).vector(s.position).vector(s.axis).real(s.range).end();
  return text + Line("ceilings").real(robot.ceilings.prismatic).real(robot.ceilings.revolute_rad).end();
}

std::string initial_lines(const std::vector<model::InitialFace>& faces) {
  std::string text = Line("initial").integer(faces.size()).end();
  for (const model::InitialFace& face : faces) {
    text += Line("face").integer(face.cycles.size()).end();
    for (const auto& cycle : face.cycles) {
      text += Line("cycle").integer(cycle.size()).end();
      for (const Vector3d& v : cycle) text += Line("vertex").vector(v).end();
    }
  }
  return text;
}

std::string head_lines(const RunHead& head) {
  return std::string(kRunMagic) + std::string(kRunFormat) + "\n" +
         Line("arithmetic").word(head.arithmetic).end() + Line("seed").integer(head.seed).end() +
         model_lines(head.model) + following_lines(head) + robot_lines(head.robot) +
         initial_lines(head.initial);
}

std::string set_line(const RunSet& set, const kinematics::Robot& robot) {
  Line line("set");
  if (set.mode)
    line.name(following::name_of(*set.mode));
  else
    line.word("-");
  for (const double position : set.sensed.measured) line.real(position);
  line.vector(set.control_point).integer(set.sensed.points.size());
  const kinematics::Posture posture(robot, set.sensed.measured);
  for (std::size_t i = 0; i < set.sensed.points.size(); ++i) {
    const model::SensorPoint& point = set.sensed.points[i];
    const std::size_t sensor = set.sensed.sensors[i];
    line.integer(sensor).real(point.range);
    // The points of a range image are near an axis, not on it: these are told in full.
    if (posture.sensor_point(sensor, point.range).position != point.position)
      line.word("at").vector(point.position);
  }
  if (robot.switches.empty()) return line.end();
  line.word("seeing").integer(set.sensed.seeing.size());
  for (const std::size_t i : set.sensed.seeing) line.integer(i);
  return line.end();
}

template <class Id>
std::string ids_line(std::string_view word, const std::vector<Id>& ids) {
  Line line(word);
  line.integer(ids.size());
  for (const Id id : ids) line.integer(id.value);
  return line.end();
}

}  // namespace

RunRecord::RunRecord(std::string path, const RunHead& head) : path_(std::move(path)), head_(head) {}

void RunRecord::fail() const {
  throw io::OutputError(path_ + ": cannot be written: " + std::strerror(errno));
}

void RunRecord::begin() {
  file_.open(path_, std::ios::binary | std::ios::trunc);
  if (!file_) fail();
  put(head_lines(head_));
}

void RunRecord::put(const std::string& lines) {
  for (std::size_t i = 0; i < lines.size();) {
    const std::size_t end = lines.find('\n', i);
    digest_.add(std::string_view(lines).substr(i, end - i));
    i = end + 1;
  }
  file_ << lines << std::flush;
  if (!file_) fail();
}

void RunRecord::add(const RunSet& set) {
  if (!file_.is_open()) begin();
  put(set_line(set, head_.robot));
  ++sets_;
}

void RunRecord::end(const RunEnd& end) {
  if (!file_.is_open()) begin();
  put(ids_line("unreachable_segments", end.marks.unreachable_segments) +
      ids_line("unreachable_edges", end.marks.unreachable_edges) +
      ids_line("unclosable_edges", end.marks.unclosable_edges));
  file_ << Line("end").word(end.reason).integer(sets_).integer(digest_.value()).end();
  file_.close();
  if (!file_) fail();
}

}  // namespace limpet::app
