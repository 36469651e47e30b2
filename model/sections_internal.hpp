// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <optional>
#include <vector>

#include "chance_internal.hpp"
#include "line_chains_internal.hpp"

namespace limpet::model::internal {

/// One of the two sides of a shared edge to be formed: a chain, turned so that places increase along it, and
/// its perimeter.
struct Side {
  const Segment* segment = nullptr;
  const LineChain* chain = nullptr;
  bool reversed = false;  ///< the perimeter runs against the chain
  double reach = 0;       ///< SharingReach::at_angle() of the line
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(), along = Eigen::Vector3d::Zero(),
                  inwards = Eigen::Vector3d::Zero();  ///< of places and offsets, in the world

  std::size_t size() const { return chain->stations.size(); }
  const Station& station(std::size_t i) const { return chain->stations[i]; }
  const geometry::Polygon& perimeter() const { return segment->polygon->perimeter; }
  bool shared(std::size_t edge) const { return perimeter().node(chain->edges[edge]).shared; }
  /// An addition in these coordinates, with nothing in it yet.
  Addition frame() const { return {origin, along, inwards, {}, {}}; }
  /// Does a shared edge of the two segments begin or end at this station?
  bool anchor(std::size_t i) const { return (i > 0 && shared(i - 1)) || (i + 1 < size() && shared(i)); }
};

/// Section P or Q of thesis §2.6: the part of a chain between two places.
struct Section {
  Station begin, end;
  std::size_t first_edge = 0, last_edge = 0;          ///< `begin` is on the first of these, `end` on the last
  bool begin_anchored = false, end_anchored = false;  ///< a shared edge of the two has an end there
};

/// The chain, reversed if asked, with places that increase along L and offsets that are positive inside.
/// `sign`: 1 if L runs along the line, −1 if against it.
LineChain turned(LineChain, bool reverse, double sign);

/// The part of the chain that leads from place `begin` to place `end` and projects into L; nothing if there
/// is none, or one of its ends would fall inside a shared edge. If it lies between ends of shared edges, it
/// may exceed `begin` and `end` by `overshoot`. Lengths in scan's unit.
std::optional<Section> section_of(const Side&, double begin, double end, double overshoot);

/// The shared edges on a section, ascending, and the length of its open edges along the line, scan's unit.
struct Content {
  std::vector<geometry::EdgeId> shared;
  double open = 0;
};
Content content_of(const Side&, const Section&);

/// May the section give way to L? It may be farther than λ from L only along bays that may be chance gaps
/// (rule `voids`) and, beyond the line, along spurs (rule `spurs`).
bool gives_way(const Complex&, const Side&, const Section&);

/// The edit of one perimeter that replaces the section by the shared edge `id` between the chart points l1
/// and l2.
geometry::Edit edit_for(const Side&, const Section&, geometry::Point2 l1, geometry::Point2 l2,
                        geometry::EdgeId id);

}  // namespace limpet::model::internal
