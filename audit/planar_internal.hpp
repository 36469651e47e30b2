// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/audit/exact_internal.hpp>
#include <limpet/audit/planar.hpp>

namespace limpet::audit {

/// Twice the signed area of a closed chain: positive when it is anticlockwise.
Dyadic twice_area(std::span<const Point> cycle);

}  // namespace limpet::audit
