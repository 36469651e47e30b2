// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limpet/evaluation/arm_reachable.hpp>
#include <limpet/evaluation/clearance.hpp>
#include <limpet/evaluation/coverage.hpp>
#include <limpet/evaluation/offline_tour.hpp>
#include <limpet/evaluation/reachable.hpp>
#include <limpet/evaluation/reachable_topology.hpp>
#include <limpet/evaluation/unreachable.hpp>
#include <limpet/model/record.hpp>
#include <limpet/simulation/mesh.hpp>
#include <optional>
#include <vector>

namespace limpet::evaluation {

/// What a simulated run leaves to be judged.
struct FollowingRun {
  std::vector<Eigen::Vector3d> path;  ///< the control point at each set, in order, in the world
  model::ModelRecord model;           ///< as the run left it
  std::vector<GivenUp> marks;         ///< edges that the run has given up
};

/// How a run was made, and how it is to be judged. Lengths in the scan's unit.
struct RunJudgementOptions {
  double resolution = 0;       ///< λ; > 0
  double follow_distance = 0;  ///< δ; > λ
  double ceiling = 0;          ///< γ: the longest step; > 0 if there is to be a tour
  Sensing sensing;             ///< of a point robot
  double spacing = 0;          ///< of the samples of the truth; 0: λ/4
  double pitch = 0;            ///< of free space; 0: (δ − λ)/2
  bool tour = false;           ///< compare with an offline tour, which takes longer than all the rest
  /// The robot, if it is an arm: what it can feel is sought as by ArmReach, at about `arm_samples` of
  /// the truth, and near marks at samples λ/4 apart (of those at most twice as many). `spacing` and `pitch`
  /// do not count then, of `sensing` only the largest incidence, and there is no tour.
  std::optional<PlacedArm> arm;
  std::size_t arm_samples = 1000;
  SearchProgress progress = {};  ///< of each search for what the arm can feel; empty: nobody is told
};

/// A run, judged by the truth (thesis chapter 4 has no such figures; they are this project's).
struct RunJudgement {
  double coverage = 0;         ///< of the area that is reachable, the share within λ of the model
  double coverage_total = 0;   ///< of the whole area
  double reachable_share = 0;  ///< of the whole area
  double doubtful_share = 0;   ///< of the whole area, what the search could not tell (see Verdict)
  std::size_t sets = 0;
  double path_length = 0;
  std::size_t collisions = 0;          ///< steps that touch or cross the truth
  double clearance_control_point = 0;  ///< smallest distance at and along the steps
  std::size_t worst_step = 0;          ///< the position that the nearest step starts from
  std::size_t false_unreachable = 0;   ///< marks that the offline search contradicts
  bool isomorphic = false;             ///< to the truth, over the faces that are reachable: see `topology`
  std::optional<OfflineTour> tour;     ///< if asked for

  // What the figures are made from:
  PathClearance clearance;
  Reachability reachability;
  Coverage covered;
  FalseUnreachable marks;
  ReachableTopology topology;
};

/// Judges a run by the mesh that it took place over. It shares no code with the follower. Throws
/// std::invalid_argument if an option is out of range, or there is no position.
RunJudgement judge_run(const simulation::Mesh& truth, const FollowingRun& run,
                       const RunJudgementOptions& options);

}  // namespace limpet::evaluation
