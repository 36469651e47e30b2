// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/geometry/predicates.hpp>

/// The stages of orientation(), opened to tests. They come in this order, and each must agree with those
/// after it wherever it answers:
///   orientation_filter      doubles with an error bound; inline in predicates.hpp
///   orientation_unfiltered  CGAL's filtered kernel: interval arithmetic, then exact numbers (predicates.cpp)
///   orientation_exact       exact numbers only; not used by orientation(), a reference for tests
namespace limpet::geometry::internal {

/// In the float builds the same as orientation_unfiltered().
int orientation_exact(Point2 p, Point2 q, Point2 r);

}  // namespace limpet::geometry::internal
