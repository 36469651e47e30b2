// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <tuple>
#include <vector>

namespace limpet::model::internal {

/// Where readings have passed through a polygon's plane on their way from the sensor, near the polygon:
/// nothing can be there (rule `rays`).
class Passages {
 public:
  struct Place {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< world; where the first of them passed
    std::int64_t count = 0;                        ///< of readings within `apart` of it
  };

  /// A reading has passed at p. A few places are kept, at least `apart` from each other.
  void add(const Eigen::Vector3d& p, double apart);
  /// Those of a polygon that has merged into this one. What has passed near both was noted with both, and
  /// counts once.
  void add(const Passages& other, double apart);
  /// Hands the places there to the passages of a part that is cut off, with `share` of the readings that have
  /// passed through. The counts add up to what they were.
  Passages split(const std::function<bool(const Eigen::Vector3d&)>& there, double share);
  /// A reading that stands for so many has passed through the polygon itself, not beside it or in a hole.
  void note_through(std::int64_t readings) { ++rays_, through_ += readings; }

  const std::vector<Place>& places() const { return places_; }
  std::int64_t rays() const { return rays_; }
  std::int64_t through() const { return through_; }
  /// For the archive.
  auto members() { return std::tie(places_, rays_, through_); }
  auto members() const { return std::tie(places_, rays_, through_); }

 private:
  /// The count of the place that is within `apart` of p, or of a new one; null: there are too many.
  std::int64_t* count_at(const Eigen::Vector3d& p, double apart);

  std::vector<Place> places_;
  std::int64_t rays_ = 0, through_ = 0;
};

}  // namespace limpet::model::internal
