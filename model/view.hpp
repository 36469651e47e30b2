// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <limpet/geometry/chart.hpp>
#include <limpet/model/changes.hpp>

namespace limpet::model {

namespace internal {
class Complex;
}

/// Which segments a question is about.
struct Which {
  SegmentId only{};      ///< if given, only this segment
  SegmentId but{};       ///< if given, every segment except this one
  bool polygons = true;  ///< planar polygon segments that represent sensor points
  bool points = true;    ///< point segments
  bool initial = true;   ///< initial model segments: polygons known beforehand (thesis §4.3)
};

/// A robot link as a capsule: all points within `radius` of the axis from a to b; a sphere when a = b. World
/// frame, scan's unit.
struct Capsule {
  Eigen::Vector3d a, b;
  double radius = 0;
};

/// A read-only view of a model, for the questions of a follower, a viewer or a user between two updates.
/// Nothing is copied.
///
///     const View view = model.view();
///     if (const auto found = view.nearest(position, 0.2)) steer_away_from(found->at);
///
/// Valid until the next call of a non-const member function of the model, or its destruction; it stays valid
/// when the model is moved. Several threads may use it at once. Everything is in the world frame, in the
/// scan's unit.
///
/// *Distances are to segments in space.* A point segment counts as its centroid. A polygon segment is the
/// part of its published plane that its perimeter bounds, without the holes, with the boundary. (The chart in
/// which the perimeter is stored may be tilted against that plane by up to 2.5°, so the nearest point in the
/// chart need not be the nearest in space.)
///
///  (1) the result is the best over all segments: its distance or range is the smallest, as a double, of
///      those found when each segment is asked alone (Which::only). Among segments at the same distance the
///      one of lowest identity is named, and among its edges at the same distance the one of lowest identity;
///  (2) a segment's distance and nearest point are correct up to rounding: some 1e-15 of the coordinates
///      involved;
///  (3) with a larger reach, or more segments, the result is never farther; what is found within one reach is
///      found within any larger one;
///  (4) the answer depends neither on how the segments are stored nor on earlier questions.
///
/// The time of a question about a place depends on what lies near it, not on the size of the model or of a
/// perimeter. Memory is allocated only in the caller's lists, which are cleared first. Throws
/// std::invalid_argument unless coordinates are finite and within 2^300 grid steps of the origin, radii
/// between 0 and 2^300 grid steps, and reaches and ranges at least 0 (they may be infinite). near() takes any
/// box.
class View {
 public:
  /// The point of a segment that is nearest to a given point.
  struct Nearest {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double distance = 0;  ///< from the given point
    SegmentId segment;
    geometry::EdgeId edge;  ///< edge that `at` lies on; none: inside the polygon, or a point segment
  };

  /// The nearest point of all segments, if it is within `reach`.
  std::optional<Nearest> nearest(const Eigen::Vector3d&, double reach, const Which& = {}) const;
  /// The nearest point of each segment within `reach`, ordered by distance, then segment.
  void nearest(const Eigen::Vector3d&, double reach, std::vector<Nearest>&, const Which& = {}) const;

  /// The point of a segment that is nearest to a link, and the point of the link nearest to it. Where several
  /// pairs of points are equally near, as for a link parallel to a plane, it is one of them, always the same.
  struct LinkNearest {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();       ///< point of the segment
    Eigen::Vector3d on_axis = Eigen::Vector3d::Zero();  ///< point of the link's axis nearest to `at`
    /// Unit vector from `at` towards on_axis. Where the axis meets the segment: the outward normal of a
    /// polygon, or any direction for a point segment.
    Eigen::Vector3d away = Eigen::Vector3d::Zero();
    double fraction = 0;  ///< place of on_axis on the axis, from 0 at a to 1 at b
    /// Signed distance of `at` from the link's surface: negative when `at` is inside the link, and −radius
    /// when the segment meets the axis, however far the link reaches beyond the segment.
    double distance = 0;
    SegmentId segment;
    geometry::EdgeId edge;  ///< edge that `at` lies on; none: inside the polygon, or a point segment

    /// The point of the link's surface nearest to `at`.
    Eigen::Vector3d on_surface(double radius) const { return on_axis - radius * away; }
  };

