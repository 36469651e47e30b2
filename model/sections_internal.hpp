// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <optional>
#include <vector>

#include "line_chains_internal.hpp"

namespace limpet::model::internal {

/// One side of a pair to be: a chain turned so that places rise along it, and the perimeter it is on.
struct Side {
  const Segment* segment = nullptr;
  const LineChain* chain = nullptr;
  bool reversed = false;  ///< the perimeter runs against the chain

  std::size_t size() const { return chain->stations.size(); }
  const Station& station(std::size_t i) const { return chain->stations[i]; }
  const geometry::Polygon& perimeter() const { return segment->polygon->perimeter; }
  bool shared(std::size_t edge) const { return perimeter().node(chain->edges[edge]).shared; }
  /// Does a shared edge of the two end here?
  bool anchor(std::size_t i) const { return (i > 0 && shared(i - 1)) || (i + 1 < size() && shared(i)); }
};

/// P, or Q (thesis §2.6): what lies between two places on a chain.
struct Section {
  Station begin, end;
  std::size_t first_edge = 0, last_edge = 0;          ///< `begin` is on the first of these, `end` on the last
  bool begin_anchored = false, end_anchored = false;  ///< a shared edge of the two begins, ends there
};

/// The chain with places that rise along L, and offsets that are positive inside. `sign` is that of L's
/// direction along the line.
LineChain turned(LineChain, bool reverse, double sign);

/// The part of the chain that leads from place `begin` to place `end` and projects into L; nothing if there
/// is none, or an end of it would fall inside a shared edge. Between ends of shared edges it may overshoot
/// both ends by so much.
std::optional<Section> section_of(const Side&, double begin, double end, double overshoot);

/// The shared edges on a section, ascending, and the length along the line of the open ones.
struct Content {
  std::vector<geometry::EdgeId> shared;
  double open = 0;
};
Content content_of(const Side&, const Section&);

/// Where the section is farther than λ from L there must be nothing but bays that chance alone leaves (rule
/// `voids`) and, beyond the line, spurs (rule `spurs`).
bool gives_way(const Setting&, const Side&, const Section&);

/// The change of one perimeter: the section gives way to the edge `id` between the chart points l1 and l2.
geometry::Edit edit_for(const Side&, const Section&, geometry::Point2 l1, geometry::Point2 l2,
                        geometry::EdgeId id);

}  // namespace limpet::model::internal
