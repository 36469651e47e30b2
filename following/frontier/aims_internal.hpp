// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/following/clearance.hpp>
#include <limpet/following/parameters.hpp>
#include <limpet/kinematics/posture.hpp>
#include <limpet/model/view.hpp>
#include <optional>
#include <vector>

#include "new_ground_internal.hpp"
#include "outlook_internal.hpp"

namespace limpet::following::internal {

/// A place for the control point from which a sensing axis goes through a target.
struct Aim {
  Eigen::Vector3d place;
  Target target;
  double value = 0;  ///< what the readings there are worth, over the root of the steps to get there
};

/// Chooses the place to take the next readings from: places that put a sensing axis exactly through a target
/// near by are compared by the targets and the new ground that all axes meet there.
class AimChooser {
 public:
  /// `step`: how far the control point moves in one step.
  AimChooser(const Parameters& parameters, const kinematics::Posture&, double step);

  /// The best aim that the control point can go to in a straight line, with some room to spare if there is
  /// such an aim, else keeping clear; none if there is none.
  std::optional<Aim> choose(const model::View&, const Clearance&, const Outlook&);
  /// Where an axis, from the present place, meets new ground within this range.
  std::vector<Eigen::Vector3d> expected_along(std::size_t axis, const Outlook&, double range);

 private:
  struct Axis {
    Eigen::Vector3d offset, axis;  ///< from the control point; unit vector
    double range;
  };
  /// What is expected in one plane.
  struct Plane {
    Eigen::Vector3d normal;
    double height;
    std::vector<std::size_t> targets;
    NewGround ground;
  };

  void sort_into_planes(const Outlook&);
  Plane& plane_at(const Eigen::Vector3d& place, const Eigen::Vector3d& normal);
  struct Search;

  std::optional<Aim> choose(const model::View&, const Clearance&, const Outlook&, const Search&);
  void add_candidates(const std::vector<Target>&, const Search&);
  void add_candidates(const Target&, const Search&);
  double worth(const Eigen::Vector3d& place, const Outlook&, double grazing);
  double worth(const Plane&, const Eigen::Vector3d& meets, const Outlook&);
  /// Can the control point go there, keeping `margin` times the clearance, and does it see the target from
  /// there?
  bool is_good(const model::View&, const Clearance&, const Aim&, double margin) const;

  double lambda_, height_, step_;
  Eigen::Vector3d here_;
  std::vector<Axis> axes_;
  std::vector<Plane> planes_;
  std::vector<Aim> candidates_;
  std::vector<int> met_;  ///< per target: the number of the last place from which it was met
  int place_number_ = 0;
};

}  // namespace limpet::following::internal
