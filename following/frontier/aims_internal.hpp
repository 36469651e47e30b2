// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <functional>
#include <limpet/following/clearance.hpp>
#include <limpet/following/parameters.hpp>
#include <limpet/kinematics/posture.hpp>
#include <limpet/model/view.hpp>
#include <optional>
#include <vector>

#include "expected_planes_internal.hpp"
#include "outlook_internal.hpp"

namespace limpet::following::internal {

/// A place for the control point from which a sensing axis goes through a target.
struct Aim {
  Eigen::Vector3d place;
  Eigen::Vector3d sensor;  ///< the place of the axis's sensor, from the control point
  std::size_t axis = 0;    ///< the number of the sensor
  Target target;
  double value = 0;  ///< what the readings there are worth, over the root of the steps to get there
};

/// Chooses the place to take the next readings from: places that put a sensing axis exactly through a target
/// near by are compared by the targets and the new ground that all axes meet there.
class AimChooser {
 public:
  /// The posture in which the robot comes to a place, if it can take its control point there.
  using Reaching = std::function<std::optional<kinematics::Posture>(const Eigen::Vector3d& place)>;

  /// `step`: how far the control point moves in one step. `reaching`: asked about few of the best places;
  /// none: it reaches all, without turning.
  AimChooser(const Parameters& parameters, const kinematics::Posture&, double step, Reaching reaching = {});

  /// The best aim that the control point can go to in a straight line, with some room to spare if there is
  /// such an aim, else keeping clear, and that the robot reaches; none if there is none.
  std::optional<Aim> choose(const model::View&, const Clearance&, const std::vector<Target>&,
                            ExpectedPlanes&);

 private:
  struct Search;

  std::optional<Aim> choose(const model::View&, const Clearance&, const std::vector<Target>&, ExpectedPlanes&,
                            const Search&);
  void add_candidates(const std::vector<Target>&, const Search&);
  void add_candidates(const Target&, const Search&);
  /// Can the control point go there, keeping `margin` times the clearance, and does the sensor see the target
  /// from there?
  bool is_good(const model::View&, const Clearance&, const ExpectedPlanes&, const Aim&, double margin) const;

  std::optional<Aim> reached(const Aim&, const Search&, const std::function<bool(const Aim&)>& is_good);

  double lambda_, height_, step_;
  Eigen::Vector3d here_;
  std::vector<Ray> axes_;             ///< from the control point as origin
  std::vector<std::size_t> sensors_;  ///< of the axes
  Reaching reaching_;
  int asked_ = 0;                              ///< times that it was asked
  std::vector<Eigen::Vector3d> out_of_reach_;  ///< places
  std::vector<Aim> candidates_;
};

}  // namespace limpet::following::internal
