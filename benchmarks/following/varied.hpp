// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sections.hpp"

namespace limpet::benchmarks {

/// A row of a table of runs that differ in one thing: what is changed of every scene.
struct Variation {
  std::string what, value;  ///< what is varied, and to what
  std::string why_not;      ///< the relation that forbids it; empty: it is measured
  std::function<void(SceneText&)> change;
};

/// The runs of each row over all worlds and seeds, and the table: what | value | ended | sets | … The sets
/// are also told as a multiple of those of the first row.
Measured measure_varied(const RunPlan&, const VariedOptions&, const std::vector<Variation>&,
                        const std::string& title);

}  // namespace limpet::benchmarks
