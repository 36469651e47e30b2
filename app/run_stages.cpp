// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/run_stages.hpp>

#include <filesystem>
#include <limpet/app/arguments.hpp>
#include <limpet/app/run_reader.hpp>
#include <limpet/drawing/robot_figure.hpp>
#include <limpet/io/text.hpp>
#include <limpet/kinematics/posture.hpp>
#include <set>
#include <utility>

namespace limpet::app {
namespace {

/// After how many sets there is a stage; of a whole run the last one is after all.
std::set<std::int64_t> stages_of(const std::string& path, std::int64_t sets, const RunStages& options) {
  if (options.at) {
    if (*options.at > sets)
      throw UsageError("--at " + std::to_string(*options.at) + ": " + path + " has " + io::grouped(sets) +
                       " sets");
    return {*options.at};
  }
  std::set<std::int64_t> stops;
  for (std::int64_t i = 1; i <= options.count; ++i) stops.insert(sets * i / options.count);
  return stops;
}

/// None: it has no links to be seen.
std::optional<drawing::RobotFigure> robot_at(const RunHead& head, const simulation::Sensed& sensed) {
  const kinematics::Posture posture(head.robot, sensed.measured);
  drawing::RobotFigure figure = drawing::robot_figure(posture, sensed, 2 * head.model.resolution);
  if (!figure.has_body()) return std::nullopt;
  return figure;
}

}  // namespace

std::vector<drawing::Figure> run_stages(const std::string& path, const RunStages& options) {
  const std::int64_t whole = count_sets(path);
  const std::set<std::int64_t> stops = stages_of(path, whole, options);
  RunReader reader(path);
  model::Model model = model_before(reader.head());
  const std::string name = std::filesystem::path(path).stem().string();
  std::vector<drawing::Figure> figures;
  std::vector<Eigen::Vector3d> way;
  std::optional<drawing::RobotFigure> robot;
  std::int64_t sets = 0;
  for (RunSet set; reader.next(set);) {
    model.update(set.sensed.points);
    way.push_back(set.control_point);
    ++sets;
    if (stops.count(sets) == 0) continue;
    if (options.with_robot) robot = robot_at(reader.head(), set.sensed);
    if (options.at)
      return {{model.record(), name + ": after " + io::grouped(sets) + " sets", {}, way, robot}};
    if (sets < whole) figures.push_back({model.record(), io::grouped(sets) + " sets", {}, way, robot});
  }
  model.finish();
  if (!reader.is_whole()) warn_of_run(path, "the run was cut short: it ends without its end");
  const std::string ended = name + ": " + reader.end().reason + ", " + io::grouped(sets) + " sets";
  figures.push_back({model.record(), ended, {}, way, robot});
  return figures;
}

}  // namespace limpet::app
