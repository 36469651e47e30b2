// Copyright the limpet authors. GPL-3.0-or-later.
//
// The surface's area per point and the noise, from the neighbours of some points of the scan. Both are taken
// at the smallest scale at which the neighbourhood looks like a surface: below the noise a scan is a cloud.
#include <limpet/survey/curved_patches.hpp>
#include <limpet/survey/estimate.hpp>
#include <limpet/survey/neighbourhoods_internal.hpp>
#include <limpet/survey/noise_law.hpp>
#include <limpet/survey/rounded_depths.hpp>
#include <limpet/survey/sensor_places.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace limpet::survey {
namespace {

constexpr double kSparseShare = 0.05;  ///< of the surface, which is its sparse part
/// Points to λ² there, where λ grows with the range. With three of them, far walls of rooms came to pieces.
constexpr double kSparsePoints = 5;
constexpr double kGrowsAbove = 1.5;  ///< see suitable_resolution()
constexpr int kNeighbours = 16;
constexpr int kWideNeighbours = 64;  ///< with five points to λ² they lie within 2 λ
constexpr double kFinePart = 0.75;   ///< of these, for area and noise
constexpr double kFlat = 0.15;       ///< thickness over radius below which a neighbourhood is a surface

/// Of the angle of incidence: below the one a neighbourhood says nothing of the noise, below the other
/// nothing.
constexpr double kNoiseCosine = 0.2, kLeastCosine = 0.05;

constexpr double kWild = 1000;  ///< see without_wild()

constexpr std::int64_t kRoundedShare = 50;  ///< depths are rounded if one neighbourhood in so many shows it

/// What a neighbourhood says when it is flat.
struct Patch {
  double area_per_point = 0;
  DepthNoise noise;
  double range = 0;
  double cosine = 1;       ///< of the angle at which it was seen
  double finest_area = 0;  ///< per point, at the finest scale at which it is flat, grazing or not
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double thickness = 0;
};

struct Principal {
  Eigen::Vector3d variances, thinnest;
};

Principal principal(const std::vector<model::SensorPoint>& points) {
  const auto m = static_cast<double>(points.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& p : points) mean += p.position / m;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& p : points) {
    const Eigen::Vector3d d = p.position - mean;
    covariance += d * d.transpose() / (m - 3);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  return {solver.eigenvalues().cwiseMax(0), solver.eigenvectors().col(0)};
}

std::optional<Patch> patch_of(Neighbourhood around, const Eigen::Vector3d& axis,
                              const RoundedDepths& rounded) {
  constexpr std::size_t kFewest = 8;
  if (around.points.size() < kFewest || !(around.radius > 0)) return std::nullopt;
  const bool has_axis = !axis.isZero();
  // A thin plate has a back, which was sensed from the other side.
  const Eigen::Vector3d normal = principal(around.points).thinnest;
  std::erase_if(around.points, [&](const model::SensorPoint& p) {
    return has_axis && std::signbit(p.axis.dot(normal)) != std::signbit(axis.dot(normal));
  });
  if (around.points.size() < kFewest) return std::nullopt;
  const Principal found = principal(around.points);
  const double thickness = std::sqrt(found.variances[0]);
  // A line of points (one row of a scanner) says nothing about area, nor about a normal.
  if (thickness > kFlat * around.radius || found.variances[1] < 0.05 * found.variances[2])
    return std::nullopt;
  const double cosine = has_axis ? std::abs(found.thinnest.dot(axis)) : 1;
  if (cosine < kLeastCosine) return std::nullopt;
  // The centre is one of the points: of the others there are m - 1 in the disc.
  const double others = static_cast<double>(around.points.size() - 1) * around.weight;
  Patch patch;
  patch.cosine = cosine;
  patch.area_per_point = M_PI * around.radius * around.radius / others;
  patch.noise = noise_of(around.points, has_axis ? axis : found.thinnest, thickness / cosine, rounded);
  patch.normal = found.thinnest;
  patch.thickness = thickness;
  return patch;
}

/// Sorted, without the largest 3 %, which come from outliers.
std::vector<double> trimmed(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.resize(values.size() - values.size() * 3 / 100);
  return values;
}

/// The mean of the area per point, taken over the points, is the total area over the number of points even
/// where the density varies: dense parts have more points that say little, sparse ones fewer that say much.
double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

/// The value that is exceeded on 5 % of the surface. With each goes the area that it stands for.
double sparse(std::vector<std::pair<double, double>> values) {
  std::sort(values.begin(), values.end());
  double left = 0;
  for (const auto& [value, area] : values) left += kSparseShare * area;
  for (auto at = values.rbegin(); at != values.rend(); ++at) {
    left -= at->second;
    if (left <= 0) return at->first;
  }
  return 0;
}

double sparse_area(const std::vector<double>& areas) {
  std::vector<std::pair<double, double>> values;
  for (const double area : areas) values.emplace_back(area, area);
  return sparse(std::move(values));
}

/// The finest scale at which the neighbourhood of a centre is flat; an empty patch where there is none.
Patch first_flat(const Neighbourhood& fine, const SampleTree& coarse, const model::SensorPoint& centre,
                 const RoundedDepths& rounded) {
  Patch found;
  found.range = centre.range;
  found.at = centre.position;
  // Returns whether this says all there is to know.
  const auto take = [&](const std::optional<Patch>& patch) {
    if (!patch) return false;
    if (found.finest_area == 0) found.finest_area = patch->area_per_point;
    if (patch->cosine < kNoiseCosine) return false;
    found.area_per_point = patch->area_per_point;
    found.cosine = patch->cosine, found.noise = patch->noise, found.normal = patch->normal,
    found.thickness = patch->thickness;
    return true;
  };
  bool done = take(patch_of(fine, centre.axis, rounded));
  for (int count = kNeighbours; !done && count <= 64 * kNeighbours; count *= 4)
    done = take(patch_of(coarse.nearest(centre, count), centre.axis, rounded));
  return found;
}

/// Looks a second time if the first shows that the depths were rounded before the scan was turned.
std::vector<Patch> look_at(const Sampled& sample, const std::vector<std::size_t>& centres,
                           const std::vector<Neighbourhood>& fine, const SampleTree& coarse) {
  const auto look = [&](const RoundedDepths& rounded) {
    std::vector<Patch> patches;
    for (std::size_t i = 0; i < centres.size(); ++i)
      patches.push_back(first_flat(fine[i], coarse, sample.points[centres[i]], rounded));
    return patches;
  };
  const std::vector<Patch> patches = look({});
  Eigen::AlignedBox3d box;
  for (const auto& p : sample.points) box.extend(p.position);
  // Coordinates are written with seven digits or so.
  const double within = 1e-6 * box.diagonal().norm();
  std::vector<Eigen::Vector3d> normals;
  for (const Patch& patch : patches) {
    if (patch.area_per_point > 0 && patch.thickness < within) normals.push_back(patch.normal);
  }
  const auto rounded = rounded_depths(normals, patches.size(), within);
  return rounded ? look(*rounded) : patches;
}

/// See Estimate::sparse_per_range.
double sparse_per_range(const std::vector<Patch>& patches, const std::vector<Eigen::Vector3d>& sensors) {
  std::vector<std::pair<double, double>> values;
  for (const Patch& patch : patches) {
    double range2 = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& sensor : sensors)
      range2 = std::min(range2, (patch.at - sensor).squaredNorm());
    if (patch.finest_area > 0 && range2 > 0 && !std::isinf(range2))
      values.emplace_back(std::sqrt(kSparsePoints * patch.finest_area / range2), patch.finest_area);
  }
  return sparse(std::move(values));
}

