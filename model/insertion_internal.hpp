// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <vector>

#include "complex_internal.hpp"
#include "labels_internal.hpp"
#include "pending_points_internal.hpp"
#include "standing_internal.hpp"

namespace limpet::model::internal {

/// Inserts sensor points into segments (thesis §2.3, steps 1 and 2a for points). Owns the pending points, and
/// buffers that are reused for every point.
class Insertion {
 public:
  Insertion(Complex& complex, Agenda& agenda, Labels& labels)
      : complex_(complex), agenda_(agenda), labels_(labels) {}

  /// Puts a point into the polygon it fits best; or, if it lies on an initial segment, lets it confirm that;
  /// or makes it a point segment, which merges with its neighbours. Then does the same with all points that
  /// are pending because of it.
  void insert(const RawPoint&);
  void insert_pending();
  /// Makes a polygon of points that are promotable together. Precondition: they are, and are few enough to be
  /// those of a young segment.
  void insert_as_polygon(const std::vector<RawPoint>&);
  bool stopped() const { return agenda_.stopped(); }
  PendingPoints& pending() { return pending_; }
  const PendingPoints& pending() const { return pending_; }

 private:
  struct Candidate {
    double distance2;  ///< squared distance by which candidates are ordered
    SegmentId id;
    const Segment* segment;
    Standing standing;
  };
  using Candidates = std::vector<Candidate>;

  void insert_one(const RawPoint&);
  const Segment& create_alone(const RawPoint&);
  const Segment* initial_under(const Eigen::Vector3d& p, const RawPoint&) const;
  void keep_nearer_crossing(const Segment& initial, const Eigen::Vector3d& p, Candidates& polygons) const;
  void settle(const Segment*, bool polygons_tried);
  void find_neighbours(const Segment&, bool polygons_tried);
  void add_polygon(const Segment&, const Eigen::Vector3d& p, const Eigen::Vector3d& axis, double residual2,
                   double variance, Candidates&) const;
  void order(Candidates&) const;
  void order_by_heights(const Eigen::Vector3d& p, Candidates& polygons) const;

  Complex& complex_;
  Agenda& agenda_;
  Labels& labels_;
  PendingPoints pending_;
  Candidates candidates_, near_, near_points_;
  std::vector<std::uint32_t> found_;
};

}  // namespace limpet::model::internal
