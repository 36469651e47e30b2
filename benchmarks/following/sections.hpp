// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>
#include <vector>

#include "../table.hpp"
#include "run_pool.hpp"

/// What is measured of following. Each section makes its runs and returns tables of them; progress is told on
/// standard error.
namespace limpet::benchmarks {

struct Measured {
  struct Titled {
    std::string title;
    Table table;
  };
  std::vector<Titled> tables;
  std::vector<MadeRun> runs;  ///< that the tables are made from
};

// ---- Named shapes, from random starts (worlds.cpp) -------------------------------------------------

struct WorldOptions {
  std::vector<std::string> worlds{"cube", "box", "L", "step", "notch", "cross", "icosahedron", "octahedron"};
  std::vector<double> noise{0, 0.002};
  std::vector<double> ceilings{1};  ///< γ, in λ
};
Measured measure_worlds(const RunPlan&, const WorldOptions&);

// ---- Range images from one side, beside thesis Table 1 (table1.cpp) ---------------------------------

struct Table1Options {
  std::vector<std::string> robots{"point"};  ///< point, arm
  std::vector<std::string> strategies{"frontier", "thesis"};
  std::vector<std::string> avoidance{"programme"};  ///< of arms: programme, thesis
  bool curved = true;     ///< a cylinder on a block and a sphere, too; of the point robot
  double pitch = 0.0118;  ///< of the range images; that of the thesis's Cube
};
Measured measure_table1(const RunPlan&, const Table1Options&);

// ---- Mesh files (parts.cpp) --------------------------------------------------------------------------

/// The plan's resolution of 0: chosen by the object, as `limpet follow` does.
Measured measure_parts(const RunPlan&, const std::vector<std::string>& files);

// ---- One parameter after the other (sensitivity.cpp) -------------------------------------------------

struct VariedOptions {
  std::vector<std::string> worlds{"cube", "L", "step"};
  std::vector<std::string> only;  ///< names of rows; empty: all
};
/// Each parameter at ½ to twice its usual value, where its relations to others allow that.
Measured measure_sensitivity(const RunPlan&, const VariedOptions&);

// ---- Poor sensors (faults.cpp) -----------------------------------------------------------------------

Measured measure_faults(const RunPlan&, const VariedOptions&);

// ---- Memory of a run that goes on and on (memory.cpp) -------------------------------------------------

struct MemoryOptions {
  std::vector<std::string> worlds{"cube"};
  std::int64_t sets = 100'000, every = 10'000;
};
Measured measure_memory(const RunPlan&, const MemoryOptions&);
Json answer_memory(const Json& request);

}  // namespace limpet::benchmarks
