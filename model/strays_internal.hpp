// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "complex_internal.hpp"
#include "insertion_internal.hpp"

namespace limpet::model::internal {

/// Parts young polygons from those of their points that lie in other polygons' planes, which came to them
/// before those were there and turned their own plane (rule `strays`).
void part_from_strays(Complex&, Insertion&);

}  // namespace limpet::model::internal
