// Copyright the limpet authors. GPL-3.0-or-later.
#include "hostile_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include <Eigen/Geometry>
#include <limpet/survey/random.hpp>

#include "cloud.hpp"

namespace limpet::benchmarks {
namespace {

using Eigen::Vector3d;
using model::SensorPoint;
using survey::Random;

/// The unit of length is λ.
constexpr double kNoise = 0.02, kDensity = 5;
constexpr std::uint64_t kSeed = 1;

Vector3d any_axis(Random& random) {
  for (;;) {
    const Vector3d d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (d.norm() > 0.1 && d.norm() < 1) return d.normalized();
  }
}

/// A noisy reading of a surface there, from up to about 30° beside its normal.
SensorPoint reading(Random& random, const Vector3d& at, const Vector3d& normal) {
  const Vector3d axis = (0.5 * any_axis(random) - normal).normalized();
  return {at + kNoise * random.normal() * axis, axis};
}

/// Makes so many readings, one after the other.
template <class Make>
HostileCloud cloud_of(double points, const Make& make) {
  HostileCloud cloud;
  cloud.parameters.resolution = 1, cloud.parameters.noise = kNoise;
  cloud.scan = [count = std::llround(points), make](const auto& take) {
    Random random(kSeed);
    for (std::int64_t i = 0; i < count; ++i) take(make(random));
  };
  return cloud;
}

/// Readings of those parts of a rectangle in the plane z = 0 for which `is_there`.
template <class IsThere>
HostileCloud sheet(double width, double height, double area, const IsThere& is_there) {
  return cloud_of(kDensity * area, [=](Random& random) {
    for (;;) {
      const double x = random.uniform(0, width), y = random.uniform(0, height);
      if (is_there(x, y)) return reading(random, {x, y, 0}, Vector3d::UnitZ());
    }
  });
}

HostileCloud holes(int count) {
  constexpr double kApart = 6;
  const int side = static_cast<int>(std::lround(std::sqrt(count)));
  std::vector<double> widths;
  Random random(kSeed);
  double area = side * side * kApart * kApart;
  for (int i = 0; i < side * side; ++i) {
    widths.push_back(random.uniform(2.5, 3));
    area -= widths.back() * widths.back();
  }
  return sheet(side * kApart, side * kApart, area, [=](double x, double y) {
    const auto i = static_cast<int>(x / kApart), j = static_cast<int>(y / kApart);
    const double half =
        widths[static_cast<std::size_t>(j) * static_cast<std::size_t>(side) + static_cast<std::size_t>(i)] /
        2;
    return std::max(std::abs(x - (i + 0.5) * kApart), std::abs(y - (j + 0.5) * kApart)) > half;
  });
}

/// As high as wide, so that the perimeters' length goes with the area.
HostileCloud combs(int teeth) {
  constexpr double kTooth = 4, kGap = 2, kPitch = 2 * (kTooth + kGap);
  const double width = teeth * kPitch;
  const double area = 2 * kTooth * width + 2 * teeth * kTooth * (width - 2 * kTooth - kGap);
  return sheet(width, width, area, [=](double x, double y) {
    if (y < kTooth || y > width - kTooth) return true;  // the spines
    const double along = std::fmod(x, kPitch);
    if (along < kTooth) return y < width - kTooth - kGap;
    return along > kTooth + kGap && along < kPitch - kGap && y > kTooth + kGap;
  });
}

struct Rectangle {
  Vector3d centre, u, v;  // half its sides
  double area_so_far;     // with those before it
};

std::vector<Rectangle> rectangles(int count) {
  constexpr double kEdge = 40;  // of the cube
  std::vector<Rectangle> all;
  Random random(kSeed);
  double area = 0;
  for (int i = 0; i < count; ++i) {
    Vector3d centre;
    for (double& x : centre) x = random.uniform(kEdge / 4, 3 * kEdge / 4);
    const Vector3d u = any_axis(random), v = u.cross(any_axis(random)).normalized();
    const double a = random.uniform(kEdge / 4, kEdge / 2), b = random.uniform(kEdge / 4, kEdge / 2);
    area += 4 * a * b;
    all.push_back({centre, a * u, b * v, area});
  }
  return all;
}

HostileCloud planes(int count) {
  const auto all = rectangles(count);
  const double area = all.back().area_so_far;
  return cloud_of(kDensity * area, [=](Random& random) {
    const double where = random.uniform(0, area);
    const Rectangle& r = *std::find_if(all.begin(), all.end() - 1,
                                       [&](const Rectangle& any) { return any.area_so_far > where; });
    const double s = random.uniform(-1, 1), t = random.uniform(-1, 1);
    return reading(random, r.centre + s * r.u + t * r.v, r.u.cross(r.v).normalized());
  });
}

/// Its σ is large, so that planes are found in it.
HostileCloud noise(int points) {
  const double edge = std::cbrt(points / kDensity);
  HostileCloud cloud = cloud_of(points, [=](Random& random) {
    Vector3d at;
    for (double& x : at) x = random.uniform(0, edge);
    return SensorPoint{at, any_axis(random)};
  });
  cloud.parameters.noise = 0.2;
  return cloud;
}

HostileCloud city(const HostileSpec& spec) {
  const auto scan_case =
      std::make_shared<ScanCase>(CloudSpec{.shape = spec.shape, .order = "sampled", .points = spec.points});
  return {scan_case->parameters(), [scan_case](const auto& take) {
            scan_case->scan([&](const simulation::LabelledPoint& p) { take(p.point); });
          }};
}

}  // namespace

HostileCloud hostile_cloud(const HostileSpec& spec) {
  const std::size_t colon = spec.shape.find(':');
  const std::string kind = spec.shape.substr(0, colon);
  const int size = colon == std::string::npos ? 0 : std::stoi(spec.shape.substr(colon + 1));
  if (size > 0) {
    if (kind == "holes") return holes(size);
    if (kind == "combs") return combs(size);
    if (kind == "planes") return planes(size);
    if (kind == "noise") return noise(size);
    if (kind == "city") return city(spec);
  }
  throw std::invalid_argument("no such shape: " + spec.shape);
}

}  // namespace limpet::benchmarks
