// Copyright the limpet authors. GPL-3.0-or-later.
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <limits>
#include <limpet/evaluation/nearest.hpp>

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using Plain = CGAL::Simple_cartesian<double>;  // distances need no exact decisions

Plain::Point_3 cartesian(const Vector3d& p) { return {p.x(), p.y(), p.z()}; }

template <typename Object, template <typename, typename> typename Primitive>
struct Index {
  using Objects = std::vector<Object>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Plain, Primitive<Plain, typename Objects::const_iterator>>>;

  void build() {
    tree.insert(objects.cbegin(), objects.cend());
    tree.build();
  }

  double distance(const Vector3d& from) const {
    if (objects.empty()) return std::numeric_limits<double>::infinity();
    return std::sqrt(CGAL::to_double(tree.squared_distance(cartesian(from))));
  }

  Objects objects;
  Tree tree;
};

// The primitives have defaulted parameters, which a template template parameter does not see.
template <typename K, typename I>
using TrianglePrimitive = CGAL::AABB_triangle_primitive<K, I>;
template <typename K, typename I>
using SegmentPrimitive = CGAL::AABB_segment_primitive<K, I>;

}  // namespace

struct NearestSurface::Inside : Index<Plain::Triangle_3, TrianglePrimitive> {};
struct NearestLine::Inside : Index<Plain::Segment_3, SegmentPrimitive> {};

NearestSurface::NearestSurface(const std::vector<Triangle3>& triangles)
    : inside_(std::make_unique<Inside>()) {
  for (const Triangle3& t : triangles) {
    const Plain::Triangle_3 triangle(cartesian(t[0]), cartesian(t[1]), cartesian(t[2]));
    if (!triangle.is_degenerate()) inside_->objects.push_back(triangle);
  }
  inside_->build();
}

NearestLine::NearestLine(const std::vector<std::pair<Vector3d, Vector3d>>& segments)
    : inside_(std::make_unique<Inside>()) {
  for (const auto& [a, b] : segments)
    if (a != b) inside_->objects.emplace_back(cartesian(a), cartesian(b));
  inside_->build();
}

NearestSurface::~NearestSurface() = default;
NearestSurface::NearestSurface(NearestSurface&&) noexcept = default;
NearestSurface& NearestSurface::operator=(NearestSurface&&) noexcept = default;
NearestLine::~NearestLine() = default;
NearestLine::NearestLine(NearestLine&&) noexcept = default;
NearestLine& NearestLine::operator=(NearestLine&&) noexcept = default;

double NearestSurface::distance(const Vector3d& from) const { return inside_->distance(from); }
double NearestLine::distance(const Vector3d& from) const { return inside_->distance(from); }

}  // namespace limpet::evaluation
