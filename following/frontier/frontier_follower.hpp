// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/following/follower.hpp>
#include <memory>

namespace limpet::following {

/// The strategy `frontier`: wherever surface is expected outside an open edge, and not known to be missing,
/// is a target. The control point goes to where its sensing axes meet most targets and new ground for the
/// steps it takes; when no target is near, it travels over places it has visited to the nearest where there
/// is one.
std::unique_ptr<Follower> make_frontier_follower(const Parameters&,
                                                 std::unique_ptr<LinkMotion> links = nullptr);

}  // namespace limpet::following
