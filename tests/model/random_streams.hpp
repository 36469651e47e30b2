// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "streams.hpp"

/// Streams of readings as no sensor gives them: degenerate placements at random, to be survived.
namespace limpet::model::testing {

struct Stream {
  Parameters parameters;
  std::vector<Points> sets;
};

namespace random_streams {

inline Vector3d any_direction(auto& random) {
  for (;;) {
    const Vector3d d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (d.norm() > 0.1 && d.norm() < 1) return d.normalized();
  }
}

/// That takes the unit vector a to the unit vector b. Eigen's own brings a singular value decomposition
/// along, which takes longer to compile than all else here.
inline Eigen::Matrix3d rotation(const Vector3d& a, const Vector3d& b) {
  const double w2 = 1 + a.dot(b);
  if (w2 < 1e-9) return Eigen::AngleAxisd(std::numbers::pi, a.unitOrthogonal()).toRotationMatrix();
  const double s = std::sqrt(2 * w2);
  Eigen::Quaterniond turn;
  turn.vec() = a.cross(b) / s;
  turn.w() = s / 2;
  return turn.toRotationMatrix();
}

inline double grid(auto& random, int cells) {
  return static_cast<double>(random.below(static_cast<std::uint64_t>(cells) + 1));
}

/// A piece of a world about one of the origin's octants, in units of λ; the surface is seen from above.
inline Points piece(auto& random, int count) {
  const auto kind = random.below(14);
  const double size = random.uniform(2, 12), t = random.uniform(0.02, 1.6);
  const Vector3d a = any_direction(random), b = any_direction(random);
  Points points;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(0, size), y = random.uniform(0, size), along = random.uniform(-1, 1);
    const double part = static_cast<double>(i) / count;
    Vector3d p = {x, y, 0}, axis = {0, 0, -1};
    switch (kind) {
      case 0:  // a line
        p = x * a;
        break;
      case 1:  // the lattice of a plane, spaced λ/2 or 1/3 λ
        p = {grid(random, 8) / (size < 6 ? 2 : 3), grid(random, 8) / (size < 6 ? 2 : 3), 0};
        break;
      case 2:  // a handful of places, again and again
        p = {grid(random, 2), grid(random, 2), grid(random, 1)};
        break;
      case 3: {  // edges and corners of a box
        p = {grid(random, 1), grid(random, 1), grid(random, 1)};
        if (random.below(2)) p[static_cast<int>(random.below(3))] = random.uniform();
        p *= size / 3;
        axis = (Vector3d::Constant(size / 6) - p).normalized();
        break;
      }
      case 4:  // two planes a hair apart, seen from one side or from both
        p.z() = random.below(2) ? t : 0;
        if (size < 7 && p.z() == 0) axis.z() = 1;
        break;
      case 5: {  // spikes out of a disc
        const double turn = grid(random, 7);
        p = random.below(3) ? Vector3d(along, random.uniform(-1, 1), 0)
                            : Vector3d(size * part * std::cos(turn), size * part * std::sin(turn), 0);
        break;
      }
      case 6:  // a plane with bursts of outliers
        if (random.below(4) == 0) p = size * Vector3d(random.uniform(), random.uniform(), along);
        break;
      case 7:  // denser and denser towards a corner
        p = size * std::pow(2, -8 * random.uniform()) * Vector3d(random.uniform(), random.uniform(), 0);
        break;
      case 8:  // a ring, walked round several times
        p = size / 2 * Vector3d(std::cos(30 * part), std::sin(30 * part), 0) * (1 + 0.1 * along);
        break;
      case 9:  // a spiral
        p = size * part * Vector3d(std::cos(20 * part), std::sin(20 * part), 0);
        break;
      case 10:  // a comb
        p = random.below(4) ? Vector3d(t * grid(random, 8), y, 0) : Vector3d(8 * t * random.uniform(), 0, 0);
        break;
      case 11:  // a fan of planes about the y axis
        p = x * Vector3d(std::cos(t * grid(random, 3)), 0, std::sin(t * grid(random, 3))) + Vector3d(0, y, 0);
        break;
      case 12:  // a cylinder
        axis = -Vector3d(std::cos(x), std::sin(x), 0);
        p = -size / 3 * axis + Vector3d(0, 0, y);
        break;
      default:  // rows, like a raster
        p = {t * std::floor(part * 12), size * (12 * part - std::floor(12 * part)), 0};
        if (static_cast<int>(part * 12) % 2) p.y() = size - p.y();
    }
    points.push_back({p, axis});
  }
  // In half of the pieces axes are tilted, up to any direction at all; rarely against the surface.
  if (random.below(2)) {
    const double tilt = random.below(3) ? 0.5 : 3;
    for (auto& p : points) p.axis = (p.axis + tilt * any_direction(random)).normalized();
  }
  if (random.below(3) == 0) {  // anywhere in space
    const Eigen::Matrix3d turned = rotation(a, b);
    for (auto& p : points) p = {turned * p.position, turned * p.axis};
  }
  return points;
}

inline Points world(auto& random, int least) {
  const int count = least + static_cast<int>(random.below(static_cast<std::uint64_t>(least) * 3 / 2 + 1));
  const int pieces = static_cast<int>(1 + random.below(4));
  Points points;
  for (int i = 0; i < pieces; ++i) {
    const Vector3d at = random.below(2) ? Vector3d(grid(random, 3), grid(random, 3), 0) : Vector3d::Zero();
    for (auto p : piece(random, count / pieces)) {
      p.position += at;
      points.push_back(p);
    }
  }
  if (random.below(2)) shuffle(points, random);
  return points;
}

inline Parameters parameters(auto& random) {
  constexpr double kNoise[] = {0, 0, 0.001, 0.01, 0.1, 1};
  constexpr double kAngle[] = {0.17453292519943295, 0.17453292519943295, 0.02, 0.7, 1.5};
  Parameters p;
  p.noise = kNoise[random.below(6)];
  p.angle_rad = kAngle[random.below(5)];
  if (random.below(4) == 0) p.tolerance = random.uniform(0, 1.2);
  if (random.below(4) == 0) p.outlier_patience = static_cast<std::int64_t>(random.below(200));
  const auto rules = random.below(6);
  if (rules == 0) p.rules = Rules::thesis();
  if (rules == 1)
    for (const auto& name : Rules::names())
      if (random.below(3) == 0) p.rules = Rules::parse("-" + name);
  return p;
}

/// Noise of half the model's, at places far away and at all scales; some readings spoilt.
inline void place(auto& random, Points& points, Parameters& p) {
  constexpr double kResolution[] = {1, 1, 0.05, 3e-7, 1e9, 1e-60, 1e60};
  p.resolution = kResolution[random.below(7)];
  Vector3d away = Vector3d::Zero();
  if (random.below(4) == 0) away = std::pow(10, random.uniform(0, 10)) * any_direction(random);
  for (auto& reading : points) {
    const Vector3d noisy = reading.position + p.noise / 2 * random.normal() * reading.axis;
    reading.position = p.resolution * (noisy + away);
    if (random.below(100) == 0) reading.position[0] = std::numeric_limits<double>::quiet_NaN();
    if (random.below(100) == 0) reading.axis.setZero();
  }
  p.noise *= p.resolution;
  p.tolerance *= p.resolution;
}

}  // namespace random_streams

/// Of this many points at least, and up to two and a half times as many.
inline Stream random_stream(auto& random, int least) {
  Stream stream;
  Points points = random_streams::world(random, least);
  stream.parameters = random_streams::parameters(random);
  random_streams::place(random, points, stream.parameters);
  const auto largest = 1 + random.below(random.below(3) ? 40 : 200);
  for (std::size_t i = 0; i < points.size();) {
    const std::size_t n = std::min<std::size_t>(1 + random.below(largest), points.size() - i);
    stream.sets.emplace_back(points.begin() + static_cast<std::ptrdiff_t>(i),
                             points.begin() + static_cast<std::ptrdiff_t>(i + n));
    i += n;
  }
  return stream;
}

inline Stream random_stream(std::uint64_t seed) {
  Random random(seed);
  return random_stream(random, 200);
}

}  // namespace limpet::model::testing