/// What the neighbourhoods say that have a flat part.
std::vector<WidePatch> wide_patches(const std::vector<Patch>& patches, const std::vector<Neighbourhood>& wide,
                                    const NoiseLaw& noise) {
  std::vector<WidePatch> found;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const Patch& patch = patches[i];
    if (!(patch.area_per_point > 0)) continue;
    std::vector<Eigen::Vector3d> points;
    for (const auto& p : wide[i].points) points.push_back(p.position);
    if (const auto scatter = patch_scatter(points, patch.normal))
      found.push_back({wide[i].radius, noise.at(patch.range) * patch.cosine, *scatter});
  }
  return found;
}

Estimate summarise(const Sampled& sample, const std::vector<Patch>& patches,
                   const std::vector<Neighbourhood>& wide) {
  std::vector<double> areas, ranges;
  std::vector<NoiseAt> noises;
  // A wall of one depth is exact, unless depths are rounded elsewhere, too.
  const auto rounded = std::count_if(patches.begin(), patches.end(), [](const Patch& patch) {
    return patch.area_per_point > 0 && patch.noise.kind == DepthNoise::Kind::few_depths;
  });
  const bool single_says_nothing = kRoundedShare * rounded >= static_cast<std::int64_t>(patches.size());
  // The scatter of exact readings is the rounding of their coordinates, which is no noise.
  double largest = 0;
  for (const auto& p : sample.points) largest = std::max(largest, p.position.cwiseAbs().maxCoeff());
  for (const Patch& patch : patches) {
    if (!(patch.area_per_point > 0)) continue;
    areas.push_back(patch.area_per_point);
    if (patch.noise.kind == DepthNoise::Kind::single_depth && single_says_nothing) continue;
    noises.push_back(
        {patch.range, patch.noise.noise < 1e-12 * largest ? 0 : patch.noise.noise, patch.cosine});
  }
  for (const auto& p : sample.points) ranges.push_back(p.range);
  areas = trimmed(std::move(areas));
  const std::vector<Eigen::Vector3d> sensors = sensor_places(sample.points, model::kMostSensors);
  const NoiseLaw noise = fit_noise_law(noises);
  return {mean(areas),
          sparse_area(areas),
          noise,
          surface_curvature(wide_patches(patches, wide, noise), patches.size()),
          quantile(ranges, 0.05),
          quantile(ranges, 0.95),
          sparse_per_range(patches, sensors),
          sensors,
          sample.count};
}

