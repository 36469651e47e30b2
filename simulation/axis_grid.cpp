// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/axis_grid_internal.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;

constexpr double kMostCells = 512;  ///< along the grid's diagonal: a bound for the walk
/// Of a cell's size: points so much farther than ε from it are in it, too, so that rounding of the walk loses
/// none.
constexpr double kSlack = 1e-6;

}  // namespace

AxisGrid::AxisGrid(const std::vector<Vector3d>& points, double epsilon)
    : points_(points), epsilon_(epsilon), low_(points.front()), high_(points.front()) {
  for (const Vector3d& p : points) {
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
  }
  size_ = std::max(2 * epsilon, (high_ - low_).norm() / kMostCells);
  const Vector3d reach = Vector3d::Constant(epsilon + kSlack * size_);
  low_ -= reach;
  high_ += reach;
  last_ = Cell(((high_ - low_) / size_).array().floor().cast<std::int64_t>());

  std::vector<std::pair<std::uint64_t, std::size_t>> entries;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Cell first = cell_of(points[i] - reach), last = cell_of(points[i] + reach);
    for (std::int64_t x = first.x(); x <= last.x(); ++x)
      for (std::int64_t y = first.y(); y <= last.y(); ++y)
        for (std::int64_t z = first.z(); z <= last.z(); ++z) entries.emplace_back(key_of({x, y, z}), i);
  }
  std::sort(entries.begin(), entries.end());
  for (const auto& [key, point] : entries) {
    cells_.try_emplace(key, in_.size(), in_.size()).first->second.second = in_.size() + 1;
    in_.push_back(point);
  }
}

AxisGrid::Cell AxisGrid::cell_of(const Vector3d& p) const {
  const Cell cell(((p - low_) / size_).array().floor().cast<std::int64_t>());
  return cell.cwiseMax(0).cwiseMin(last_);
}

std::uint64_t AxisGrid::key_of(const Cell& cell) const {
  return static_cast<std::uint64_t>((cell.x() * (last_.y() + 1) + cell.y()) * (last_.z() + 1) + cell.z());
}

/// The part of the axis that is in the grid.
std::optional<AxisGrid::Part> AxisGrid::part_within(const Vector3d& from, const Vector3d& axis,
                                                    double range) const {
  Part part{0, range};
  for (int k = 0; k < 3; ++k) {
    if (axis[k] == 0 && (from[k] < low_[k] || from[k] > high_[k])) return std::nullopt;
    if (axis[k] == 0) continue;
    const auto [enter, leave] = std::minmax({(low_[k] - from[k]) / axis[k], (high_[k] - from[k]) / axis[k]});
    part = {std::max(part.first, enter), std::min(part.second, leave)};
  }
  if (part.first > part.second) return std::nullopt;
  return part;
}

void AxisGrid::look(const Cell& cell, const Vector3d& from, const Vector3d& axis, double range,
                    std::optional<Found>& best) const {
  const auto found = cells_.find(key_of(cell));
  if (found == cells_.end()) return;
  for (std::size_t i = found->second.first; i < found->second.second; ++i) {
    const Vector3d way = points_[in_[i]] - from;
    const double distance = way.dot(axis);
    if (distance < 0 || distance > (best ? best->distance : range)) continue;
    if (best && distance == best->distance) continue;
    if ((way - distance * axis).squaredNorm() <= epsilon_ * epsilon_) best = Found{in_[i], distance};
  }
}

std::optional<AxisGrid::Found> AxisGrid::first(const Vector3d& from, const Vector3d& axis,
                                               double range) const {
  const auto part = part_within(from, axis, range);
  if (!part) return std::nullopt;
  Cell cell = cell_of(from + part->first * axis);
  Vector3d leave, across;  // where the axis leaves the cell in each direction; from wall to wall
  for (int k = 0; k < 3; ++k) {
    const double wall = low_[k] + size_ * static_cast<double>(cell[k] + (axis[k] > 0));
    leave[k] = axis[k] == 0 ? std::numeric_limits<double>::infinity() : (wall - from[k]) / axis[k];
    across[k] = axis[k] == 0 ? 0 : size_ / std::abs(axis[k]);
  }
  std::optional<Found> best;
  for (;;) {
    look(cell, from, axis, range, best);
    int k = 0;
    const double end = leave.minCoeff(&k);
    if (best && best->distance <= end) return best;  // farther cells have only farther points
    cell[k] += axis[k] > 0 ? 1 : -1;
    leave[k] += across[k];
    if (end > part->second || cell[k] < 0 || cell[k] > last_[k]) return best;
  }
}

bool AxisGrid::meets(const Vector3d& centre, double radius) const {
  const auto is_within = [&](std::size_t i) { return (points_[i] - centre).norm() <= radius; };
  const Vector3d low = (centre.array() - radius).matrix().cwiseMax(low_);
  const Vector3d high = (centre.array() + radius).matrix().cwiseMin(high_);
  if ((low.array() > high.array()).any()) return false;
  const Cell first = cell_of(low), last = cell_of(high);
  for (std::int64_t x = first.x(); x <= last.x(); ++x)
    for (std::int64_t y = first.y(); y <= last.y(); ++y)
      for (std::int64_t z = first.z(); z <= last.z(); ++z) {
        const auto found = cells_.find(key_of({x, y, z}));
        if (found == cells_.end()) continue;
        const auto [from, to] = found->second;
        if (std::any_of(in_.begin() + static_cast<std::ptrdiff_t>(from),
                        in_.begin() + static_cast<std::ptrdiff_t>(to), is_within))
          return true;
      }
  return false;
}

}  // namespace limpet::simulation
