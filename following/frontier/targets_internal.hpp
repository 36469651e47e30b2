// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/following/parameters.hpp>
#include <limpet/model/view.hpp>
#include <vector>

#include "open_edge_map_internal.hpp"
#include "outlook_internal.hpp"
#include "place_memory_internal.hpp"

namespace limpet::following::internal {

/// Finds targets: places 0.85 λ outside an open edge, on its polygon's plane, unless another polygon's plane
/// cuts them off. Where rays have found the plane to end, the surface is expected folded round the edge, by
/// 45, 90 and then 135 degrees.
class TargetFinder {
 public:
  TargetFinder(const Parameters& parameters, const PlaceMemory& memory)
      : lambda_(parameters.resolution), memory_(memory) {}

  /// Adds the target outside a part of an open edge, if there is one, and the border that the part is.
  /// Returns what there is to be done; a part that closes is done.
  PartState add(const model::View&, const OpenPart&, Outlook&);
  /// Adds targets around a point segment that is seen from `viewpoint` and near no polygon; none when the two
  /// are one place.
  void add_around_point(const model::View&, const Eigen::Vector3d& point, const Eigen::Vector3d& viewpoint,
                        std::vector<Target>&) const;

 private:
  bool is_cut_off(const model::View&, const OpenPart&, const Eigen::Vector3d& normal,
                  const Eigen::Vector3d& place) const;
  PartState add_targets(const model::View&, const OpenPart&, Border&, Outlook&);
  PartState add_folded(const model::View&, const OpenPart&, const Border&, Outlook&) const;
  PartState insist(const OpenPart&, const Border&, std::vector<Target>&) const;
  bool is_open(const Eigen::Vector3d& at, const Eigen::Vector3d& normal) const;

  double lambda_;
  const PlaceMemory& memory_;
  std::vector<model::View::Nearest> others_;
  std::vector<model::View::Segment> planes_;  ///< of others_
};

}  // namespace limpet::following::internal
