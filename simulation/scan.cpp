// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/scan.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limpet/simulation/raster.hpp>
#include <limpet/simulation/scene.hpp>
#include <limpet/simulation/surface_places.hpp>
#include <limpet/simulation/turning_scanner.hpp>
#include <limpet/survey/random.hpp>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;
using Order = ScanOptions::Order;
using Take = std::function<void(const LabelledPoint&)>;

/// The sensor's errors: noise along the axis, and outliers.
class Sensor {
 public:
  Sensor(const Mesh& mesh, const ScanOptions& options) : options_(options), random_(options.seed) {
    const Bounds bounds = bounds_of(mesh);
    const Vector3d size = bounds.high - bounds.low;
    const Vector3d grown = 0.1 * (size.array() > 0).select(size, bounds.diagonal());
    low_ = bounds.low - grown;
    high_ = bounds.high + grown;
  }

  LabelledPoint read(const Vector3d& position, const Vector3d& axis, double range, int face) {
    // The same numbers are drawn for every reading, so outliers do not change the noise of the others.
    const bool is_outlier = random_.uniform() < options_.outliers;
    const double error = (options_.noise + options_.noise_per_range * range) * random_.normal();
    if (!is_outlier) return {{position + error * axis, axis, range}, face};
    Vector3d anywhere;
    for (int k = 0; k < 3; ++k) anywhere[k] = random_.uniform(low_[k], high_[k]);
    return {{anywhere, axis, range}, -1};
  }

 private:
  const ScanOptions& options_;
  survey::Random random_;
  Vector3d low_, high_;
};

void sweep(const Mesh& mesh, const ScanPattern& pattern, const ScanOptions& options, const Take& take) {
  Sensor sensor(mesh, options);
  pattern.sweep(pattern.pitch_for(options.points), [&](const RayCaster::Hit& hit, const Vector3d& direction) {
    take(sensor.read(hit.position, direction, hit.range, hit.face));
  });
}

void scan_from_viewpoints(const Mesh& mesh, const ScanOptions& options, const Take& take) {
  const std::vector<Vector3d> viewpoints =
      options.viewpoints.empty() ? viewpoints_around(mesh, true) : options.viewpoints;
  if (options.order == Order::turning)
    sweep(mesh, TurningScanner(mesh, viewpoints), options, take);
  else
    sweep(mesh, Raster(mesh, viewpoints), options, take);
}

/// A unit vector in a cone of 30° about the axis, without trigonometry: a point of the cone's base.
Vector3d tilted(const Vector3d& axis, survey::Random& random) {
  const double tan_30 = 0.5773502691896258;
  const Vector3d across = axis.unitOrthogonal(), up = axis.cross(across);
  for (;;) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    if (x * x + y * y <= 1) return (axis + tan_30 * (x * across + y * up)).normalized();
  }
}

void scan_sampled(const Mesh& mesh, const ScanOptions& options, const Take& take) {
  const std::vector<Face> faces = faces_of(mesh);
  const SurfacePlaces places(mesh);
  Sensor sensor(mesh, options);
  survey::Random random(options.seed ^ 0x73616d706c656421u);
  for (std::int64_t i = 0; i < options.points; ++i) {
    const auto [position, triangle] = places.next(random);
    const int face = mesh.face_of_triangle[triangle];
    take(sensor.read(position, tilted(-faces[face].normal, random), 0, face));
  }
}

void shuffle(std::vector<LabelledPoint>& points, std::uint64_t seed) {
  survey::Random random(seed ^ 0x73687566666c6521u);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
}

}  // namespace

void scan(const Mesh& mesh, const ScanOptions& options, const Take& take) {
  if (options.points <= 0) throw std::invalid_argument("a scan needs a number of points");
  if (!(options.noise >= 0) || !(options.noise_per_range >= 0))
    throw std::invalid_argument("noise below zero");
  if (!(options.outliers >= 0 && options.outliers <= 1))
    throw std::invalid_argument("a fraction of outliers is between 0 and 1");
  if (options.order == Order::sampled) return scan_sampled(mesh, options, take);
  if (options.order != Order::shuffled) return scan_from_viewpoints(mesh, options, take);
  std::vector<LabelledPoint> points;
  scan_from_viewpoints(mesh, options, [&points](const LabelledPoint& point) { points.push_back(point); });
  shuffle(points, options.seed);
  for (const LabelledPoint& point : points) take(point);
}

std::vector<LabelledPoint> scan(const Mesh& mesh, const ScanOptions& options) {
  std::vector<LabelledPoint> points;
  scan(mesh, options, [&points](const LabelledPoint& point) { points.push_back(point); });
  return points;
}

}  // namespace limpet::simulation
