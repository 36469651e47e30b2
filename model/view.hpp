// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <limits>
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
  SegmentId only{};      ///< if given, this one alone
  SegmentId but{};       ///< if given, not this one
  bool polygons = true;  ///< planar polygon segments that represent sensor points
  bool points = true;    ///< point segments
  bool initial = true;   ///< polygons known beforehand (thesis §4.3)
};

/// A rounded link: all points within `radius` of the axis from a to b. Where a = b it is a sphere. World,
/// scan's unit.
struct Capsule {
  Eigen::Vector3d a, b;
  double radius = 0;
};

/// A window onto a model: what a follower, a viewer or a user asks between two updates. Nothing is copied.
///
///     const View view = model.view();
///     if (const auto found = view.nearest(position, 0.2)) steer_away_from(found->at);
///
/// Valid until the next call that is not const on the model, or its end; it stays valid when the model is
/// moved. Safe to be asked by several threads at once. Everything is in the world, in the scan's unit.
///
/// *The segment in space decides.* A point segment is its centroid. A polygon segment is what its perimeter
/// bounds of its published plane, holes left out, boundary included. (The chart that the perimeter is kept in
/// may be tilted against that plane by 2.5°, so that what is nearest in the chart need not be so in space.)
///
///  (1) What is found is the best of all: distances and ranges are the smallest, as doubles, of those that
///      the segments have when each is asked alone (Which::only). Where several have the same, the segment
///      of lowest identity is named, and of its edges equally near the one of lowest identity;
///  (2) a segment's own distance and place are right to rounding: some 1e-15 of the coordinates involved;
///  (3) a larger reach, or more segments, finds nothing farther; what is found within one reach is
///      found within any larger one;
///  (4) the answer depends neither on the way the segments are stored nor on earlier questions.
///
/// Questions about places take time with what lies near them, not with the size of the model, or of one
/// perimeter. No question allocates memory but the lists that the caller owns, which are cleared first.
/// Coordinates must be finite and within 2^300 grid steps of the origin, reaches and ranges at least 0
/// (infinite: however far): else std::invalid_argument.
class View {
 public:
  /// The point of a segment nearest to a place.
  struct Nearest {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double distance = 0;  ///< to what was asked about
    SegmentId segment;
    geometry::EdgeId edge;  ///< that `at` lies on; none: inside the polygon, or a point segment
  };

  /// The nearest point within `reach`, if there is one.
  std::optional<Nearest> nearest(const Eigen::Vector3d&, double reach, const Which& = {}) const;
  /// That of every segment within `reach`, by distance, then segment.
  void nearest(const Eigen::Vector3d&, double reach, std::vector<Nearest>&, const Which& = {}) const;

  /// The point of a segment nearest to a link, and where on the link. Where several pairs of points are
  /// equally near, as for a link along a plane, one of them, always the same.
  struct LinkNearest {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();       ///< of the segment
    Eigen::Vector3d on_axis = Eigen::Vector3d::Zero();  ///< of the link's axis, nearest to `at`
    /// Unit vector from `at` to the axis. Where the axis meets the segment: the outward normal of a polygon,
    /// any direction for a point segment.
    Eigen::Vector3d away = Eigen::Vector3d::Zero();
    double fraction = 0;  ///< of the way from the axis's a to b, where on_axis is
    /// From the link's surface; negative when the segment reaches into the link, by as much as `at` is inside
    /// it; −radius when it meets the axis, however far the link goes on behind it.
    double distance = 0;
    SegmentId segment;
    geometry::EdgeId edge;  ///< that `at` lies on; none: inside the polygon, or a point segment

    /// The point of the link's surface nearest to `at`.
    Eigen::Vector3d on_surface(double radius) const { return on_axis - radius * away; }
  };

  /// The point nearest to the link, if it is within `reach` of its surface or reaches into it.
  std::optional<LinkNearest> nearest(const Capsule&, double reach, const Which& = {}) const;
  /// That of every segment within `reach`, by distance, then segment.
  void nearest(const Capsule&, double reach, std::vector<LinkNearest>&, const Which& = {}) const;

  /// Where a ray meets a polygon.
  struct Hit {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double range = 0;  ///< from where the ray begins
    SegmentId segment;
    bool from_outside = false;  ///< it came against the outward normal
  };

  /// The first polygon that the ray from `from` along `axis` (of any length but 0, else
  /// std::invalid_argument) meets within `range`, also when it begins there. One whose plane the ray lies in,
  /// or is parallel to, is not met; point segments never are. The two copies of a shared edge may be some
  /// grid steps apart, and a ray pass between them.
  std::optional<Hit> first_hit(const Eigen::Vector3d& from, const Eigen::Vector3d& axis, double range,
                               const Which& = {}) const;

  /// A directed edge of a polygon; the inside is on its left as seen from outside.
  struct Edge {
    geometry::EdgeId id, next, previous;
    geometry::EdgeId partner;  ///< the other copy of a shared edge; none: it is open
    SegmentId segment;
    geometry::CycleId cycle{};  ///< the same for all edges of one boundary cycle
    bool hole = false;          ///< that cycle bounds a hole
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();  ///< on the published plane
  };

  /// Nothing when the edge is gone: it was changed (thesis §3.4.6).
  std::optional<Edge> edge(geometry::EdgeId) const;
  /// All edges of a segment, cycle by cycle from edge to next, the outer cycle first. None when it is gone,
  /// or a point segment.
  void edges(SegmentId, std::vector<Edge>&) const;
  /// Those that have no partner, in the same order.
  void open_edges(SegmentId, std::vector<Edge>&) const;
  /// All there are in the model, by identity.
  void open_edges(std::vector<Edge>&, const Which& = {}) const;

  enum class Kind { point, polygon, initial };
  struct Segment {
    SegmentId id;
    Kind kind = Kind::point;
    /// A polygon's published plane, the normal facing outside. Of a point segment, its centroid and the
    /// normal of the plane of best fit, which may be anything.
    geometry::Plane plane;
    std::int64_t points = 0;  ///< sensor points it represents; none if initial
    std::size_t edges = 0, holes = 0;
    Eigen::AlignedBox3d box;  ///< that holds it; tight but for rounding, and for a perimeter that has shrunk
  };

  /// Nothing when the segment is gone: merged into another one, or deleted.
  std::optional<Segment> segment(SegmentId) const;
  /// All of them, by identity.
  void segments(std::vector<SegmentId>&, const Which& = {}) const;
  /// Those whose boxes (Segment::box) meet this one, by identity. An empty box meets nothing.
  void near(const Eigen::AlignedBox3d&, std::vector<SegmentId>&, const Which& = {}) const;

  /// The segments that share edges with this one, by identity.
  void neighbours(SegmentId, std::vector<SegmentId>&) const;
  /// Are the two segments of one surface (thesis §2.2)? In constant time; false when one of them is gone.
  bool same_surface(SegmentId, SegmentId) const;
  /// The surface a segment belongs to: the lowest identity of its segments. None when the segment is gone.
  SegmentId surface_of(SegmentId) const;
  /// The segments of the surface that this one belongs to, itself included, by identity.
  void surface(SegmentId member, std::vector<SegmentId>&) const;

 private:
  friend class Model;
  explicit View(const internal::Complex& complex) : complex_(&complex) {}

  const internal::Complex* complex_;
};

}  // namespace limpet::model
