// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/simulation/scan.hpp>
#include <limpet/simulation/scene.hpp>
#include <ostream>
#include <string>
#include <vector>

namespace limpet::testing {

/// What a scan is made with.
struct SimulatedScan {
  std::string shape;
  std::int64_t points;
  simulation::ScanOptions::Order order;
  double noise, outliers;

  std::vector<simulation::LabelledPoint> make() const {
    const auto scene = simulation::make_scene(shape);
    simulation::ScanOptions options;
    options.points = points;
    options.order = order;
    options.noise = noise;
    options.outliers = outliers;
    options.viewpoints = scene.viewpoints;
    return simulation::scan(scene.mesh, options);
  }
};

// NOLINTNEXTLINE(readability-identifier-naming): a name of GoogleTest
inline void PrintTo(const SimulatedScan& s, std::ostream* out) {
  *out << s.shape << ", " << s.points << " points, order " << static_cast<int>(s.order) << ", noise "
       << s.noise << ", outliers " << s.outliers;
}

}  // namespace limpet::testing
