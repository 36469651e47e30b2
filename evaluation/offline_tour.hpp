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
};

/// What the same robot would need if it knew the true surface beforehand: a yardstick for a run.
struct OfflineTour {
  std::vector<Eigen::Vector3d> positions;  ///< in the order of the tour; the first is the start
  std::size_t sets = 0;                    ///< positions where readings are taken: all but the start
  double path_length = 0;                  ///< of the tour through them
  std::size_t transit_steps = 0;  ///< steps between them at which no set is needed: Σ ⌈leg/γ⌉ − 1
  double unlinked = 0;  ///< share of the reachable area that no candidate's readings come near enough to
};

/// Looks for few positions from which the robot would model all that is reachable, and for a short tour.
///
/// *Candidates* are the positions δ above the reachable samples, along the outward normal, one for every
/// second sample or so (samples λ/4 apart: candidates about λ/2 apart); where free space does not hold that
/// position, one that the sample is seen from instead.
///
/// *What modelling needs.* A polygon grows over readings that link within λ, some three per λ² (DESIGN §8).
/// So each true face is cut by a square grid of pitch λ, and each square asks for three times as many
/// readings as its reachable area is of λ², rounded. After that each reachable sample asks for a reading on
/// its face within 0.9 λ. What no candidate can give is not asked for.
///
/// *The choice* is greedy (greedy_cover()) for the first, and then for what the second still asks for. The
/// *tour* is short_tour() from the start. All of it is deterministic, and neither is the best there is: fewer
/// sets may do, and surfaces that are felt by chance count in a run, too.
OfflineTour offline_tour(const simulation::Mesh& mesh, const TrueSurface& truth, const FreeSpace& space,
                         const Reachability& reachability, const Sensing& sensing,
                         const TourOptions& options);

}  // namespace limpet::evaluation
