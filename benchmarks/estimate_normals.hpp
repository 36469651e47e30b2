// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include "cgal_cloud.hpp"

namespace limpet::benchmarks {

/// By the 12 nearest points of each, not oriented: neither detector asks for that.
void estimate_normals(OrientedPoints&);

}  // namespace limpet::benchmarks
