// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <fstream>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <limpet/model/model.hpp>
#include <limpet/simulation/scan.hpp>
#include <limpet/simulation/scene.hpp>

/// Simulated scans: from a file that all contestants read, or made on the fly.
namespace limpet::benchmarks {

/// What is scanned and how; the same specification gives the same points.
struct CloudSpec {
  std::string shape = "cube";
  std::string order = "shuffled";  ///< or raster, or sampled (evenly over the surface; never held in memory)
  std::int64_t points = 100'000;   ///< wanted
  double noise_ratio = 0.002;      ///< standard deviation, as a fraction of the shape's size
  double outliers = 0;             ///< fraction
  std::uint64_t seed = 1;
  std::int64_t points_for_resolution = 0;  ///< λ is the one that suits so many points; 0: `points`
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CloudSpec, shape, order, points, noise_ratio, outliers, seed,
                                   points_for_resolution)

/// The scene of a specification, and the lengths that follow from it.
struct ScanCase {
  explicit ScanCase(const CloudSpec&);

  CloudSpec spec;
  simulation::Scene scene;
  std::vector<simulation::Face> faces;
  double noise = 0, resolution = 0;  ///< σ and λ, scan's unit
  double spacing = 0;                ///< a sphere of this radius holds about 15 points
  double smallest_face_points = 0;   ///< expected on the smallest face

  model::Parameters parameters() const;
  void scan(const std::function<void(const simulation::LabelledPoint&)>& take) const;
};

/// Writes the cloud to a file; the number of points.
std::int64_t write_cloud(const ScanCase&, const std::string& path);

/// Reads a cloud's file from begin to end, some points at a time. Throws std::runtime_error if it cannot.
class CloudReader {
 public:
  explicit CloudReader(const std::string& path);
  /// The next points, at most `most`; fewer at the end, then none. Valid until the next call.
  std::span<const simulation::LabelledPoint> next(std::size_t most);

 private:
  std::ifstream file_;
  std::vector<char> bytes_;
  std::vector<simulation::LabelledPoint> points_;
};

}  // namespace limpet::benchmarks
