// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>
#include <limpet/drawing/facets.hpp>
#include <numbers>

namespace limpet::drawing {
namespace {

using Eigen::Vector3d;

constexpr int kSides = 24, kRings = 6;  // around the axis, and from its end to the side

/// Corners around the axis; at an end of it all are in one place.
using Ring = std::vector<Vector3d>;

Ring ring_at(const Vector3d& centre, const Vector3d& u, const Vector3d& v, double radius) {
  Ring ring;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    ring.emplace_back(centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
  }
  return ring;
}

/// From the end of the axis at `a` to that at `b`.
std::vector<Ring> rings_of(const model::Capsule& capsule) {
  const Vector3d along = capsule.b - capsule.a;
  const bool is_ball = !(along.stableNorm() > 0);
  const Vector3d axis = is_ball ? Vector3d::UnitZ() : Vector3d(along.stableNormalized());
  const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<Ring> rings;
  const auto add = [&](const Vector3d& centre, int i) {
    const double angle = std::numbers::pi / 2 * i / kRings;  // from the plane across the axis
    const double around = std::abs(i) == kRings ? 0 : capsule.radius * std::cos(angle);
    rings.push_back(ring_at(centre + capsule.radius * std::sin(angle) * axis, u, v, around));
  };
  for (int i = -kRings; i <= 0; ++i) add(capsule.a, i);
  for (int i = is_ball ? 1 : 0; i <= kRings; ++i) add(capsule.b, i);
  return rings;
}

}  // namespace

std::vector<Facet> facets_of(const model::Capsule& capsule) {
  const std::vector<Ring> rings = rings_of(capsule);
  std::vector<Facet> facets;
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    const Ring &below = rings[i], &above = rings[i + 1];
    for (std::size_t k = 0; k < kSides; ++k) {
      const std::size_t next = (k + 1) % kSides;
      Facet& facet = facets.emplace_back();
      facet.normal = (below[next] - above[k]).cross(above[next] - below[k]).normalized();
      facet.corners = {below[k], below[next], above[next], above[k]};
      if (i == 0) facet.corners.erase(facet.corners.begin());  // an end of the axis
      if (i + 2 == rings.size()) facet.corners.erase(facet.corners.end() - 1);
    }
  }
  return facets;
}

}  // namespace limpet::drawing
