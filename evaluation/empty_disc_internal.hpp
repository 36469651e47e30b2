// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/evaluation/flat_polygon_internal.hpp>
#include <limpet/evaluation/local_density_internal.hpp>
#include <limpet/evaluation/resolution_field_internal.hpp>
#include <memory>
#include <vector>

namespace limpet::evaluation {

/// A disc in the plane of a polygon that holds none of its readings.
struct FlatDisc {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0;
  double expected = 0;   ///< readings in its part inside the polygon
  bool excused = false;  ///< the resolution explains it
};

/// What explains an empty disc, however dense the readings: gaps below λ are not represented, so that one
/// inside the polygon may have a radius of λ; and a perimeter may run λ beside its readings, its corners √2
/// λ.
class Excuse {
 public:
  /// Both outlive it. Excused discs count for no more than `chance` readings, the most that chance explains
  /// anyway.
  Excuse(const ResolutionField& resolution, const FlatPolygon& polygon, double chance)
      : resolution_(resolution), polygon_(polygon), chance_(chance) {}
  double chance() const { return chance_; }
  /// `share` of the disc is inside the polygon.
  bool holds(const Eigen::Vector2d& centre, double radius, double share) const {
    constexpr double kWhole = 0.99, kCorner = 1.4142135623730951;
    return radius <= (share > kWhole ? 1 : kCorner) * resolution_.at(polygon_.raised(centre));
  }

 private:
  const ResolutionField& resolution_;
  const FlatPolygon& polygon_;
  double chance_;
};

/// The discs that readings on a polygon leave empty. Polygon and density outlive it.
class EmptyDiscs {
 public:
  /// Precondition: there is a reading.
  EmptyDiscs(const std::vector<Eigen::Vector2d>& readings, const FlatPolygon& polygon,
             const LocalDensity& density);
  ~EmptyDiscs();
  EmptyDiscs(EmptyDiscs&&) noexcept;
  EmptyDiscs& operator=(EmptyDiscs&&) noexcept;

  /// The disc that should hold the most readings, where an excused one counts for no more than chance
  /// explains. Its centre is a circumcentre of a Delaunay triangle inside the polygon, or one of the places
  /// along the `perimeter`: a radius there may be short by half of what these are apart. The density is the
  /// least at the readings on the disc's rim.
  FlatDisc emptiest(const std::vector<Eigen::Vector2d>& perimeter, const Excuse& excuse) const;

  /// The reading nearest to a place.
  Eigen::Vector2d nearest(const Eigen::Vector2d& place) const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace limpet::evaluation
