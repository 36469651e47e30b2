// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <limpet/model/view.hpp>

#include "streams.hpp"

/// What questions about places must come to, by plain formulas from a record alone: all edges one after the
/// other, in space, and the plane; in long doubles.
namespace limpet::model::testing {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;

inline Real truth_fraction(const Vector& a, const Vector& b, const Vector& p) {
  const Vector along = b - a;
  const Real length2 = along.dot(along);
  return length2 > 0 ? std::clamp<Real>((p - a).dot(along) / length2, 0, 1) : 0;
}
inline Real truth_distance(const Vector& a, const Vector& b, const Vector& p) {
  return (a + truth_fraction(a, b, p) * (b - a) - p).norm();
}

/// Between two straight pieces (Ericson, "Real-Time Collision Detection", 5.1.9), or their ends.
inline Real truth_distance(const Vector& p1, const Vector& q1, const Vector& p2, const Vector& q2) {
  Real best = std::min({truth_distance(p2, q2, p1), truth_distance(p2, q2, q1), truth_distance(p1, q1, p2),
                        truth_distance(p1, q1, q2)});
  const Vector d1 = q1 - p1, d2 = q2 - p2, r = p1 - p2;
  const Real a = d1.dot(d1), e = d2.dot(d2), b = d1.dot(d2), c = d1.dot(r), f = d2.dot(r);
  const Real denominator = a * e - b * b;
  if (!(denominator > 0)) return best;
  const Real s = std::clamp<Real>((b * f - c * e) / denominator, 0, 1);
  const Vector on = p1 + s * d1;
  return std::min(best, truth_distance(p2, q2, on));
}

/// A segment as the record has it.
class TrueSegment {
 public:
  explicit TrueSegment(const PointSegmentRecord& r, double step) : id_{r.id} {
    for (std::size_t i = 0; i < 3; ++i)
      centroid_[static_cast<int>(i)] =
          static_cast<Real>(r.moments.sum[i]) / static_cast<Real>(r.moments.count) * step;
  }
  explicit TrueSegment(const PolygonSegmentRecord& r, double step)
      : id_{r.id}, polygon_(true), initial_(r.moments.count == 0) {
    u_ = r.chart_u.cast<Real>(), v_ = r.chart_v.cast<Real>();
    for (std::size_t i = 0; i < r.cycles.size(); ++i) {
      const auto& cycle = r.cycles[i];
      for (std::size_t k = 0; k < cycle.size(); ++k) {
        const auto in_world = [&](const VertexRecord& x) {
          const Real h = Real(r.height[0]) + Real(r.height[1]) * x.x + Real(r.height[2]) * x.y;
          return Vector(r.chart_origin.cast<Real>() +
                        Real(step) * (x.x * u_ + x.y * v_ + h * r.chart_normal.cast<Real>()));
        };
        edges_.push_back(
            {{cycle[k].edge}, in_world(cycle[k]), in_world(cycle[(k + 1) % cycle.size()]), i > 0});
      }
    }
    normal_ = (r.chart_normal.cast<Real>() - r.height[1] * u_ - r.height[2] * v_).normalized();
  }

  struct Edge {
    geometry::EdgeId id;
    Vector from, to;
    bool hole = false;
  };

  SegmentId id() const { return id_; }
  bool polygon() const { return polygon_; }
  bool initial() const { return initial_; }
  const std::vector<Edge>& edges() const { return edges_; }
  const Vector& normal() const { return normal_; }
  Vector some_point() const { return polygon_ ? edges_.front().from : centroid_; }

  Real height(const Vector& p) const { return normal_.dot(p - edges_.front().from); }
  /// Of a point of the plane: by the even-odd rule, along u.
  bool holds(const Vector& p) const {
    bool inside = false;
    for (const Edge& e : edges_) {
      const Real ay = (e.from - p).dot(v_), by = (e.to - p).dot(v_);
      if ((ay <= 0) == (by <= 0)) continue;
      const Real ax = (e.from - p).dot(u_), bx = (e.to - p).dot(u_);
      inside ^= ax + (bx - ax) * (ay / (ay - by)) > 0;
    }
    return inside;
  }
  Real distance_from_edges(const Vector& p) const {
    Real best = std::numeric_limits<Real>::infinity();
    for (const Edge& e : edges_) best = std::min(best, truth_distance(e.from, e.to, p));
    return best;
  }
  Real distance(const Vector& p) const {
    if (!polygon_) return (p - centroid_).norm();
    const Real h = height(p);
    return holds(p - h * normal_) ? std::abs(h) : distance_from_edges(p);
  }
  Real distance(const Vector& a, const Vector& b) const {
    if (!polygon_) return truth_distance(a, b, centroid_);
    const Real ha = height(a), hb = height(b);
    if (((ha <= 0) != (hb <= 0) || ha == 0) && holds(ha == hb ? a : Vector(a + ha / (ha - hb) * (b - a))))
      return 0;
    Real best = std::min(distance(a), distance(b));
    for (const Edge& e : edges_) best = std::min(best, truth_distance(a, b, e.from, e.to));
    return best;
  }

 private:
  SegmentId id_;
  bool polygon_ = false, initial_ = false;
  Vector centroid_ = Vector::Zero(), u_ = Vector::Zero(), v_ = Vector::Zero(), normal_ = Vector::UnitZ();
  std::vector<Edge> edges_;
};

/// All of a model.
struct TrueModel {
  explicit TrueModel(const ModelRecord& r) : resolution(r.parameters.resolution) {
    for (const auto& s : r.point_segments) segments.emplace_back(s, r.grid_step);
    for (const auto& s : r.polygon_segments) segments.emplace_back(s, r.grid_step);
    std::sort(segments.begin(), segments.end(), [](const auto& a, const auto& b) { return a.id() < b.id(); });
    for (const auto& s : segments) {
      size = std::max(size, s.some_point().cwiseAbs().maxCoeff());
      for (const auto& e : s.edges()) size = std::max(size, e.from.cwiseAbs().maxCoeff());
    }
  }
  const TrueSegment* find(SegmentId id) const {
    const auto found =
        std::find_if(segments.begin(), segments.end(), [&](const auto& s) { return s.id() == id; });
    return found == segments.end() ? nullptr : &*found;
  }

  std::vector<TrueSegment> segments;  ///< by identity
  double resolution = 0;
  Real size = 0;  ///< largest coordinate
};

inline bool is_asked(const Which& which, const TrueSegment& s) {
  if ((which.only && which.only != s.id()) || which.but == s.id()) return false;
  return s.initial() ? which.initial : s.polygon() ? which.polygons : which.points;
}

}  // namespace limpet::model::testing
