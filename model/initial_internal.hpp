// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/model.hpp>

#include "complex_internal.hpp"

namespace limpet::model::internal {

/// Adds an initial model segment (thesis §4.3). Throws std::invalid_argument, which names the face by its
/// number, when it has fewer than three vertices, no area, or is no simple polygon; then nothing has changed.
void add_initial(Complex&, std::size_t number, const InitialFace&);

}  // namespace limpet::model::internal
