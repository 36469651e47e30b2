// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <limpet/following/follower.hpp>
#include <limpet/model/model.hpp>

namespace limpet::following {

/// A point robot that follows a shape (simulation/shapes.hpp), as `limpet follow` has it.
struct RunOptions {
  std::string shape = "cube";
  double resolution = 0.05;
  double noise = 0;  ///< standard deviation of a reading along its axis
  Strategy strategy = Strategy::thesis;
  std::uint64_t seed = 1;  ///< of the start, the heading and the noise
  int most_sets = 60000;
  bool random_heading = true;  ///< or along the axes
  double reach = 1;            ///< δ, σ_max and the sensing range, over what they usually are
  std::vector<int> known;      ///< faces of the mesh that are given as initial model segments
};

struct RunResult {
  End end = End::none;  ///< none: it did not end by itself
  int sets = 0;
  std::int64_t polygons = 0;
  std::int64_t open_edges = 0;  ///< after Model::finish()
  std::int64_t confirmed = 0;   ///< readings on known faces
  double clearance = 0;         ///< smallest distance of the control point's way from the mesh
  /// Smallest distance of a motion from the model that it was chosen by.
  double model_clearance = std::numeric_limits<double>::infinity();
  /// By how much a motion came nearer to that model than δ − λ, or than its start if this was nearer already;
  /// the largest.
  double encroachment = 0;
  std::array<std::int64_t, kModeCount> sets_by_mode{};
  std::vector<Eigen::Vector3d> places;  ///< of the control point, at each set
  std::vector<std::size_t> stuck_sensors;

  bool closed() const { return polygons > 0 && open_edges == 0; }
};

RunResult run_following(const RunOptions&,
                        const std::function<void(const Observation&, const Motion&)>& watch = {});

/// Expects that a run ended by itself with a closed model of so many polygons, that no motion encroached on
/// what it was to keep off, and that the truth was never nearer than this part of δ − λ.
void expect_good(const RunResult&, std::int64_t polygons, double least_clearance_share);

/// The last motion of a follower that is told the same readings at the same place, (0, 0, 0.1), for up to
/// `sets` sets.
Motion motion_at_rest(Strategy, const std::vector<model::SensorPoint>& readings, int sets, model::Model&);

}  // namespace limpet::following
