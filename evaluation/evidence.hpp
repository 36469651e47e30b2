// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limpet/model/record.hpp>
#include <limpet/model/sensor_point.hpp>
#include <vector>

namespace limpet::evaluation {

// Judging a model by the readings it was made from: is all of it supported by some, and contradicted by none?
// No truth is needed, and no code of the engine is used (docs/evidence.md). World frame, scan's unit.

/// So many empty discs that say nothing are let pass, on average, in a whole scan.
inline constexpr double kDiscsByChance = 0.01;
/// An empty disc fails a model above this much of what chance explains: the law is one of Poisson streams,
/// and densities are known to about a fifth.
inline constexpr double kSupportMargin = 1.5;
/// A polygon is contradicted by more rays than this through it (a few strays prove nothing) …
inline constexpr std::int64_t kStrayRays = 5;
/// … which are also more than this share of those that end on it.
inline constexpr double kStrayShare = 0.01;
/// Rays that are followed, evenly taken from all.
inline constexpr std::int64_t kMostRays = 200'000;

/// A disc in a polygon's plane that holds none of its readings.
struct EmptyDisc {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< in the polygon or on its perimeter
  double radius = 0;
  double expected = 0;  ///< readings, by the density beside it, in the part of the disc inside the polygon
  /// The resolution explains it: its radius is no more than λ, or √2 λ where the perimeter cuts it.
  bool excused = false;
};

struct PolygonEvidence {
  std::uint64_t id = 0;
  double area = 0;
  std::int64_t readings = 0;      ///< that lie on it (see judge_evidence())
  double density = 0;             ///< readings to a unit of area: the median of the places that hold any
  EmptyDisc emptiest;             ///< the disc with the most readings expected in it
  double empty_area = 0;          ///< farther from all its readings than chance explains
  std::int64_t rays_on = 0;       ///< of the rays followed, those that end on it
  std::int64_t rays_through = 0;  ///< … and those that pass through it to a reading behind
  bool given = false;             ///< known beforehand, no matter of readings: its support is not judged
  bool beyond_chance = false;     ///< the emptiest disc is beyond chance and not excused
  bool unsupported = false;       ///< it is by the margin, too
  bool transparent = false;       ///< more rays pass through it than stray
};

struct Evidence {
  std::vector<PolygonEvidence> polygons;  ///< in the model's order
  std::int64_t readings = 0;              ///< at different places
  std::int64_t explained = 0;             ///< of them, those on a polygon, within tolerance of it
  std::int64_t rays = 0;                  ///< followed; 0: the scan says no ranges
  /// The most readings expected in an empty disc that chance explains.
  double chance = 0;
  std::int64_t beyond_chance = 0, unsupported = 0, transparent = 0;  ///< polygons
  double empty_area = 0;                                             ///< over all polygons
  int emptiest = -1;                                                 ///< index of the polygon; −1: none

  double explained_share() const;
  bool within_bounds() const { return unsupported == 0 && transparent == 0; }
};

/// The most readings expected in an empty disc that chance explains among m readings: the a at which
/// 2m(1 + a)e^(−a), the expected number of maximal empty discs in a Poisson stream, comes to kDiscsByChance.
double most_by_chance(std::int64_t readings);

/// Judges the polygons of a model by the readings of its scan; axes are unit vectors. Readings at the same
/// place to the last bit are one.
///
/// A reading lies on a polygon whose outward normal is against its sensing axis, when it is within tolerance
/// of the plane (the larger of the model's tolerance and three standard deviations) and projects into the
/// polygon or within λ of its perimeter. What becomes of support, of the share explained and of the rays, and
/// why: docs/evidence.md. The same input gives the same figures, in any order of the readings. Throws
/// std::invalid_argument when the model's λ is not positive.
Evidence judge_evidence(const model::ModelRecord& model, std::vector<model::SensorPoint> readings);

}  // namespace limpet::evaluation
