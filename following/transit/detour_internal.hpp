// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/following/clearance.hpp>
#include <limpet/model/view.hpp>
#include <vector>

namespace limpet::following::internal {

/// A way from one place to another round what is in the way, over a lattice of the given spacing around the
/// first, up to 12 spacings away: its places, first to last, without `from`. It ends at `to`, or, where that
/// is more than 6 spacings away, 6 spacings nearer to it. Empty when there is none. Any two places that
/// follow each other are connected by a clear motion (Clearance::is_clear).
///
/// Hart, Nilsson & Raphael 1968 (A*).
std::vector<Eigen::Vector3d> detour(const model::View&, const Clearance&, const Eigen::Vector3d& from,
                                    const Eigen::Vector3d& to, double spacing);

}  // namespace limpet::following::internal
