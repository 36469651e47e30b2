// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Core>
#include <vector>

namespace limpet::evaluation {

// What meets what is decided exactly.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using ExactTriangles = std::vector<Kernel::Triangle_3>;
using ExactPrimitive = CGAL::AABB_triangle_primitive<Kernel, ExactTriangles::const_iterator>;
using ExactTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, ExactPrimitive>>;

inline Kernel::Point_3 point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace limpet::evaluation
