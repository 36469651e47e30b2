// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/evidence.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <limpet/evaluation/empty_disc_internal.hpp>
#include <limpet/evaluation/footing_internal.hpp>
#include <limpet/evaluation/see_through_internal.hpp>
#include <numbers>
#include <stdexcept>
#include <tuple>

namespace limpet::evaluation {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using model::SensorPoint;

/// Readings on a polygon, in its plane. Those that lie on no polygon nearer than this tell its density: near
/// an edge the readings of the face beyond it lie on both.
struct Readings {
  std::vector<Vector2d> on, own;
};

bool before(const SensorPoint& a, const SensorPoint& b) {
  const auto key = [](const SensorPoint& p) {
    return std::tuple(p.position.x(), p.position.y(), p.position.z(), p.axis.x(), p.axis.y(), p.axis.z(),
                      p.range);
  };
  return key(a) < key(b);
}

/// In an order that is theirs, with one reading to a place.
void settle(std::vector<SensorPoint>& readings) {
  std::sort(readings.begin(), readings.end(), before);
  const auto same = [](const SensorPoint& a, const SensorPoint& b) { return a.position == b.position; };
  readings.erase(std::unique(readings.begin(), readings.end(), same), readings.end());
}

double farthest_range(const std::vector<SensorPoint>& readings) {
  double range = 0;
  for (const SensorPoint& reading : readings) range = std::max(range, reading.range);
  return range;
}

/// Gives the readings to the polygons they lie on, and counts those that are explained.
std::vector<Readings> distribute(const std::vector<SensorPoint>& readings, const std::vector<Ground>& grounds,
                                 const Footing& footing, const Tolerance& tolerance, Evidence& evidence) {
  std::vector<Readings> given(grounds.size());
  for (const SensorPoint& reading : readings) {
    const double off = tolerance.at(reading.range);
    double least = std::numeric_limits<double>::infinity();
    int nearest = -1;
    footing.each(reading, off, [&](const Footing::Foot& foot) {
      given[foot.polygon].on.push_back(grounds[foot.polygon].flat.flat(reading.position));
      if (foot.distance < least) least = foot.distance, nearest = foot.polygon;
    });
    if (nearest >= 0) given[nearest].own.push_back(grounds[nearest].flat.flat(reading.position));
    if (least <= off) ++evidence.explained;
  }
  return given;
}

/// The share of a polygon's area that is farther from every reading than chance explains.
double empty_share(const Ground& ground, const EmptyDiscs& discs, const LocalDensity& density, double chance,
                   const ResolutionField& resolution) {
  constexpr double kSpacing = 0.25;  // of λ, between places that are asked
  constexpr double kFewest = 100, kMost = 50'000;
  const double edge = kSpacing * resolution.least(ground.region.low, ground.region.high);
  const double wanted = ground.region.area / (edge * edge);
  const auto places =
      spread_over(ground.region.triangles, static_cast<int>(std::clamp(wanted, kFewest, kMost)));
  if (places.empty()) return 0;
  const auto empty = std::count_if(places.begin(), places.end(), [&](const Vector3d& world) {
    const Vector2d place = ground.flat.flat(world), nearest = discs.nearest(place);
    const double radius = (place - nearest).norm();
    return radius > resolution.at(world) && density.at(nearest) * std::numbers::pi * radius * radius > chance;
  });
  return static_cast<double>(empty) / static_cast<double>(places.size());
}

/// All of a polygon that has no reading at all.
void judge_bare(const Ground& ground, double density, PolygonEvidence& polygon) {
  const auto middle = spread_over(ground.region.triangles, 1);
  polygon.emptiest.centre = middle.empty() ? ground.region.low : middle.front();
  for (const auto& cycle : ground.region.face.cycles)
    for (const Vector3d& vertex : cycle)
      polygon.emptiest.radius = std::max(polygon.emptiest.radius, (vertex - polygon.emptiest.centre).norm());
  polygon.emptiest.expected = density * polygon.area;
  polygon.empty_area = polygon.area;
}

void judge_support(const Ground& ground, const Readings& readings, double usual_density, double chance,
                   const ResolutionField& resolution, PolygonEvidence& polygon) {
  constexpr double kSquare = 2;       // λ: some twenty readings at the density that λ is chosen for
  constexpr double kSpacing = 0.125;  // λ, along perimeters
  const LocalDensity density(readings.own.empty() ? readings.on : readings.own,
                             kSquare * resolution.at((ground.region.low + ground.region.high) / 2));
  polygon.density = density.overall();
  if (readings.on.empty()) return judge_bare(ground, usual_density, polygon);
  const EmptyDiscs discs(readings.on, ground.flat, density);
  const double spacing = kSpacing * resolution.least(ground.region.low, ground.region.high);
  std::vector<Vector2d> perimeter;
  for (const Vector3d& place : along_boundary(ground.region.face, spacing))
    perimeter.push_back(ground.flat.flat(place));
  const FlatDisc emptiest = discs.emptiest(perimeter, {resolution, ground.flat, chance});
  polygon.emptiest = {ground.flat.raised(emptiest.centre), emptiest.radius, emptiest.expected,
                      emptiest.excused};
  polygon.empty_area = polygon.area * empty_share(ground, discs, density, chance, resolution);
}

/// The median density of the polygons' readings, for polygons that have none.
double usual_density(const std::vector<Readings>& readings, const std::vector<Ground>& grounds,
                     const ResolutionField& resolution) {
  std::vector<std::pair<double, std::size_t>> densities;  // with the readings it is of
  std::size_t all = 0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const Readings& of = readings[i];
    if (of.own.empty()) continue;
    const double edge = 2 * resolution.at((grounds[i].region.low + grounds[i].region.high) / 2);
    densities.emplace_back(LocalDensity(of.own, edge).overall(), of.own.size());
    all += of.own.size();
  }
  std::sort(densities.begin(), densities.end());
  std::size_t sum = 0;
  for (const auto& [density, count] : densities)
    if (2 * (sum += count) >= all) return density;
  return 0;
}

