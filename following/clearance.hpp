// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

#include <limpet/following/recent_readings.hpp>
#include <limpet/model/sensor_point.hpp>
#include <limpet/model/view.hpp>

namespace limpet::following {

/// Keeps the control point off the surface: off the model, and off recent raw readings, which the model may
/// smooth away or not have joined to a polygon yet.
class Clearance {
 public:
  /// `least`: the distance to be kept, > 0.
  explicit Clearance(double least) : least_(least) {}

  double least() const { return least_; }

  /// Remembers a set of readings as obstacles, and forgets the set 80 sets ago.
  void remember(std::span<const model::SensorPoint> readings) { recent_.add(readings); }

  /// Distance from a place to the nearest obstacle, or `reach` when there is none that near.
  double at(const model::View&, const Eigen::Vector3d& place, double reach) const;
  /// The same for the whole way from a to b.
  double along(const model::View&, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double reach) const;
  /// Does the straight way keep the distance, or come no nearer to anything than its start, if this is
  /// nearer?
  bool is_clear(const model::View&, const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  /// Places where surface is suspected: instead of those before.
  void suspect(std::vector<Eigen::Vector3d> places) { suspected_ = std::move(places); }
  /// For plans: does the straight way keep this distance, from suspected places, too?
  bool is_safe(const model::View&, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
               double distance) const;

  /// The longest of motion, motion/2, motion/4, … that is clear from this place; zero when none is.
  Eigen::Vector3d shortened(const model::View&, const Eigen::Vector3d& from, Eigen::Vector3d motion) const;

 private:
  bool keeps(const model::View&, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
             double distance) const;

  double least_;
  RecentReadings recent_;
  std::vector<Eigen::Vector3d> suspected_;
};

}  // namespace limpet::following
