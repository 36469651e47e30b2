// Copyright the limpet authors. GPL-3.0-or-later.
//
// Recorded runs: exact, readable when cut short, and never taken for what they are not.
#include <cmath>
#include <csignal>
#include <limits>
#include <limpet/app/run_reader.hpp>
#include <limpet/app/run_record.hpp>
#include <limpet/io/error.hpp>
#include <limpet/survey/random.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program.hpp"

namespace limpet::app {
namespace {

class RunFile : public testing::ProgramTest {
 protected:
  /// A short run; its name.
  std::string record(const std::string& scene, long sets, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"follow",
                                       scene,
                                       "-q",
                                       "-o",
                                       path("m.limpet"),
                                       "--record",
                                       path("r.run"),
                                       "--max-sets",
                                       std::to_string(sets),
                                       "--json",
                                       path("m.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto result = run(arguments);
    EXPECT_LE(result.code, 1) << result.err;
    return path("r.run");
  }
  testing::Result replay(const std::string& file, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"follow", "--replay", file, "-q", "-o", path("again.limpet")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  /// Starts a run of a second or more, and ends it by a signal once a set is recorded.
  testing::Result end_by(int signal) const {
    const pid_t child =
        start({"follow", "step_hole", "-q", "-o", path("m.limpet"), "--record", path("r.run")});
    for (int i = 0; i < 10'000 && read(path("r.run")).find("\nset ") == std::string::npos; ++i)
      ::usleep(1000);
    ::kill(child, signal);
    return finish(child);
  }
  void expect_same_model() const {
    const std::string model = read(path("m.limpet"));
    EXPECT_FALSE(model.empty());
    EXPECT_EQ(read(path("again.limpet")), model);
  }
};

constexpr const char* kTriangle = "OFF\n3 1 0\n5 5 5\n6 5 5\n5 6 5\n3 0 1 2\n";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& parts, char by) {
  std::string text;
  for (const std::string& part : parts) text += part + by;
  return text;
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; stream >> field;) fields.push_back(field);
  return fields;
}

/// What reading the run says; empty when nothing is wrong.
std::string complaint(const std::string& path) {
  try {
    count_sets(path);
    return "";
  } catch (const io::InputError& error) {
    return error.what();
  }
}

TEST(RunNumbers, AreExact) {
  for (const double x : {0.0, -0.0, 1.0, -0.1, 1e300, 5e-324, -2.2250738585072014e-308,
                         std::numeric_limits<double>::infinity()}) {
    const std::string text = hexadecimal(x);
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), x) << text;
    EXPECT_EQ(std::signbit(std::strtod(text.c_str(), nullptr)), std::signbit(x)) << text;
  }
  EXPECT_EQ(hexadecimal(-0.375), "-0x1.8p-2");
}

/// An arm of two links with bodies, limits and ceilings, that senses with both.
kinematics::Robot small_arm() {
  kinematics::Robot robot = kinematics::point_robot({0.3, 0.04, Eigen::Quaterniond(0.5, 0.1, -0.7, 0.2)});
  robot.name = "a small arm";
  for (int i = 0; i < 2; ++i) {
    kinematics::Link link;
    link.name = i == 0 ? "" : "fore arm";
    link.parent = robot.links.size() - 1;
    link.mounting.translate(Eigen::Vector3d(0.1, -0.2, 0.3))
        .rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY()));
    link.joint = {kinematics::Joint::Kind::revolute, Eigen::Vector3d::UnitZ(), -1.5, 2.5};
    link.body.push_back({Eigen::Vector3d::Zero(), Eigen::Vector3d(0, 0, 0.4), 0.05});
    robot.links.push_back(link);
    robot.sensors.push_back(
        {robot.links.size() - 1, Eigen::Vector3d(0, 0, 0.4), Eigen::Vector3d::UnitX(), 0.25});
  }
  robot.control_point = {robot.links.size() - 1, Eigen::Vector3d(0, 0, 0.4)};
  robot.ceilings.revolute_rad = 0.066;
  require_sound(robot);
  return robot;
}

