// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <limits>
#include <limpet/evaluation/free_space.hpp>
#include <limpet/evaluation/true_surface.hpp>
#include <utility>
#include <vector>

namespace limpet::evaluation {

/// Ways between places in free space: each place is joined to some of its nearest, straight.
class RoadMap {
 public:
  struct Road {
    std::size_t to;
    double length;
  };

  RoadMap(const std::vector<Eigen::Vector3d>& places, const TrueSurface& truth, const FreeSpace& space);

  /// The roads that lead out of a place, the shortest first.
  const std::vector<Road>& roads(std::size_t place) const { return roads_[place]; }

  /// Length of the way between two places, straight if that keeps the clearance; infinite if it is `limit` or
  /// more.
  double length(std::size_t a, std::size_t b, double limit = std::numeric_limits<double>::infinity()) const;

  /// The nearest place over roads for which `wanted` holds, and how far it is; itself if there is none.
  Road nearest(std::size_t from, const std::function<bool(std::size_t)>& wanted, double limit) const;

 private:
  void join_near();
  void join_components();
  std::vector<std::size_t> component_of() const;
  void add(std::size_t a, std::size_t b, double length);

  const std::vector<Eigen::Vector3d>& places_;
  const TrueSurface& truth_;
  const FreeSpace& space_;
  std::vector<std::vector<Road>> roads_;
};

}  // namespace limpet::evaluation
