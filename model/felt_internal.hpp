// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <tuple>
#include <vector>

#include <limpet/geometry/chart.hpp>
#include <limpet/geometry/polygon.hpp>

#include "setting_internal.hpp"

namespace limpet::model::internal {

/// Where a polygon has been felt: its perimeter as the readings left it, before finish() added what none of
/// them lies in. What is added later is judged by its distance from here, not from what was added before.
class Felt {
 public:
  struct Part {
    geometry::Chart chart;
    geometry::Polygon perimeter;
    std::int64_t points = 0;  ///< readings that it stands for
    double area = 0;          ///< area_felt(), scan's unit squared
    double thinning = 1;      ///< mean over the area of the square of the least λ over λ
  };

  Felt() = default;
  /// `points`: how many readings the perimeter stands for.
  Felt(const Setting&, const geometry::Chart&, const geometry::Polygon&, std::int64_t points);

  /// The felt parts of a polygon that has merged into this one. The two may have been one before, and cut in
  /// two: parts that both have count once.
  void add(Felt&& other);
  /// A reading that has extended the perimeter since.
  void add(const Eigen::Vector3d& p) { readings_.push_back(p); }

  /// How far a place in the plane is from the nearest that was felt, 0 inside; `within` if that is nearer.
  double distance(const Eigen::Vector3d& p, double within) const;
  /// Readings to a unit of area of the felt parts and half the space between two readings around them.
  /// Where λ grows with the range readings are as many to λ² everywhere; `thinning` is the square of the
  /// least λ over that of the place.
  double density(double thinning = 1) const;
  /// Has finish() added anything to the polygon?
  bool is_all() const { return !added_to_; }
  void note_addition() { added_to_ = true; }

  const std::vector<Part>& parts() const { return parts_; }
  /// For the archive.
  auto members() { return std::tie(parts_, readings_, added_to_); }
  auto members() const { return std::tie(parts_, readings_, added_to_); }

 private:
  std::vector<Part> parts_;
  std::vector<Eigen::Vector3d> readings_;
  bool added_to_ = false;
};

/// The same of a polygon all of which was felt: the distance to it, and the area that its readings stand for.
double distance_to(const geometry::Chart&, const geometry::Polygon&, const Eigen::Vector3d& p, double within);
double area_felt(const geometry::Chart&, const geometry::Polygon&, std::int64_t points);

}  // namespace limpet::model::internal