void judge_polygon(double chance, PolygonEvidence& polygon) {
  const bool judged = !polygon.given && !polygon.emptiest.excused;
  polygon.beyond_chance = judged && polygon.emptiest.expected > chance;
  polygon.unsupported = judged && polygon.emptiest.expected > kSupportMargin * chance;
  polygon.transparent =
      polygon.rays_through > kStrayRays &&
      static_cast<double>(polygon.rays_through) > kStrayShare * static_cast<double>(polygon.rays_on);
}

void add_up(Evidence& evidence) {
  double most = 0;
  for (std::size_t i = 0; i < evidence.polygons.size(); ++i) {
    const PolygonEvidence& polygon = evidence.polygons[i];
    evidence.beyond_chance += polygon.beyond_chance;
    evidence.unsupported += polygon.unsupported;
    evidence.transparent += polygon.transparent;
    if (polygon.given) continue;
    evidence.empty_area += polygon.empty_area;
    if (polygon.emptiest.expected <= most) continue;
    most = polygon.emptiest.expected;
    evidence.emptiest = static_cast<int>(i);
  }
}

}  // namespace

double Evidence::explained_share() const {
  return readings > 0 ? static_cast<double>(explained) / static_cast<double>(readings) : 0;
}

double most_by_chance(std::int64_t readings) {
  const double m = static_cast<double>(std::max<std::int64_t>(readings, 1));
  double low = 0, high = 1000;  // between them, 2m(1 + a)e^(−a) falls from 2m to nothing
  for (int i = 0; i < 60; ++i) {
    const double a = (low + high) / 2;
    (2 * m * (1 + a) * std::exp(-a) > kDiscsByChance ? low : high) = a;
  }
  return high;
}

Evidence judge_evidence(const model::ModelRecord& model, std::vector<SensorPoint> readings) {
  const ResolutionField resolution(model.parameters);
  settle(readings);
  Evidence evidence;
  evidence.readings = static_cast<std::int64_t>(readings.size());
  evidence.chance = most_by_chance(evidence.readings);

  const std::vector<Ground> grounds = grounds_of(model);
  const Tolerance tolerance(model);
  const Footing footing(grounds, resolution, tolerance.at(farthest_range(readings)));
  const std::vector<Readings> given = distribute(readings, grounds, footing, tolerance, evidence);
  const RayCounts rays = see_through(grounds, footing, tolerance, readings, resolution, kMostRays);
  evidence.rays = rays.rays;
  const double usual = usual_density(given, grounds, resolution);
  for (std::size_t i = 0; i < grounds.size(); ++i) {
    PolygonEvidence& polygon = evidence.polygons.emplace_back();
    polygon.id = grounds[i].region.face.id;
    polygon.area = grounds[i].region.area;
    polygon.readings = static_cast<std::int64_t>(given[i].on.size());
    polygon.given = grounds[i].region.face.points == 0;
    polygon.rays_on = rays.on[i];
    polygon.rays_through = rays.through[i];
    judge_support(grounds[i], given[i], usual, evidence.chance, resolution, polygon);
    judge_polygon(evidence.chance, polygon);
  }
  add_up(evidence);
  return evidence;
}

}  // namespace limpet::evaluation
