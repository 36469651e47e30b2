// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "complex_internal.hpp"

namespace limpet::model::internal {

/// Step 3 of the update: fills fissures in the perimeters of modified polygons (thesis §2.5). Returns whether
/// there were any.
bool fill_modified(Complex&, Agenda&);

}  // namespace limpet::model::internal
