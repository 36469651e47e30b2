// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>

#include "slices_internal.hpp"

namespace limpet::following::internal {

using Eigen::Vector3d;

std::int64_t Slices::slice_at(const Vector3d& p) const {
  return static_cast<std::int64_t>(std::floor(place(p) / width()));
}

Slices::Block Slices::slices_through(const Edge& edge) const {
  const std::int64_t from = slice_at(edge.from), to = slice_at(edge.to);
  return {std::min(from, to), std::max(from, to)};
}

Vector3d Slices::from_line(const Vector3d& p) const { return p - point_ - place(p) * vector_; }

bool Slices::suits(const Edge& edge) const {
  if (edge.segment != segment_ || !has_used()) return false;
  constexpr double kCosine45 = 0.70710678118654752;
  const Block through = slices_through(edge);
  return from_line(edge.from).norm() < resolution_ && from_line(edge.to).norm() < resolution_ &&
         (edge.to - edge.from).normalized().dot(vector_) > kCosine45 && through.first <= used_.last &&
         used_.first <= through.last;
}

bool Slices::begin(const Edge& edge) {
  current_.reset();
  if (suits(edge)) return true;
  point_ = edge.from;
  vector_ = (edge.to - edge.from).normalized();
  segment_ = edge.segment;
  used_ = {};
  return false;
}

bool Slices::choose(const Edge& edge, const Vector3d& control_point) {
  const Block through = slices_through(edge);
  if (!has_used())
    current_ = std::clamp(slice_at(control_point), through.first, through.last);
  else if (through.last > used_.last)
    current_ = used_.last + 1;
  else if (through.first < used_.first)
    current_ = used_.first - 1;
  else
    return false;
  return true;
}

void Slices::use() {
  if (!current_) return;
  if (!has_used()) used_ = {*current_, *current_};
  used_.first = std::min(used_.first, *current_);
  used_.last = std::max(used_.last, *current_);
  current_.reset();
}

Vector3d Slices::current_point(const Edge& edge) const {
  const double from = place(edge.from), to = place(edge.to);
  if (from == to) return edge.from;
  return edge.from + std::clamp((centre() - from) / (to - from), 0.0, 1.0) * (edge.to - edge.from);
}

bool Slices::contains(const Vector3d& p) const { return current_ && slice_at(p) == *current_; }

Vector3d Slices::to_centre(const Vector3d& p) const { return (centre() - place(p)) * vector_; }

}  // namespace limpet::following::internal
