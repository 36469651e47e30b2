// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <functional>
#include <limpet/following/clearance.hpp>
#include <limpet/model/view.hpp>
#include <vector>

#include <limpet/following/space_hash_internal.hpp>
#include <limpet/following/transit/cheapest_way.hpp>

namespace limpet::following::internal {

/// The places where the control point has been, and between which of them it can go in a straight line.
class Visited {
 public:
  explicit Visited(double resolution)
      : places_(2 * resolution), same_(0.6 * resolution), near_(1.8 * resolution), detour_(10 * resolution) {}

  /// The control point is here now, having come in a straight line.
  void arrive(const model::View&, const Clearance&, const Eigen::Vector3d& here);

  /// The visited place at `to` could not be reached, this time: ways that avoid it are preferred from now on,
  /// from wherever they come.
  void block(const Eigen::Vector3d& to);

  /// The shortest way over visited places to one that is wanted. It begins with the one next to which the
  /// control point is. Empty when there is none.
  std::vector<Eigen::Vector3d> way_to(const std::function<bool(const Eigen::Vector3d&)>& wanted) const;

 private:
  using Link = GraphLink;
  Link* find(std::size_t from, std::size_t to);
  void link(std::size_t a, std::size_t b);

  std::vector<Eigen::Vector3d> nodes_;
  std::vector<std::vector<Link>> links_;  ///< of each node
  SpaceHash<std::size_t> places_;
  std::size_t present_ = 0;
  double same_, near_, detour_;
};

}  // namespace limpet::following::internal
