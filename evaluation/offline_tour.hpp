// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limpet/evaluation/free_space.hpp>
#include <limpet/evaluation/reachable.hpp>
#include <limpet/evaluation/true_surface.hpp>
#include <limpet/simulation/mesh.hpp>
#include <vector>

namespace limpet::evaluation {

struct TourOptions {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();  ///< where the robot begins
  double resolution = 0;                            ///< λ; > 0
  double follow_distance = 0;                       ///< δ; > λ
  double max_step = 0;                              ///< γ: the longest step; > 0
  double density = 3;  ///< readings that modelling needs per λ²; 0: only that all is linked
};

/// What the same robot would need if it knew the true surface beforehand: a yardstick for a run.
struct OfflineTour {
  /// In the order of the tour, the start first. Where free space does not hold the start, because it is too
  /// near to the surface, the tour begins at the position nearest to it.
  std::vector<Eigen::Vector3d> positions;
  std::size_t sets = 0;           ///< positions where readings are taken: all but the start
  double path_length = 0;         ///< of the tour through them
  std::size_t transit_steps = 0;  ///< steps between them at which no set is needed: Σ ⌈leg/γ⌉ − 1
  double unlinked = 0;  ///< share of the reachable area that no candidate's readings come near enough to
};

/// Looks for few positions from which the robot would model all that is reachable, and for a short tour.
///
/// *Candidates* are the places of free space's lattice at the follow distance δ from the surface, give or
/// take half a pitch. For reachable samples, one for each (λ/2)², that have no free place δ above them, a
/// place that they are seen from is one, too.
///
/// *What modelling needs.* A polygon grows over readings that link within λ, some three per λ².
/// So each true face is cut by a square grid of pitch 2λ, and each square asks for `density` times as many
/// readings as its reachable area is of λ², rounded. After that each reachable sample asks for a reading on
/// its face within 0.9 λ. What no candidate can give is not asked for.
///
/// *The choice* is greedy (greedy_cover()) for the first, and then for what the second still asks for. The
/// *tour* is short_tour() from the start. Everything is deterministic.
///
/// It is no lower bound: greedy choice is not the best, lower positions see more, and a robot that takes a
/// set at every step feels much on its way. A run that senses at every step is fairly compared by its path's
/// length, and its sets lie between `sets` and `sets` + `transit_steps` when it is as good as the tour.
///
/// On a cube of side 1 (λ 0.05, δ 0.1, γ 0.05, range 0.2): 1064 sets, 423 transit steps, path 49 with the
/// sensors along the cube's axes; 1255, 523 and 60 with another heading. There the sets alone made a closed,
/// isomorphic model with density 3, and with density 2 (870 sets, path 57); with density 1 (549, 49) or 0
/// (423, 45) only together with readings taken on the way.
OfflineTour offline_tour(const simulation::Mesh& mesh, const TrueSurface& truth, const FreeSpace& space,
                         const Reachability& reachability, const Sensing& sensing,
                         const TourOptions& options);

}  // namespace limpet::evaluation
