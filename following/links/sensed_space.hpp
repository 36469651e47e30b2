// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limpet/following/observation.hpp>
#include <limpet/kinematics/body.hpp>
#include <span>
#include <unordered_set>

namespace limpet::following {

/// The part of space that was seen to be free: cubic cells that a ray went through before it met anything,
/// that the axis of a proximity switch went through while it saw nothing, or that a link was in. What
/// fits between two rays of neighbouring sensors is not seen: it is sensed in the sense of the cells' size.
/// Memory goes with the space that the robot has been near, not with time.
class SensedSpace {
 public:
  /// `cell`: side of a cell, scan's unit, > 0.
  explicit SensedSpace(double cell) : cell_(cell) {}

  /// What a set has told, and where the body is. `beside`: as of free_range().
  void add(const Observation&, std::span<const kinematics::BodyPart> body, double beside);
  bool holds(const Eigen::Vector3d& place) const { return cells_.contains(key_of(place)); }
  /// Does it hold the capsule (world), its axis and its surface, as far as places about a cell apart tell?
  bool holds(const model::Capsule&) const;
  std::size_t cells() const { return cells_.size(); }

 private:
  std::uint64_t key_of(const Eigen::Vector3d&) const;
  void add_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
  bool holds_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  int pieces_of(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  double cell_;
  std::unordered_set<std::uint64_t> cells_;
};

}  // namespace limpet::following
