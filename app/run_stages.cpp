// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/run_stages.hpp>

#include <filesystem>
#include <limpet/app/run_reader.hpp>
#include <limpet/io/text.hpp>
#include <set>

namespace limpet::app {
namespace {

drawing::Figure figure_of(const model::Model& model, const std::string& caption,
                          const std::vector<Eigen::Vector3d>& path) {
  return {model.record(), caption, {}, path};
}

/// After how many sets there is a stage, but for the last one.
std::set<std::int64_t> stages_of(std::int64_t sets, int count) {
  std::set<std::int64_t> stops;
  for (std::int64_t i = 1; i < count; ++i) stops.insert(sets * i / count);
  return stops;
}

}  // namespace

std::vector<drawing::Figure> run_stages(const std::string& path, int count) {
  const std::set<std::int64_t> stops = stages_of(count_sets(path), count);
  RunReader reader(path);
  model::Model model = model_before(reader.head());
  std::vector<drawing::Figure> figures;
  std::vector<Eigen::Vector3d> way;
  std::int64_t sets = 0;
  for (RunSet set; reader.next(set);) {
    model.update(set.sensed.points);
    way.push_back(set.control_point);
    ++sets;
    if (stops.count(sets) > 0) figures.push_back(figure_of(model, io::grouped(sets) + " sets", way));
  }
  model.finish();
  if (!reader.is_whole()) warn_of_run(path, "the run was cut short: it ends without its end");
  const std::string name = std::filesystem::path(path).stem().string();
  figures.push_back(
      figure_of(model, name + ": " + reader.end().reason + ", " + io::grouped(sets) + " sets", way));
  return figures;
}

}  // namespace limpet::app
