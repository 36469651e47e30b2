// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/following/observation.hpp>
#include <limpet/following/parameters.hpp>
#include <limpet/following/space_hash_internal.hpp>
#include <limpet/following/transit/transit_internal.hpp>
#include <optional>
#include <vector>

#include "open_edge_map_internal.hpp"
#include "place_memory_internal.hpp"
#include "targets_internal.hpp"

namespace limpet::following::internal {

/// Takes a robot to configurations from which a sensor sees what is left, when following has nothing else
/// left to do: what was out of reach may be within (thesis §3.4.7 has it for later, §5.2 as future work).
class Repositioning {
 public:
  /// All must outlive it.
  Repositioning(const Parameters& p, OpenEdgeMap& open, PlaceMemory& memory, TargetFinder& finder)
      : parameters_(p), open_(open), memory_(memory), finder_(finder), tried_(p.resolution) {}

  /// Begins a way to where the nearest that is left is seen, of edges, then of these targets; what no way
  /// leads to becomes unreachable. Returns whether there is one.
  bool begin(const Observation&, Transit&, const std::vector<Target>& near);
  bool is_under_way() const { return sought_.has_value(); }
  void stop() { sought_.reset(); }
  /// The robot has come to where it sees what it sought, which may be far from its control point.
  /// Precondition: is_under_way(); after it it is not.
  void arrived(const Observation&);

 private:
  bool begin_to_see(const Target&, Transit&);
  bool was_tried(const Target&) const;

  const Parameters& parameters_;
  OpenEdgeMap& open_;
  PlaceMemory& memory_;
  TargetFinder& finder_;
  SpaceHash<Eigen::Vector3d> tried_;  ///< for each try, where the target is: its normal
  std::optional<Target> sought_;
  std::vector<OpenPart> parts_;
};

}  // namespace limpet::following::internal
