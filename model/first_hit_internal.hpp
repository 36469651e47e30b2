// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/view.hpp>

#include "complex_internal.hpp"

namespace limpet::model::internal {

/// The first polygon that the ray along the unit vector `axis` meets. `rounding` is rounding_near() `from`.
std::optional<View::Hit> first_hit(const Complex&, const Eigen::Vector3d& from, const Eigen::Vector3d& axis,
                                   double range, const Which&, double rounding);

}  // namespace limpet::model::internal
