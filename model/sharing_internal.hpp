// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <vector>

#include "complex_internal.hpp"

/// Forming, moving and dissolving shared edges and corners (thesis §2.2, §2.4.4, §2.6, §2.7).
namespace limpet::model::internal {

// reposition.cpp: §2.4.4
/// Moves these shared edges of s, and their partners, onto the lines where the planes meet now. Edges that
/// cannot be moved there are unshared.
void reposition(Complex&, const Segment& s, std::vector<geometry::EdgeId> edges);

// ordering.cpp: local and global ordering (§2.2), and concavity
/// Is the local or the global ordering broken on one of the boundary cycles of s?
bool is_disordered(const Complex&, const Segment& s);
/// Dissolves the neighbour relations that break an ordering on the boundary cycles of s (§2.4.3, §2.6).
/// Returns whether there were any.
bool dissolve_disordered(Complex&, Agenda&, const Segment& s);
/// A fast, sufficient test that a new shared edge breaks no ordering: it is the first of its two segments, or
/// on both perimeters the next shared edge is another one of theirs.
bool order_stays(const Complex&, geometry::EdgeId);
/// Neighbours have one type of concavity (§2.2). A merger that has brought `edges` to s may have left both
/// types with a segment: unshares the type with the smaller total length.
void keep_one_concavity(Complex&, const Segment& s, const std::vector<geometry::EdgeId>& edges);

// share_edges.cpp: §2.6 and step 4. Returns whether any edge was shared.
bool share_modified(Complex&, Agenda&);
// corners.cpp: §2.7 and step 5. Returns whether any corner was formed.
bool form_corners_of_modified(Complex&, Agenda&);

}  // namespace limpet::model::internal
