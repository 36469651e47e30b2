// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include <limpet/following/clearance.hpp>
#include <limpet/following/intent.hpp>
#include <limpet/following/links/link_motion.hpp>
#include <limpet/following/observation.hpp>
#include <limpet/following/parameters.hpp>
#include <limpet/kinematics/posture.hpp>
#include <limpet/model/model.hpp>
#include <limpet/model/view.hpp>

namespace limpet::following {

/// What a motion is for: the five motion modes of thesis §3.4, and those of `frontier`.
enum class Mode {
  none,
  current_surface,
  current_segment,
  current_edge,
  point,
  gap,
  extend,     ///< frontier: a position from which rays meet targets near open edges
  travel,     ///< frontier: back over positions visited before, to targets elsewhere
  reposition  ///< to another configuration, over a way planned in joint space (thesis §3.4.7)
};
inline constexpr std::size_t kModeCount = 9;
std::string_view name_of(Mode);

/// Why a run is over.
enum class End {
  none,        ///< it is not
  complete,    ///< nothing is left that is neither modelled nor marked
  no_surface,  ///< no surface is within sensing range, and none has been felt
  stopped      ///< the robot cannot move without coming too near, or cannot get away from what is too near
};
std::string_view name_of(End);

/// One motion.
struct Motion {
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();  ///< of the control point; world, scan's unit
  /// Of all joints. Of a robot with links the control point's displacement is what these bring about.
  kinematics::Configuration changes = {};
  Mode mode = Mode::none;
  End end = End::none;
};

/// What a strategy has given up, now.
struct Marks {
  std::vector<model::SegmentId> unreachable_segments;
  std::vector<geometry::EdgeId> unreachable_edges, unclosable_edges;
};

/// Decides where the robot goes next, from the model and the robot alone.
///
///     auto follower = make_follower(Strategy::frontier, parameters, {});
///     for (;;) {
///       const auto readings = robot.sense();
///       const auto& changes = model.update(readings);
///       const Motion motion = follower->next({model, changes, robot.posture(), readings});
///       if (motion.end != End::none) break;
///       robot.move(motion.changes);
///     }
///     model.finish();
///
///  (1) the same observations give the same motions;
///  (2) a motion is no longer than σ_max, and no longer than the robot's ceilings let it be;
///  (3) along the whole of a motion, the control point comes no nearer than δ − λ to the model, to a reading
///      of this set or to one of the recent ones; if it is nearer already, it comes no nearer still. What a
///      robot's links keep is LinkMotion's to say;
///  (4) a run ends: each of a finite number of places is given up after a finite number of steps.
class Follower {
 public:
  /// `links`: moves a robot that has links; none: the control point is all of the robot that can come near
  /// the surface. Throws std::invalid_argument when the parameters are not sound.
  Follower(const Parameters&, std::unique_ptr<LinkMotion> links);
  virtual ~Follower() = default;
  Follower(const Follower&) = delete;
  Follower& operator=(const Follower&) = delete;

  /// The next motion. Precondition: observations come in order, one for each set.
  Motion next(const Observation&);

  const Parameters& parameters() const { return parameters_; }
  virtual Marks marks() const = 0;
  /// What the last motion is part of. `view`: of the model that the follower has seen last, unchanged since.
  virtual Intent intent(const model::View& view) const = 0;
  /// How often the model has been asked what finishing would close (Model::would_finish()), which takes by
  /// far the longest of all that a step may do.
  virtual std::int64_t outcomes_asked() const = 0;
  /// What moves the robot's links; none: it has none.
  const LinkMotion* links() const { return links_.get(); }

 protected:
  /// The motion that the strategy wants: a displacement, which next() shortens to what is clear, and to σ_max
  /// and the ceilings; or changes of the joints, which are to be clear.
  virtual Motion choose(const Observation&) = 0;
  const Clearance& clearance() const { return clearance_; }
  Clearance& clearance() { return clearance_; }
  /// None: of a robot whose motions are not judged.
  LinkMotion* judge() { return links_ && links_->is_checked() ? links_.get() : nullptr; }

 private:
  bool is_too_near_for_long(const Observation&);
  void make(const Observation&, Motion&);

  Parameters parameters_;
  Clearance clearance_;
  std::unique_ptr<LinkMotion> links_;
  int too_near_ = 0;  ///< sets at which the control point has been nearer than δ − λ, up to now
};

enum class Strategy { frontier, thesis };

/// Throws std::invalid_argument when the parameters are not sound.
std::unique_ptr<Follower> make_follower(Strategy, const Parameters&,
                                        std::unique_ptr<LinkMotion> links = nullptr);

}  // namespace limpet::following
