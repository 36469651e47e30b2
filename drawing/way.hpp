// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/drawing/sheet.hpp>
#include <vector>

namespace limpet::drawing {

/// A straight line between two places (pixels of the panel, with depth), as short pieces; a dot where both
/// are one.
void add_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double width, const io::Color& color,
              Panel& panel);

/// A way through these places (pixels of the panel, with depth), as short pieces and a dot at each place,
/// with a larger one where it begins and where it ends. It changes its colour as it goes on, from kWayBegins
/// to kWayEnds at the last of `whole` places, of which these may be the first ones.
void add_way(const std::vector<Eigen::Vector3d>& places, std::size_t whole, Panel& panel);

/// Tells which places of a panel its faces hide.
class Hiding {
 public:
  /// The panel must outlive it.
  explicit Hiding(const Panel&);
  bool hides(const Eigen::Vector3d& place) const;

 private:
  struct Cover {
    Eigen::Vector3d low, high;
    const Patch* patch;
    std::vector<Eigen::Vector3d> points;  ///< of all outlines, for the triangles
  };
  std::vector<Cover> covers_;
};

}  // namespace limpet::drawing
