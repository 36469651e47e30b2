// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/evaluation/link_clearance.hpp>
#include <limpet/evaluation/true_surface.hpp>
#include <limpet/kinematics/posture.hpp>
#include <memory>
#include <optional>
#include <string>

namespace limpet::app {

/// What a robot has run into.
struct Collision {
  std::int64_t set = 0;  ///< that was sensed at the end of the step, counted from 1
  std::string part;      ///< "the control point", or "link 'NAME'"
  std::string with;      ///< "the surface", or another link
  double depth = 0;      ///< how far it reached into that, scan's unit; of a control point 0
};

/// "link 'fore arm' reached 0.0123 into the surface at set 345"
std::string text_of(const Collision&);

/// Watches a run for its first collision, by the true surface: of the control point as
/// evaluation::clearance_of() counts them, and of links as evaluation::link_clearance() does.
class CollisionWatch {
 public:
  /// The robot must outlive it. `with_links`: links can collide; else it is the control point alone.
  /// `fineness`: of link_clearance().
  CollisionWatch(const kinematics::Robot&, const simulation::Mesh& truth, bool with_links, double fineness);

  /// The next set has been sensed in this configuration: has the step to it collided?
  std::optional<Collision> look(const kinematics::Configuration& at);

 private:
  std::optional<Collision> of_links(const kinematics::Configuration& at);

  const kinematics::Robot& robot_;
  const evaluation::TrueSurface truth_;
  const bool with_links_;
  const double fineness_;
  std::unique_ptr<const evaluation::LinkWatch> links_;
  std::optional<kinematics::Configuration> before_;
  std::int64_t sets_ = 0;
};

}  // namespace limpet::app