/// Without points that are a thousand times as far from the middle as 95 % of them: errors of a file, beside
/// which all else would look exact, and flat to the last digit.
Sampled without_wild(Sampled sample) {
  Eigen::Vector3d middle;
  for (int i = 0; i < 3; ++i) {
    std::vector<double> coordinates;
    for (const auto& p : sample.points) coordinates.push_back(p.position[i]);
    middle[i] = quantile(std::move(coordinates), 0.5);
  }
  std::vector<double> distances;
  for (const auto& p : sample.points) distances.push_back((p.position - middle).norm());
  const double farthest = kWild * quantile(std::move(distances), 0.95);
  if (farthest > 0)
    std::erase_if(sample.points,
                  [&](const model::SensorPoint& p) { return (p.position - middle).norm() > farthest; });
  return sample;
}

/// What the sample alone tells.
Estimate coarse_estimate(const Sampled& sample) {
  const auto centres = centres_of(sample);
  const SampleTree coarse(sample);
  const auto patches = look_at(sample, centres, std::vector<Neighbourhood>(centres.size()), coarse);
  std::vector<Neighbourhood> wide;
  for (const std::size_t i : centres) wide.push_back(coarse.nearest(sample.points[i], kWideNeighbours));
  return summarise(sample, patches, wide);
}

}  // namespace

Estimate estimate(const Sample& sample) { return coarse_estimate(without_wild(sample.result())); }

Estimate estimate(const std::function<void(const Take&)>& pass) {
  Sample all;
  pass([&](const model::SensorPoint& point) { all.add(point); });
  const Sampled sample = without_wild(all.result());
  if (sample.weight <= 1) return coarse_estimate(sample);

  // A second look, at all the points near the centres.
  const SampleTree coarse(sample);
  const auto centres = centres_of(sample);
  std::vector<Neighbourhood> wide;
  for (const std::size_t i : centres) {
    const double here = coarse.nearest(sample.points[i], kNeighbours).radius;
    wide.push_back({{}, here * std::sqrt(kWideNeighbours / (kNeighbours * sample.weight)), 1});
  }
  collect(pass, sample, centres, wide);
  std::vector<Neighbourhood> fine;
  for (std::size_t i = 0; i < centres.size(); ++i)
    fine.push_back(
        within(wide[i], sample.points[centres[i]].position, std::sqrt(kFinePart) * wide[i].radius));
  const auto patches = look_at(sample, centres, fine, coarse);
  return summarise(sample, patches, wide);
}

double ResolutionBounds::largest() const { return std::max({density, sparse_parts, noise}); }

ResolutionBounds resolution_bounds(const Estimate& estimate, const NoiseLaw& noise) {
  const double usual = 2.2 * std::sqrt(estimate.area_per_point);
  return {usual, std::min(std::sqrt(3 * estimate.sparse_area), 4 * usual / 3),
          std::max(10 * noise.at(estimate.near_range), 5 * noise.at(estimate.far_range))};
}

ResolutionLaw suitable_resolution(const Estimate& estimate, const NoiseLaw& noise) {
  const double everywhere = resolution_bounds(estimate, noise).largest();
  const double growth = std::min(estimate.sparse_per_range, model::kMostResolutionGrowth),
               near = estimate.near_range;
  const bool asked_for =
      growth * estimate.far_range > kGrowsAbove * everywhere && estimate.far_range > kGrowsAbove * near;
  if (!asked_for) return everywhere;
  return {std::max(10 * noise.at(near) - growth * near, growth * near / 10), growth};
}

NoiseLaw facet_noise(const Estimate& estimate, const NoiseLaw& noise, double resolution) {
  const double near = noise.at(estimate.near_range), turning = estimate.curvature * resolution * resolution,
               both = std::min(std::hypot(near, turning), std::max(near, resolution / 15));
  return {noise.fixed + (both - near), noise.per_range, noise.per_range2};
}

double points_to_square(const Estimate& estimate, const ResolutionLaw& resolution) {
  if (!resolution.varies()) return resolution.fixed * resolution.fixed / estimate.area_per_point;
  const double far = estimate.sparse_per_range * estimate.far_range,
               part = resolution.at(estimate.far_range) / far;
  return kSparsePoints * part * part;
}

double suitable_tolerance(double noise, double resolution) { return std::max(3 * noise, resolution / 5); }

}  // namespace limpet::survey
