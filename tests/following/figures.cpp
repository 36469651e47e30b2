// Copyright the limpet authors. GPL-3.0-or-later.
//
// Measures runs: `limpet_following_figures frontier|thesis WORLD[,WORLD…]|all STARTS NOISE [FIRST_SEED
// [MOST_SETS]]`; prints one line for each run and one for each world.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <sstream>

#include "simulated_run.hpp"

namespace {

using namespace limpet::following;

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

void print(const char* world, unsigned long long seed, const RunResult& r) {
  std::printf(
      "%-12s %4llu %-10s %6d sets %7.1f path %s %3lld polygons %3lld open  clearance %.4f (model %.4f)  "
      "marks %zu/%zu/%zu  us %.0f/%.0f/%.0f ",
      world, seed, std::string(name_of(r.end)).c_str(), r.sets, r.path, r.closed ? "closed" : "OPEN  ",
      static_cast<long long>(r.polygons), static_cast<long long>(r.open_edges), r.clearance,
      r.model_clearance, r.marks.unreachable_segments.size(), r.marks.unreachable_edges.size(),
      r.marks.unclosable_edges.size(), quantile(r.step_us, 0.5),
      std::accumulate(r.step_us.begin(), r.step_us.end(), 0.0) / static_cast<double>(r.step_us.size()),
      quantile(r.step_us, 1));
  for (const int n : r.sets_by_mode) std::printf(" %d", n);
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 5) return 2;
  const Strategy strategy = std::string(arguments[1]) == "thesis" ? Strategy::thesis : Strategy::frontier;
  ++arguments, --count;
  std::vector<std::string> worlds;
  std::stringstream list(arguments[1]);
  for (std::string name; std::getline(list, name, ',');) worlds.push_back(name);
  if (worlds.front() == "all") worlds = world_names();
  const int starts = std::atoi(arguments[2]);
  const unsigned long long first = count > 4 ? std::strtoull(arguments[4], nullptr, 10) : 1;
  for (const std::string& world : worlds) {
    const auto mesh = make_world_mesh(world);
    std::vector<double> sets, paths;
    int closed = 0, ended = 0;
    double clearance = 1;
    for (int i = 0; i < starts; ++i) {
      RunOptions options;
      options.strategy = strategy;
      options.noise = std::atof(arguments[3]);
      options.seed = first + static_cast<unsigned long long>(i);
      if (count > 5) options.most_sets = std::atoi(arguments[5]);
      const RunResult r = run_following(mesh, options);
      print(world.c_str(), options.seed, r);
      sets.push_back(r.sets), paths.push_back(r.path);
      closed += r.closed;
      ended += r.end != End::none;
      clearance = std::min(clearance, r.clearance);
    }
    std::printf(
        "= %-12s noise %s: closed %d of %d, ended %d, sets median %.0f (%.0f to %.0f), path median %.1f, "
        "clearance %.4f\n",
        world.c_str(), arguments[3], closed, starts, ended, quantile(sets, 0.5), quantile(sets, 0),
        quantile(sets, 1), quantile(paths, 0.5), clearance);
    std::fflush(stdout);
  }
}
