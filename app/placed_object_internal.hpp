// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/evaluation/true_surface.hpp>
#include <limpet/model/view.hpp>
#include <limpet/simulation/mesh.hpp>
#include <limpet/simulation/world_description.hpp>

namespace limpet::app::internal {

/// What an arm is placed beside: all of the object that is known. That is its mesh, where there is one; of a
/// range image from a file, the points of the image and the faces that are given beforehand (a hole in one of
/// them is taken to be filled). World frame, scan's unit.
class PlacedObject {
 public:
  /// `grain`: what is small against the distances that matter, > 0; a point becomes a triangle of that size.
  PlacedObject(const simulation::BuiltWorld&, double grain);

  const simulation::Bounds& bounds() const { return bounds_; }
  /// Distance of a capsule's surface from the object; negative when they overlap.
  double distance(const model::Capsule& capsule) const {
    return surface_.distance_along(capsule.a, capsule.b) - capsule.radius;
  }

 private:
  explicit PlacedObject(const simulation::Mesh&);

  simulation::Bounds bounds_;
  evaluation::TrueSurface surface_;
};

}  // namespace limpet::app::internal
