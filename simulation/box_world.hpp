// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limpet/simulation/mesh.hpp>
#include <vector>

namespace limpet::simulation {

/// A solid made of axis-aligned boxes, added and carved in order. Space is cut into cells at the coordinates
/// that occur, so the cost is (boxes)³: for tens of boxes.
class BoxWorld {
 public:
  /// Precondition: low < high in every coordinate.
  void add(const Eigen::Vector3d& low, const Eigen::Vector3d& high) { boxes_.push_back({low, high, true}); }
  void carve(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    boxes_.push_back({low, high, false});
  }

  /// Which quads of the surface to keep, by their middle and outward normal.
  using Filter = std::function<bool(const Eigen::Vector3d& middle, const Eigen::Vector3d& normal)>;

  /// The surface between solid and empty, its normals pointing into the empty. Every quad between two cells
  /// is two triangles, so the triangles meet edge to edge.
  Mesh surface(const Filter& keep = {}) const;

 private:
  struct Box {
    Eigen::Vector3d low, high;
    bool solid;
  };
  std::vector<Box> boxes_;
};

}  // namespace limpet::simulation
