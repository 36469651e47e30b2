// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limpet/evaluation/true_surface.hpp>
#include <vector>

namespace limpet::evaluation {

/// Places of a cubic lattice around a surface, each the middle of a cell, with flags that say how far from
/// the surface they are and whether the robot gets there. Kept in bricks of 8³; a brick that is far from the
/// surface, or deep within a solid, is one set of flags.
class Lattice {
 public:
  using Node = Eigen::Vector3i;
  using Flags = std::uint8_t;

  static constexpr Flags kPassable = 1;  ///< its distance is at least the clearance
  static constexpr Flags kRoomy = 2;     ///< so is that of every place within half a pitch
  static constexpr Flags kPossible = 4;  ///< some place in its cell may have that distance
  static constexpr Flags kReached = 8;   ///< the start is joined to it by a way that keeps the clearance
  static constexpr Flags kPerhapsReached = 16;  ///< such a way is not ruled out

  /// Covers the box from low to high, and fills in the first three flags. Preconditions: clearance and pitch
  /// above zero, low ≤ high.
  Lattice(const TrueSurface&, const Eigen::Vector3d& low, const Eigen::Vector3d& high, double clearance,
          double pitch);

  double pitch() const { return pitch_; }
  Eigen::Vector3d place(const Node& node) const { return low_ + pitch_ * node.cast<double>(); }
  /// The node whose cell a place is in; of a place outside the box, one at its border.
  Node nearest(const Eigen::Vector3d& place) const;
  bool contains(const Node& node) const {
    return (node.array() >= 0).all() && (node.array() < 8 * bricks_.array()).all();
  }
  /// A number for each node. Precondition, here and below: contains(node).
  std::int64_t index(const Node& node) const { return brick_index(node) * 512 + inner_index(node); }
  Flags flags(const Node& node) const;
  /// Sets a flag at a node, and where its brick is one set of flags, at all of them.
  void mark(const Node& node, Flags flag);

  /// Goes through the pairs of face neighbours that lead out of a node, or out of its brick if this is one
  /// set of flags.
  void leave(const Node& node, const std::function<void(const Node& from, const Node& to)>& visit) const;

  /// Goes through all nodes that have a flag and may be nearer to the surface than `within`.
  void for_each(const TrueSurface&, Flags flag, double within,
                const std::function<void(const Node&)>& visit) const;

 private:
  using Brick = std::array<Flags, 512>;
  static constexpr std::int32_t kUniform = -1;

  std::int64_t brick_index(const Node& node) const {
    const Node b = node / 8;
    return (static_cast<std::int64_t>(b.z()) * bricks_.y() + b.y()) * bricks_.x() + b.x();
  }
  static std::int64_t inner_index(const Node& node) {
    return (node.z() % 8 * 8 + node.y() % 8) * 8 + node.x() % 8;
  }
  void fill(const TrueSurface& truth, const Node& first, int size);
  void fill_brick(const TrueSurface& truth, const Node& first);
  Flags at_distance(double distance) const;

  Eigen::Vector3d low_;
  double clearance_, pitch_;
  Node bricks_;                         ///< how many along each axis
  std::vector<std::int32_t> dense_of_;  ///< index of each brick's flags in `dense_`, or kUniform
  std::vector<Flags> uniform_;          ///< flags of each uniform brick
  std::vector<Brick> dense_;
};

}  // namespace limpet::evaluation
