// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/following/links/link_motion.hpp>
#include <limpet/following/links/roadmap.hpp>
#include <optional>
#include <vector>

namespace limpet::following {

/// A way in joint space that leaves a roadmap.
struct JointPlan {
  std::size_t from = 0;                          ///< node of the roadmap
  std::vector<kinematics::Configuration> after;  ///< what comes after it, the goal last
};

/// A way from the roadmap to one of the goals, any two configurations that follow each other being connected
/// (LinkGuard::connects()). First it is looked for in space that was seen to be free, then also where nothing
/// is known: there the robot looks at each step before it makes the next. None: no way is found with a
/// bounded effort. The same calls give the same answer.
///
/// Two trees that grow towards each other (Kuffner & LaValle 2000, RRT-Connect), the one from the roadmap's
/// nodes that are nearest to the goal; places from Halton's sequence, all over the joints' ranges and about
/// both ends in turn.
std::optional<JointPlan> plan_to(const std::vector<kinematics::Configuration>& goals, const LinkMotion&,
                                 const Roadmap&);
/// The same, but not from this node of the roadmap.
std::optional<JointPlan> plan_to_but_from(std::size_t node,
                                          const std::vector<kinematics::Configuration>& goals,
                                          const LinkMotion&, const Roadmap&);
/// The same from this node alone.
std::optional<JointPlan> plan_from(std::size_t node, const std::vector<kinematics::Configuration>& goals,
                                   const LinkMotion&, const Roadmap&);

}  // namespace limpet::following
