// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "../process.hpp"

namespace limpet::benchmarks {

/// A scene file (docs/scenes.md) that is being put together: what is set later replaces what was there.
class SceneText {
 public:
  SceneText& set(const std::string& section, const std::string& key, double value);
  /// The value as TOML has it; a text in quotes. The section of seed, strategy and the like is "".
  SceneText& set_text(const std::string& section, const std::string& key, const std::string& value);

  std::string toml() const;

 private:
  std::map<std::string, std::map<std::string, std::string>> sections_;
};

/// The text as a TOML value, in quotes.
std::string quoted(const std::string& text);

/// One run to be measured: plain data, so that it can be told to a process of its own.
struct RunCase {
  std::string name;   ///< what it is counted under
  std::string scene;  ///< a scene file's text; as a file, `limpet follow` makes the same run of it
  std::uint64_t seed = 1;
  double max_seconds = 600;       ///< the run is stopped beyond that, and judged as it is
  bool tour = false;              ///< compare with an offline tour
  std::int64_t oracle_every = 0;  ///< sets; 0: only the finished model
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunCase, name, scene, seed, max_seconds, tour, oracle_every)

/// How the runs of a section are made: what they have in common.
struct RunPlan {
  std::string strategy = "frontier";
  std::uint64_t first_seed = 1;
  int starts = 3;
  double noise = 0.002;  ///< standard deviation of a reading
  double resolution = 0.05;
  std::int64_t max_sets = 60'000;
  double max_seconds = 600;
  std::int64_t oracle_every = 0;
  bool tour = false;
  int workers = 1;
};

/// A scene of the plan: a shape, or a mesh file, felt from a random start with a random heading.
SceneText scene_of(const RunPlan&, const std::string& shape_or_mesh);
/// The scene once for each seed of the plan.
void add_runs(const RunPlan&, const std::string& name, const SceneText&, std::vector<RunCase>&);

/// "seeds 1 to 20".
std::string seeds_text(const RunPlan&);

}  // namespace limpet::benchmarks
