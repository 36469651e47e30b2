// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/run_stages.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limpet/app/run_reader.hpp>
#include <limpet/io/text.hpp>

namespace limpet::app {
namespace {

drawing::Figure figure_of(const model::Model& model, const std::string& caption,
                          const std::vector<Eigen::Vector3d>& path) {
  return {model.record(), caption, {}, path};
}

}  // namespace

std::vector<drawing::Figure> run_stages(const std::string& path, int count, bool quiet) {
  const std::int64_t all = count_sets(path);
  RunReader reader(path);
  model::Model model = model_before(reader.head());
  std::vector<drawing::Figure> figures;
  std::vector<Eigen::Vector3d> way;
  std::int64_t sets = 0;
  for (RunSet set; reader.next(set);) {
    model.update(set.sensed.points);
    way.push_back(set.control_point);
    ++sets;
    const auto stage = static_cast<std::int64_t>(figures.size()) + 1;
    if (stage < count && sets == std::max<std::int64_t>(1, all * stage / count))
      figures.push_back(figure_of(model, io::grouped(sets) + " sets", way));
  }
  model.finish();
  if (!reader.is_whole() && !quiet)
    std::fprintf(stderr, "limpet: warning: %s: the run was cut short: it ends without its end\n",
                 path.c_str());
  const std::string name = std::filesystem::path(path).stem().string();
  figures.push_back(
      figure_of(model, name + ": " + reader.end().reason + ", " + io::grouped(sets) + " sets", way));
  return figures;
}

}  // namespace limpet::app