  /// The point of all segments that is nearest to the link, if it is within `reach` of the link's surface or
  /// inside the link.
  std::optional<LinkNearest> nearest(const Capsule&, double reach, const Which& = {}) const;
  /// The nearest point of each segment within `reach`, ordered by distance, then segment.
  void nearest(const Capsule&, double reach, std::vector<LinkNearest>&, const Which& = {}) const;

  /// Where a ray meets a polygon.
  struct Hit {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double range = 0;  ///< distance from the start of the ray
    SegmentId segment;
    bool from_outside = false;  ///< the ray runs against the outward normal
  };

  /// The first polygon that a ray meets within `range`; a polygon that holds its start `from` counts. `axis`
  /// may have any finite length but 0 (else std::invalid_argument). Never met are polygons whose plane is
  /// parallel to the ray or contains it, and point segments. The two copies of a shared edge may be some grid
  /// steps apart, so that a ray may pass between them.
  std::optional<Hit> first_hit(const Eigen::Vector3d& from, const Eigen::Vector3d& axis, double range,
                               const Which& = {}) const;

  /// A directed edge of a polygon. Seen from outside the surface, the polygon is on its left.
  struct Edge {
    geometry::EdgeId id, next, previous;
    geometry::EdgeId partner;  ///< the other copy of a shared edge; none: it is open
    SegmentId segment;
    geometry::CycleId cycle{};  ///< the same for all edges of one boundary cycle
    bool hole = false;          ///< the cycle bounds a hole
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();  ///< on the published plane
  };

  /// Nothing when the edge is gone: the model has changed it (thesis §3.4.6).
  std::optional<Edge> edge(geometry::EdgeId) const;
  /// All edges of a segment: cycle by cycle, the outer one first, each in its order along the boundary. Empty
  /// when the segment is gone, or a point segment.
  void edges(SegmentId, std::vector<Edge>&) const;
  /// The edges of a segment that have no partner, in the same order.
  void open_edges(SegmentId, std::vector<Edge>&) const;
  /// All open edges of the model, by identity.
  void open_edges(std::vector<Edge>&, const Which& = {}) const;

  enum class Kind { point, polygon, initial };
  struct Segment {
    SegmentId id;
    Kind kind = Kind::point;
    /// A polygon's published plane, its normal facing outside. For a point segment, its centroid and the
    /// normal of its plane of best fit, which may mean nothing.
    geometry::Plane plane;
    std::int64_t points = 0;     ///< sensor points it represents; 0 if initial
    std::int64_t confirmed = 0;  ///< sensor points that lie on it; 0 unless initial
    std::size_t edges = 0, holes = 0;
    Eigen::AlignedBox3d box;  ///< bounding box up to rounding; may be larger after the perimeter has shrunk
  };

  /// Nothing when the segment is gone: merged into another one, or deleted.
  std::optional<Segment> segment(SegmentId) const;
  /// Root mean square distance of a segment's sensor points from its Segment::plane. Nothing when the segment
  /// is gone, or represents no points.
  std::optional<double> residual(SegmentId) const;
  /// All segments, by identity.
  void segments(std::vector<SegmentId>&, const Which& = {}) const;
  /// The segments whose boxes (Segment::box) meet this one, by identity. An empty box meets nothing.
  void near(const Eigen::AlignedBox3d&, std::vector<SegmentId>&, const Which& = {}) const;

  /// The segments that share edges with this one, by identity. Empty when it is gone.
  void neighbours(SegmentId, std::vector<SegmentId>&) const;
  /// Are the two segments of one surface (thesis §2.2)? In constant time; false when one of them is gone.
  bool same_surface(SegmentId, SegmentId) const;
  /// The surface a segment belongs to: the lowest identity of its segments. None when the segment is gone.
  SegmentId surface_of(SegmentId) const;
  /// The segments of the surface that `member` belongs to, itself included, by identity. Empty when it is
  /// gone.
  void surface(SegmentId member, std::vector<SegmentId>&) const;

 private:
  friend class Model;
  explicit View(const internal::Complex& complex) : complex_(&complex) {}

  const internal::Complex* complex_;
};

}  // namespace limpet::model
