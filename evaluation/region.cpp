// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <limpet/evaluation/region.hpp>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;

constexpr int kSamples = 200;  // of a polygon's area, for telling what it lies on

double area_of(const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2; }

bool may_touch(const Region& a, const Region& b, double reach, double cos_max_angle) {
  return a.face.normal.dot(b.face.normal) >= cos_max_angle &&
         (a.low.array() <= b.high.array() + reach).all() && (b.low.array() <= a.high.array() + reach).all();
}

}  // namespace

Region::Region(const PlanarFace& planar_face)
    : face(planar_face), triangles(triangulated(planar_face)), surface(triangles) {
  low.setConstant(std::numeric_limits<double>::max());
  high = -low;
  for (const auto& cycle : face.cycles) {
    for (const Vector3d& p : cycle) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  for (const Triangle3& triangle : triangles) area += area_of(triangle);
}

Vector3d Region::foot(const Vector3d& point) const {
  if (triangles.empty()) return point;
  return point - (point - triangles.front()[0]).dot(face.normal) * face.normal;
}

std::vector<Region> regions(const std::vector<PlanarFace>& faces) {
  std::vector<Region> all;
  all.reserve(faces.size());
  for (const PlanarFace& face : faces) all.emplace_back(face);
  return all;
}

std::vector<Vector3d> spread_over(const std::vector<Triangle3>& triangles, int count) {
  double total = 0;
  for (const Triangle3& triangle : triangles) total += area_of(triangle);
  if (!(total > 0)) return {};
  std::vector<Vector3d> points;
  points.reserve(count);
  const double step = total / count;
  double area_before = 0, x = 0.5, y = 0.5;
  for (const Triangle3& t : triangles) {
    const double area = area_of(t);
    while (static_cast<int>(points.size()) < count &&
           (static_cast<double>(points.size()) + 0.5) * step <= area_before + area) {
      x += 0.7548776662466927;  // the additive sequence of least discrepancy in the square
      y += 0.5698402909980532;
      x -= std::floor(x);
      y -= std::floor(y);
      const bool beyond = x + y > 1;
      points.push_back(t[0] + (beyond ? 1 - x : x) * (t[1] - t[0]) + (beyond ? 1 - y : y) * (t[2] - t[0]));
    }
    area_before += area;
  }
  return points;
}

std::vector<Vector3d> along_boundary(const PlanarFace& face, double spacing) {
  std::vector<Vector3d> points;
  for (const auto& cycle : face.cycles) {
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const Vector3d &a = cycle[i], &b = cycle[(i + 1) % cycle.size()];
      const double pieces = std::max(1.0, std::ceil((b - a).norm() / spacing));
      for (double k = 0; k < pieces; ++k) points.push_back(a + k / pieces * (b - a));
    }
  }
  return points;
}

std::vector<std::pair<Vector3d, Vector3d>> boundary_segments(const PlanarFace& face) {
  std::vector<std::pair<Vector3d, Vector3d>> segments;
  for (const auto& cycle : face.cycles)
    for (std::size_t i = 0; i < cycle.size(); ++i)
      segments.emplace_back(cycle[i], cycle[(i + 1) % cycle.size()]);
  return segments;
}

std::vector<int> matches(const std::vector<Region>& polygons, const std::vector<Region>& candidates,
                         double reach, double max_angle_rad) {
  const double cos_max = std::cos(max_angle_rad);
  std::vector<int> found(polygons.size(), -1);
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    const std::vector<Vector3d> samples = spread_over(polygons[p].triangles, kSamples);
    std::vector<char> on_any(samples.size(), 0);
    double most = 0;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      if (!may_touch(polygons[p], candidates[c], reach, cos_max)) continue;
      double on = 0;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        const double distance = candidates[c].surface.distance(samples[i]);
        if (distance > reach) continue;
        on_any[i] = 1;
        on += 1 - 0.9 * distance / reach;  // of several faces closer to each other than λ the right one wins
      }
      if (on <= most) continue;
      most = on;
      found[p] = static_cast<int>(c);
    }
    if (2 * std::count(on_any.begin(), on_any.end(), 1) < static_cast<std::ptrdiff_t>(samples.size()))
      found[p] = -1;
  }
  return found;
}

double covered_share(const Region& polygon, const std::vector<Region>& candidates, double reach,
                     double max_angle_rad) {
  const double cos_max = std::cos(max_angle_rad);
  std::vector<const Region*> near;
  for (const Region& candidate : candidates)
    if (may_touch(polygon, candidate, reach, cos_max)) near.push_back(&candidate);
  const std::vector<Vector3d> samples = spread_over(polygon.triangles, kSamples);
  if (samples.empty()) return 0;
  const auto covered = std::count_if(samples.begin(), samples.end(), [&](const Vector3d& sample) {
    return std::any_of(near.begin(), near.end(),
                       [&](const Region* candidate) { return candidate->surface.distance(sample) <= reach; });
  });
  return static_cast<double>(covered) / static_cast<double>(samples.size());
}

double angle_between(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace limpet::evaluation
