// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <deque>
#include <vector>

#include "complex_internal.hpp"
#include "labels_internal.hpp"
#include "standing_internal.hpp"

namespace limpet::model::internal {

/// Sensor points that are to be inserted, for the first time or again.
using PendingPoints = std::deque<RawPoint>;

/// Takes a young segment away; its points are pending again. `count_return`: this is counted against
/// kMaxReturns.
void release_points(Complex&, PendingPoints&, const Segment& young, bool count_return);

/// Sensor points find their segments (thesis §2.3, steps 1 and 2a for points). Owns the points that are
/// pending, and the memory that every point needs for a moment.
class Insertion {
 public:
  Insertion(Complex& complex, Agenda& agenda, Labels& labels)
      : complex_(complex), agenda_(agenda), labels_(labels) {}

  /// A reading becomes part of the segment it fits best, or a point segment that merges with its neighbours;
  /// and so do all that are pending because of it.
  void insert(const RawPoint&);
  void insert_pending();
  PendingPoints& pending() { return pending_; }
  const PendingPoints& pending() const { return pending_; }

 private:
  struct Candidate {
    double distance2;  ///< by which they are ordered, squared
    SegmentId id;
    const Segment* segment;
    Standing standing;
  };
  using Candidates = std::vector<Candidate>;

  void insert_one(const RawPoint&);
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
  Candidates candidates_, near_polygons_, near_points_;
  std::vector<std::uint32_t> found_;
};

}  // namespace limpet::model::internal
