// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limpet/evaluation/free_space.hpp>
#include <limpet/evaluation/true_surface.hpp>
#include <vector>

namespace limpet::evaluation {

/// An open path that visits places.
struct ShortTour {
  std::vector<std::size_t> order;   ///< indices of the places; the first one is 0
  std::vector<double> legs;         ///< length of the way to each place but the first
  std::vector<std::size_t> lonely;  ///< places that no way leads to; they are not visited
};

/// A short path through free space from places[0] through all others, and no way back: by nearest neighbour,
/// then 2-opt until nothing is gained. A leg is straight where that keeps the clearance; else it runs over a
/// graph whose nodes are the places: each joined straight to some of the nearest ones, and what does not hang
/// together then by ways over the lattice (FreeSpace::way()). Not the shortest there is: on open ground 2-opt
/// is some 5 % above it. Precondition: `space` holds all places without doubt.
ShortTour short_tour(const std::vector<Eigen::Vector3d>& places, const TrueSurface& truth,
                     const FreeSpace& space);

}  // namespace limpet::evaluation
