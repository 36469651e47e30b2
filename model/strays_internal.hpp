// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "complex_internal.hpp"
#include "insertion_internal.hpp"

namespace limpet::model::internal {

/// Dissolves young polygons some of whose points lie in other polygons' planes, which they came to before
/// those were there and turned their own plane by it (rule `strays`). The strays are inserted first. Returns
/// whether there were any.
bool release_strays(Complex&, Insertion&);
bool release_strays_of(Complex&, Insertion&, const Segment&);

}  // namespace limpet::model::internal