/// With an objective other than the usual one.
following::LinkParameters some_links() {
  auto links = following::usual_link_parameters({}, following::Redundancy::thesis);
  links.objective = {1234.5, 3, 0.125};
  return links;
}

void write_arm_run(const std::string& path, const kinematics::Robot& robot = small_arm()) {
  RunHead head{"exact", following::Strategy::thesis, ~std::uint64_t{0}, {}, {}, some_links(), robot, {}};
  head.model.rules = model::Rules::thesis();
  head.model.neighbours = false;
  head.model.noise_per_range2 = 1e-5;
  head.initial = {
      {{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}}}}};
  RunRecord record(path, head);
  survey::Random random(7);
  for (int i = 0; i < 5; ++i) {
    RunSet set;
    if (i < 4) set.mode = following::Mode::current_edge;
    set.sensed.measured = kinematics::Configuration::Zero(5);
    for (double& position : set.sensed.measured) position = random.normal();
    const kinematics::Posture posture(head.robot, set.sensed.measured);
    set.control_point = posture.control_point();
    for (std::size_t sensor = 0; sensor < head.robot.sensors.size(); sensor += 3) {
      set.sensed.sensors.push_back(sensor);
      set.sensed.points.push_back(posture.sensor_point(sensor, 0.2 * random.uniform()));
      if (sensor % 2 == 1) set.sensed.points.back().position.x() += 0.01;
    }
    for (std::size_t k = 0; k < head.robot.switches.size(); ++k)
      if (random.below(2) == 0) set.sensed.seeing.push_back(k);
    record.add(set);
  }
  record.end({"stopped", {{{3}, {9}}, {{12}}, {}}});
}

/// The same with its links covered with switches, of which five are at one place.
kinematics::Robot small_switched_arm() {
  kinematics::Robot robot = kinematics::with_switches(small_arm());
  for (std::size_t i = 0; i < 5; ++i)
    robot.switches.push_back({i, Eigen::Vector3d(0.1, -0.25, 0.3), Eigen::Vector3d::UnitY(), 0.125});
  return robot;
}

TEST_F(RunFile, KeepsSwitchesAndWhichOfThemSeeSomething) {
  write_arm_run(path("arm.run"), small_switched_arm());
  RunReader reader(path("arm.run"));
  const auto &was = small_switched_arm().switches, &is = reader.head().robot.switches;
  ASSERT_EQ(is.size(), was.size());
  for (std::size_t i = 0; i < was.size(); ++i) {
    EXPECT_EQ(is[i].link, was[i].link);
    EXPECT_EQ(is[i].position, was[i].position);
    EXPECT_EQ(is[i].axis, was[i].axis);
    EXPECT_EQ(is[i].range, was[i].range);
  }
  RunRecord again(path("again.run"), reader.head());
  std::size_t seeing = 0;
  for (RunSet set; reader.next(set); again.add(set)) seeing += set.sensed.seeing.size();
  again.end(reader.end());
  EXPECT_GT(seeing, 0u);
  EXPECT_EQ(read(path("again.run")), read(path("arm.run")));
}

TEST_F(RunFile, WhatIsSaidOfSwitchesMustMakeSense) {
  write_arm_run(path("arm.run"), small_switched_arm());
  const std::string text = read(path("arm.run"));
  const auto expect_damaged = [&](const std::string& what, const std::string& instead) {
    std::string damaged = text;
    const std::size_t at = damaged.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    damaged.replace(at, what.size(), instead);
    const auto result = replay(write("d.run", damaged));
    expect_refused(result, "d.run: line ");
  };
  const std::string count = std::to_string(small_switched_arm().switches.size());
  expect_damaged("\nswitches " + count, "\nswitches 0");
  expect_damaged("\nswitches " + count, "\nswitches 99999999999");
  expect_damaged("\nswitches " + count + "\n", "\n");
  expect_damaged("\nswitches ", "\nlevers ");
  expect_damaged("\nswitch 4", "\nswitch 99");
  expect_damaged("\nswitch 4 0x", "\nswitch 4 inf 0x");
  expect_damaged(" seeing ", " ");
  expect_damaged(" seeing ", " seeing 2 1 1 ");
  expect_damaged(" seeing ", " seeing 1 77 ");
}

