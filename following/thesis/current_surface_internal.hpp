// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "path_internal.hpp"
#include "pursuit_internal.hpp"
#include "situation_internal.hpp"

namespace limpet::following::internal {

/// Current surface following (thesis §3.4.1): directs the control point to the current segment, over the
/// edges of the current surface. When this is complete, it goes on with another surface of the model that is
/// not, then with point segments far from every polygon; when there is none, the run is over.
///
/// A segment is marked unreachable when several paths to it could not be followed, each time without the edge
/// that the control point was stuck at: one edge in the way is no reason to give up a face.
class CurrentSurface {
 public:
  explicit CurrentSurface(const Parameters& p) : point_places_(p.resolution, 1) {}

  /// A new path will be found.
  void begin() { path_.reset(); }
  Decision follow(const Situation&, Pursuit&);
  /// What is left of the path: the ends of its legs, as they were when it was found. Empty without one.
  std::vector<Eigen::Vector3d> way() const;

 private:
  bool holds(const Situation&, const Pursuit&);
  void give_up(Pursuit&);
  std::optional<Decision> plan(const Situation&, Pursuit&);
  bool find_path(const Situation&, Pursuit&);
  std::vector<model::SegmentId> goals(const Situation&, const Pursuit&) const;
  model::SegmentId stray_point(const Situation&);
  void advance(const Situation&, Pursuit&);
  double distance_to(std::size_t leg, const Situation&) const;
  double way_along_follow_edge(const Situation&) const;
  Direction along_follow_edge(const Situation&) const;

  std::optional<Path> path_;
  std::size_t follow_ = 0;             ///< leg of the path: the follow edge
  std::set<geometry::EdgeId> barred_;  ///< could not be followed on the way to the current segment
  int failures_ = 0;                   ///< paths to the current segment that could not be followed
  Places point_places_;                ///< of point segments that were pursued
};

}  // namespace limpet::following::internal
