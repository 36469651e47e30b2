// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "builds.hpp"

namespace limpet::benchmarks {

/// A scan that all builds model, with the options that go with it.
struct RunScan {
  std::string name;
  std::string source;                ///< simulated or real
  std::string regime;                ///< grid (as it is), free (turned), far (moved away)
  std::string path;                  ///< of the scan
  std::string truth{};               ///< a mesh; empty: none is known
  double resolution = 0, noise = 0;  ///< scan's unit; 0: chosen from the scan
  std::string viewpoint{};           ///< "x,y,z"; empty: the scan has axes, or none is known
  bool counted = false;              ///< small: its instructions are to be counted by simulation too

  std::vector<std::string> arguments() const;
};

/// Makes the simulated scans in options.scratch: all shapes, orders and amounts of noise, in each regime.
std::vector<RunScan> simulated_scans(const PredicatesOptions&);

/// Scans of options.data that are there, in each regime.
std::vector<RunScan> real_scans(const PredicatesOptions&);

/// Small ones, for counting instructions where the processor cannot.
std::vector<RunScan> small_scans(const PredicatesOptions&);

}  // namespace limpet::benchmarks