/// Any robot, whatever its joints: read, and written again, it is the same file.
TEST_F(RunFile, ReadAndWrittenAgainItIsTheSame) {
  write_arm_run(path("arm.run"));
  RunReader reader(path("arm.run"));
  RunRecord again(path("again.run"), reader.head());
  for (RunSet set; reader.next(set);) again.add(set);
  again.end(reader.end());
  const std::string text = read(path("arm.run"));
  EXPECT_EQ(read(path("again.run")), text);
  EXPECT_NE(text.find("\nlink fore_arm 4 revolute "), std::string::npos) << text;
  EXPECT_NE(text.find("\nset - "), std::string::npos);
  EXPECT_EQ(reader.end().marks.unreachable_edges.at(0).value, 12u);
  EXPECT_EQ(reader.head().robot.links.at(5).joint.high, 2.5);
  ASSERT_TRUE(reader.head().links);
  EXPECT_EQ(reader.head().links->redundancy, following::Redundancy::thesis);
  EXPECT_EQ(reader.head().links->objective.gain, 1234.5);
  EXPECT_EQ(reader.head().links->objective.exponent, 3);
  EXPECT_EQ(reader.head().links->objective.influence, 0.125);
  EXPECT_EQ(replay(path("arm.run")).code, 1);
}

TEST_F(RunFile, ReplayGivesTheSameModel) {
  struct Case {
    std::string scene;
    long sets;
    std::vector<std::string> more;
  };
  const std::string scenes = LIMPET_SOURCE_DIR "/scenes/";
  for (const Case& c :
       {Case{"octahedron", 10'000, {}}, Case{"cube", 200, {"--strategy", "thesis"}},
        Case{"cube", 60, {"--robot", "arm", "--link-sensors", "switches"}},
        Case{scenes + "noisy_L.toml", 150, {}}, Case{scenes + "L_from_one_side.toml", 150, {}}}) {
    SCOPED_TRACE(c.scene);
    const std::string file = record(c.scene, c.sets, c.more);
    const auto result = replay(file, {"--json", path("again.json"), "--check-every", "50"});
    expect_same_model();
    const auto was = nlohmann::json::parse(read(path("m.json"))),
               is = nlohmann::json::parse(read(path("again.json")));
    EXPECT_EQ(result.code, was["ended"] == "complete" ? 0 : 1) << result.err;
    for (const std::string key :
         {"sets", "readings", "ended", "closed", "polygons", "open_edges", "path_length", "unreachable",
          "unclosable", "modes", "violations", "resolution", "noise"})
      EXPECT_EQ(is[key], was[key]) << key;
    EXPECT_FALSE(is.contains("coverage")) << "the truth is not known";
    EXPECT_FALSE(is.contains("step_us_median")) << "nothing was decided";
  }
}

/// Points of a range image lie beside the axes.
TEST_F(RunFile, PointsBesideTheirAxesAreToldInFull) {
  const std::string text = read(record(LIMPET_SOURCE_DIR "/scenes/L_from_one_side.toml", 30));
  EXPECT_NE(text.find(" at "), std::string::npos);
  EXPECT_NE(text.find("\ninitial "), std::string::npos);
}

TEST_F(RunFile, HoldsWhatTheRobotSensed) {
  RunReader reader(record("cube", 40, {"--encoder-noise", "0.001", "--seed", "9"}));
  EXPECT_EQ(reader.head().seed, 9u);
  EXPECT_EQ(reader.head().robot.sensors.size(), 26u);
  EXPECT_EQ(reader.head().strategy, following::Strategy::frontier);
  RunSet set;
  int sets = 0;
  for (; reader.next(set); ++sets) {
    EXPECT_TRUE(set.mode);
    const kinematics::Posture posture(reader.head().robot, set.sensed.measured);
    EXPECT_GT((posture.control_point() - set.control_point).norm(), 0);
    EXPECT_LT((posture.control_point() - set.control_point).norm(), 0.01);
    for (std::size_t i = 0; i < set.sensed.points.size(); ++i) {
      const auto& point = set.sensed.points[i];
      EXPECT_EQ(point.position, posture.sensor_point(set.sensed.sensors[i], point.range).position);
    }
  }
  EXPECT_EQ(sets, 40);
  EXPECT_TRUE(reader.is_whole());
  EXPECT_EQ(reader.end().reason, "max-sets");
}

TEST_F(RunFile, AnInterruptedRunIsReplayedAsFarAsItWent) {
  const std::string file = record("cube", 60);
  const auto lines = lines_of(read(file));
  std::string short_run;
  for (std::size_t i = 0, sets = 0; sets < 20; ++i) {
    short_run += lines[i] + "\n";
    sets += lines[i].starts_with("set ");
  }
  const auto result = replay(write("short.run", short_run + "set extend 0x1.8p"), {"--json", "-"});
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(result.error_lines(), 1);
  EXPECT_NE(result.err.find("cut short"), std::string::npos) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["sets"], 20);
  EXPECT_EQ(json["ended"], "interrupted");
  record("cube", 20);
  expect_same_model();
}

