// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/following/links/link_guard.hpp>
#include <limpet/following/links/task.hpp>
#include <limpet/kinematics/quadratic_program.hpp>
#include <limpet/kinematics/redundancy.hpp>
#include <span>
#include <vector>

namespace limpet::following {

/// The quadratic programme of a step: moves the control point, or another point, as asked, as far as links
/// may near what they are kept off (Faverjon & Tournassoud 1987; Kanehiro et al. 2008).
///
///     minimise ½ ‖J Δq − v‖² + ½ μ² ‖Δq‖² − κ z·Δq
///     such that n·J_l Δq ≥ −ξ (d − d_s) for each part l of the body and each obstacle near it, the same for
///     pairs of parts, n·J_l Δq ≥ 0 for each proximity switch that sees something else, n from the centre of
///     its field to it, and joint limits and ceilings are kept.
class StepProgramme {
 public:
  /// The guard must outlive it.
  StepProgramme(const LinkGuard&, const LinkParameters&);

  /// The changes for a task, as that of moving the control point, within the robot's limits and ceilings, not
  /// yet checked. Where no changes lead all of what is too near away, none of it comes nearer. `seeing`:
  /// numbers of the robot's switches that see what is not among these obstacles.
  kinematics::Configuration changes(const kinematics::Posture&, const Task&, const Obstacles&,
                                    std::span<const std::size_t> seeing = {});

 private:
  void aim(const kinematics::Posture&, const Task&, const Eigen::VectorXd& z);
  void bound(const kinematics::Posture&);
  void keep_off(const kinematics::Posture&);
  void keep_apart(const kinematics::Posture&);
  void keep_from_fields(const kinematics::Posture&, std::span<const std::size_t> seeing);
  void add_row(const Eigen::RowVectorXd& away, double distance, double least);
  kinematics::Configuration solve();

  const LinkGuard& guard_;
  LinkParameters parameters_;
  kinematics::QuadraticProgram problem_;
  kinematics::QuadraticSolver solver_;
  std::vector<kinematics::Proximity> near_;
  std::vector<double> hold_;  ///< of each row: what is asked where all that is too near cannot be led away
};

}  // namespace limpet::following
