// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <vector>

#include "complex_internal.hpp"

/// What is done to shared edges (thesis §2.2, §2.4.4, §2.6, §2.7).
namespace limpet::model::internal {

// reposition.cpp: §2.4.4
/// Puts these shared edges of s, and their copies, onto the lines where the planes meet now. What cannot
/// follow is unshared.
void reposition(Complex&, const Segment& s, std::vector<geometry::EdgeId> edges);

// ordering.cpp: local and global ordering (§2.2), and concavity
/// Is an order broken on one of the boundary cycles of s?
bool is_disordered(const Complex&, const Segment& s);
/// Dissolves what is disordered on the boundary cycles of s (§2.4.3, §2.6); whether anything was.
bool dissolve_disordered(Complex&, Agenda&, const Segment& s);
/// Quick and sure, but not complete: does an edge just shared leave the orderings as they were, because it is
/// the first of its two segments, or next to another one of theirs on both perimeters?
bool order_stays(const Complex&, geometry::EdgeId);
/// Neighbours have one type of concavity (§2.2): where a merger has brought `edges` to s, and two together,
/// those of the shorter one are unshared.
void keep_one_concavity(Complex&, const Segment& s, const std::vector<geometry::EdgeId>& edges);

// share_edges.cpp: §2.6 and step 4; whether any edge was shared
bool share_modified(Complex&, Agenda&);
// corners.cpp: §2.7 and step 5; whether any corner was formed
bool form_corners_of_modified(Complex&, Agenda&);

}  // namespace limpet::model::internal