TEST_F(RunFile, AKilledRunLeavesItsSets) {
  EXPECT_EQ(end_by(SIGKILL).code, -SIGKILL);
  RunReader reader(path("r.run"));
  int sets = 0;
  for (RunSet set; reader.next(set);) ++sets;
  EXPECT_GE(sets, 1);
  EXPECT_FALSE(reader.is_whole());
}

TEST_F(RunFile, AStoppedRunIsWhole) {
  EXPECT_EQ(end_by(SIGINT).code, 1);
  RunReader reader(path("r.run"));
  for (RunSet set; reader.next(set);) EXPECT_TRUE(set.mode);
  EXPECT_TRUE(reader.is_whole());
  EXPECT_EQ(reader.end().reason, "interrupted");
  const auto result = replay(path("r.run"));
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(result.err, "");
  expect_same_model();
}

TEST_F(RunFile, CutAnywhereItIsDamagedOrShort) {
  const std::string text = read(record("cube", 4));
  const std::size_t head = text.find("\nset ") + 1;
  for (std::size_t size = 0; size < text.size(); size += 7) {
    const std::string file = write("cut.run", text.substr(0, size));
    const std::string said = complaint(file);
    if (size < head) {
      EXPECT_NE(said.find("line "), std::string::npos) << size << " " << said;
      continue;
    }
    EXPECT_EQ(said, "") << size;
    RunReader reader(file);
    for (RunSet set; reader.next(set);) EXPECT_FALSE(set.sensed.sensors.empty());
    EXPECT_FALSE(reader.is_whole());
  }
}

/// Whatever happens to one field, it is noticed: where it is no longer a field, on its line.
TEST_F(RunFile, DamageToAnyFieldIsNoticed) {
  const auto lines = lines_of(read(record("cube", 3, {"--initial", write("i.off", kTriangle)})));
  const auto expect_damaged = [&](const std::vector<std::string>& fields, std::size_t i, const char* how) {
    auto damaged = lines;
    damaged[i] = joined(fields, ' ');
    damaged[i].pop_back();
    const std::string said = complaint(write("d.run", joined(damaged, '\n')));
    EXPECT_NE(said.find("d.run: line "), std::string::npos) << how << ": " << damaged[i];
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto fields = fields_of(lines[i]);
    for (std::size_t k = 0; k < fields.size(); ++k) {
      auto other = fields;
      other[k] = "?";
      expect_damaged(other, i, "no number");
      other[k] = fields[k].ends_with('1') ? fields[k] + "0" : fields[k] + "1";
      expect_damaged(other, i, "another number");
      other[k] = "999999999999999999999";
      expect_damaged(other, i, "a number out of bounds");
      other.erase(other.begin() + static_cast<std::ptrdiff_t>(k));
      if (!other.empty()) expect_damaged(other, i, "a field less");
    }
    auto more = fields;
    more.push_back("0");
    expect_damaged(more, i, "a field more");
  }
}

