// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace limpet::simulation {

/// Finds the first of many points that is near an axis. Each cell of a grid knows all points within ε of it,
/// so whoever walks along an axis, from cell to cell, meets all points that are near the axis.
class AxisGrid {
 public:
  /// Precondition: there is a point, all are finite, ε is positive and finite. The points must outlive it.
  AxisGrid(const std::vector<Eigen::Vector3d>& points, double epsilon);

  struct Found {
    std::size_t point = 0;
    double distance = 0;  ///< along the axis
  };
  /// Of the points within ε of the axis and 0 to `range` along it, the one with the smallest distance (one of
  /// them, always the same, when there are several). Precondition: `axis` is a unit vector.
  std::optional<Found> first(const Eigen::Vector3d& from, const Eigen::Vector3d& axis, double range) const;
  /// Is any point within this ball? Precondition: the radius is not negative.
  bool meets(const Eigen::Vector3d& centre, double radius) const;

 private:
  using Cell = Eigen::Matrix<std::int64_t, 3, 1>;
  using Part = std::pair<double, double>;  ///< of an axis, from … to

  Cell cell_of(const Eigen::Vector3d&) const;
  std::uint64_t key_of(const Cell&) const;
  std::optional<Part> part_within(const Eigen::Vector3d& from, const Eigen::Vector3d& axis,
                                  double range) const;
  void look(const Cell&, const Eigen::Vector3d& from, const Eigen::Vector3d& axis, double range,
            std::optional<Found>&) const;

  const std::vector<Eigen::Vector3d>& points_;
  double epsilon_;
  double size_ = 0;              ///< of a cell
  Eigen::Vector3d low_, high_;   ///< of the grid
  Cell last_;                    ///< the cell at its high corner
  std::vector<std::size_t> in_;  ///< the points of all cells, cell by cell
  std::unordered_map<std::uint64_t, std::pair<std::size_t, std::size_t>> cells_;  ///< where in in_: from, to
};

}  // namespace limpet::simulation
