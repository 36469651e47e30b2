// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include <limpet/geometry/types.hpp>
#include <limpet/model/changes.hpp>

namespace limpet::following {

/// What a follower is after, for who looks on. Places are in the world, in the scan's unit. What a strategy
/// does not know of, or is not busy with, is absent.
struct Intent {
  /// A place that a sensing axis is to go through, and the control point's place that makes it do so.
  struct Aim {
    Eigen::Vector3d target, place;
  };

  std::vector<Eigen::Vector3d> targets;  ///< places where surface is expected, near the control point
  std::optional<Aim> aim;                ///< the target whose turn it is
  std::vector<Eigen::Vector3d> way;      ///< places to go over, the next one first
  geometry::EdgeId edge;                 ///< the current edge (thesis §3.4.2)
  model::SegmentId segment;              ///< the current segment (thesis §3.4.1)
  /// The two lines that bound the current slice near the current point (thesis §3.4.3), each by its ends.
  std::optional<std::array<std::array<Eigen::Vector3d, 2>, 2>> slice;
};

}  // namespace limpet::following
