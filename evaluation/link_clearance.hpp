// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <limpet/evaluation/true_surface.hpp>
#include <limpet/kinematics/posture.hpp>
#include <memory>
#include <optional>
#include <span>

namespace limpet::evaluation {

/// How near a robot's links came to the true surface, and to each other. Lengths are in the scan's unit.
struct LinkClearance {
  double to_surface =
      std::numeric_limits<double>::infinity();                 ///< smallest; negative: a link reached into it
  double to_itself = std::numeric_limits<double>::infinity();  ///< smallest between links that are not joined
  std::size_t worst = 0;  ///< the step, from configuration `worst` to the next, with the smallest to_surface
  std::size_t worst_link = 0;                  ///< and the link
  std::array<std::size_t, 2> nearest_links{};  ///< the links with the smallest to_itself
  std::size_t collisions = 0;                  ///< steps on which a link touched the surface
  std::size_t self_collisions = 0;             ///< steps on which links touched each other
};

/// Measures steps of all links that a joint moves, as link_clearance() does, one by one while they are made.
class LinkWatch {
 public:
  /// The robot and the truth must outlive it. Links that overlap in the configuration `first`, or when
  /// all joints are at rest (at 0, or at the limit nearest to it), are taken to be made so.
  LinkWatch(const kinematics::Robot&, const TrueSurface& truth, double fineness,
            const kinematics::Configuration& first);
  ~LinkWatch();

  /// Of the step from one configuration to another; `worst` is 0.
  LinkClearance measure(const kinematics::Configuration& from, const kinematics::Configuration& to) const;
  /// The same when the step collides, else nothing; cheaper where all is too far off to be touched.
  std::optional<LinkClearance> touched(const kinematics::Configuration& from,
                                       const kinematics::Configuration& to) const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

/// Measures all links that a joint moves along a way that is straight in joint space from each configuration
/// to the next. Looks at places on the way between which no part moves more than `fineness`: to_surface and
/// to_itself are too large by half of that at most. What touches by the robot's make
/// is not looked at: parts of one rigid body or of two that a joint joins, and what overlaps in the first
/// configuration or when all joints are at rest.
LinkClearance link_clearance(const kinematics::Robot&, std::span<const kinematics::Configuration> way,
                             const TrueSurface& truth, double fineness);

}  // namespace limpet::evaluation
