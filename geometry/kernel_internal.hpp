// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

// The only place that knows which arithmetic this build of geometry/ is made of. Included by geometry/*.cpp
// alone.

#if defined(LIMPET_ARITHMETIC_EXACT)
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#else
#include <CGAL/Simple_cartesian.h>
#endif

#include <limpet/geometry/types.hpp>

namespace limpet::geometry::internal {

#if defined(LIMPET_ARITHMETIC_EXACT)
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
#else
using Kernel = CGAL::Simple_cartesian<double>;
#endif

inline Kernel::Point_2 to_kernel(Point2 p) { return {p.x, p.y}; }

}  // namespace limpet::geometry::internal
