// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/evaluation/true_surface.hpp>
#include <limpet/simulation/mesh.hpp>
#include <memory>
#include <vector>

namespace limpet::evaluation {

/// What a search on a lattice can say.
enum class Verdict {
  no,        ///< ruled out, however fine the lattice
  doubtful,  ///< the lattice is too coarse to tell
  yes        ///< there is one, and it was found
};

struct FreeSpaceOptions {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();  ///< where the robot begins
  double clearance = 0;  ///< δ − λ: the smallest distance from the surface that the robot may keep; > 0
  double margin = 0;     ///< how far from the mesh's bounding box places are asked for; ≥ 0
  double pitch = 0;      ///< of the lattice; 0: half the clearance. At most 0.7 of the clearance
};

/// Where a point robot can get to: the part of space that keeps a distance from the true surface and is
/// connected to the start.
///
/// Connections are looked for on a cubic lattice, twice. Ways along its edges, each checked exactly, *prove*
/// that a place can be got to. Where not even the cells that may hold a free place are connected, it is
/// *ruled out*: for a way that keeps the clearance passes from cell to cell. What lies between is doubtful:
/// passages that are wider than the clearance asks by less than some pitches. The places themselves are
/// measured exactly.
///
/// A start that is nearer to the surface than the clearance is joined to places around it that it gets to
/// without coming nearer. Outside the margin space counts as the border there.
class FreeSpace {
 public:
  /// Keeps a reference to the surface. Throws std::invalid_argument if an option is out of range, or the
  /// lattice would have more than some 10¹⁰ places.
  FreeSpace(const TrueSurface&, const simulation::Bounds&, const FreeSpaceOptions&);
  ~FreeSpace();
  FreeSpace(FreeSpace&&) noexcept;
  FreeSpace& operator=(FreeSpace&&) noexcept;

  double clearance() const;
  double pitch() const;

  /// Does the robot get to this place?
  Verdict holds(const Eigen::Vector3d& place) const;
  /// The same for a place that is known to keep the clearance.
  Verdict connects(const Eigen::Vector3d& place) const;
  /// How far from here in a direction, a unit vector, the robot gets to no place for sure: to the end of the
  /// lattice's cell, and a little more. 0: the cell is not ruled out. Cheaper than the others.
  double ruled_out(const Eigen::Vector3d& place, const Eigen::Vector3d& direction) const;
  /// A way between two places that are held without doubt: straight if that keeps the clearance, else over
  /// the lattice, with what can be cut short cut short. Both ends included. Empty: there is none.
  std::vector<Eigen::Vector3d> way(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;
  /// The places of the lattice that are held without doubt and no farther than half a pitch nearer to or
  /// farther from the surface than `distance`: an even cover of the surface's offset.
  std::vector<Eigen::Vector3d> places_at(double distance) const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

/// Length of a way.
double length_of(const std::vector<Eigen::Vector3d>& way);

}  // namespace limpet::evaluation
