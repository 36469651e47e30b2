// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include <limpet/model/view.hpp>

#include "changes_internal.hpp"

namespace limpet::following::internal {

/// The slices into which the unexposed surface near the current edge is divided (thesis §3.4.3, Figures 31
/// and 33): perpendicular to the slice line, λ/2 wide, numbered along it. The used ones form one block.
class Slices {
 public:
  using Edge = model::View::Edge;

  /// `resolution`: λ.
  explicit Slices(double resolution) : resolution_(resolution) {}

  /// A new current edge. The slice line is kept if it was of the same segment, the edge's vertices are nearer
  /// to it than λ, the edge runs within 45° of its vector, and a used slice passes through the edge; else it
  /// becomes the edge. Returns whether it was kept.
  bool begin(const Edge&);
  /// Follows the slice line's segment through mergers.
  void take(const Changes& changes) { segment_ = changes.now(segment_); }

  /// Makes an unused slice through the edge the current one: beside the used ones, or if there are none the
  /// one nearest to the control point. False when the block of used slices contains the edge.
  bool choose(const Edge&, const Eigen::Vector3d& control_point);
  /// The current slice is used, and none is current any more.
  void use();
  bool has_current() const { return current_.has_value(); }
  bool has_used() const { return used_.first <= used_.last; }

  /// The edge's point nearest to the centre of the current slice: the current point. Precondition: there is a
  /// current slice.
  Eigen::Vector3d current_point(const Edge&) const;
  bool contains(const Eigen::Vector3d&) const;
  /// From the point to the centre of the current slice, along the slice line.
  Eigen::Vector3d to_centre(const Eigen::Vector3d&) const;

  const Eigen::Vector3d& vector() const { return vector_; }
  /// The vector from the slice line to the point.
  Eigen::Vector3d from_line(const Eigen::Vector3d&) const;

 private:
  struct Block {
    std::int64_t first = 0, last = -1;
  };
  double place(const Eigen::Vector3d& p) const { return (p - point_).dot(vector_); }
  double width() const { return resolution_ / 2; }
  double centre() const { return (static_cast<double>(*current_) + 0.5) * width(); }
  std::int64_t slice_at(const Eigen::Vector3d&) const;
  Block slices_through(const Edge&) const;
  bool suits(const Edge&) const;

  double resolution_;
  Eigen::Vector3d point_ = Eigen::Vector3d::Zero(), vector_ = Eigen::Vector3d::UnitX();
  model::SegmentId segment_;
  Block used_;
  std::optional<std::int64_t> current_;
};

}  // namespace limpet::following::internal