/// The program says it in one line, for each line: damaged, left out, or there twice.
TEST_F(RunFile, DamageToAnyLineIsOneLineAndExitCodeTwo) {
  const auto lines = lines_of(read(record("cube", 2)));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    auto damaged = lines;
    damaged[i] += "\x01x";
    const std::string where = "line " + std::to_string(i + 1);
    expect_refused(replay(write("d.run", joined(damaged, '\n'))), i == 0 ? "line 1" : where);
    damaged = lines;
    damaged.erase(damaged.begin() + static_cast<std::ptrdiff_t>(i));
    if (i + 1 < lines.size()) {
      EXPECT_NE(complaint(write("d.run", joined(damaged, '\n'))), "") << lines[i];
    }
    damaged = lines;
    damaged.insert(damaged.begin() + static_cast<std::ptrdiff_t>(i), lines[i]);
    EXPECT_NE(complaint(write("d.run", joined(damaged, '\n'))), "") << lines[i];
  }
  EXPECT_FALSE(exists("again.limpet"));
}

TEST_F(RunFile, WithoutADigestItMayBeWrittenByHand) {
  auto lines = lines_of(read(record("cube", 5)));
  lines.back() = "end max-sets 5 -";
  EXPECT_EQ(replay(write("hand.run", joined(lines, '\n'))).code, 1);
  expect_same_model();
  lines.back() = "end max-sets 6 -";
  EXPECT_NE(complaint(write("hand.run", joined(lines, '\n'))).find("6 sets"), std::string::npos);
}

/// What has the form of a number, and makes no sense.
TEST_F(RunFile, ParametersThatMakeNoSenseAreRefusedWithTheirLine) {
  const auto lines = lines_of(read(record("cube", 3)));
  const auto expect_line = [&](const std::string& word, const std::string& instead) {
    auto damaged = lines;
    std::size_t i = 0;
    while (!damaged[i].starts_with(word + " ")) ++i;
    damaged[i] = word + " " + instead;
    const std::string said = complaint(write("d.run", joined(damaged, '\n')));
    const std::string where = "line " + std::to_string(i + 1) + ":";
    EXPECT_NE(said.find(where), std::string::npos) << damaged[i] << ": " << said;
  };
  expect_line("limpet run", "2");
  expect_line("redundancy", "-1 0.05");
  expect_line("rules", "limpet,luck");
  expect_line("strategy", "luck");
  expect_line("follow", "0.1 0.17 0.1 0.1 0.2 10 0.2");
  expect_line("follow", "0.05 0.17 0.1 0.1 0.2 1 0.2");
  expect_line("ceilings", "0 inf");
  expect_line("control_point", "9 0 0 0");
  expect_line("set", "flight 0 0 0 0 0 0 0");
  expect_line("set", "extend 0 0 0 0 0 0 1 26 0.1");
  expect_line("set", "extend 0 0 inf 0 0 0 0");
  expect_line("end", "done 3 -");
}

TEST_F(RunFile, ReplayTakesNothingThatTheRunSays) {
  const std::string file = record("cube", 3);
  expect_refused(run({"follow", "cube", "--replay", file, "-o", path("x.off")}), "SCENE");
  expect_refused(replay(file, {"--seed", "3"}), "--seed");
  expect_refused(replay(file, {"--record", path("s.run")}), "--record");
  expect_refused(replay(path("none.run")), "none.run");
  expect_refused(replay(path("")), "folder");
  expect_refused(replay(path("m.limpet")), "no recorded run");
}

}  // namespace
}  // namespace limpet::app
