// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <vector>

#include "steering_internal.hpp"
#include "visited_internal.hpp"

namespace limpet::following::internal {

/// Leads the control point to where something is left to be done: over places where it has been. A travel
/// ends: it arrives, or it is given up when it has taken too many steps or has been stopped too often.
class Travel {
 public:
  Travel(double resolution, double step) : visited_(resolution), lambda_(resolution), step_(step) {}

  /// The control point is here now, having come in a straight line. At the goal nothing is under way any
  /// more.
  void arrive(const model::View&, const Clearance&, const Eigen::Vector3d& here);

  /// Begins the shortest way over visited places to one that is wanted, if there is one. Returns whether
  /// there is. Precondition, as for any beginning: arrive() has told where the control point is.
  bool begin(const std::function<bool(const Eigen::Vector3d&)>& wanted);
  /// Begins a straight way.
  void begin(const Eigen::Vector3d& to);
  void stop() { way_.clear(); }
  /// Goes round what has stopped the motion to the next place. Returns whether there is such a way; not when
  /// the motion was on one. If not, the caller is to stop() the travel. Precondition: is_under_way().
  bool go_round(const model::View&, const Clearance&);
  /// Something has been found to do.
  void arrived() { way_.clear(), begin_anew(); }
  bool is_under_way() const { return !way_.empty(); }
  /// Precondition: is_under_way().
  const Eigen::Vector3d& goal() const { return way_.front(); }

  /// The places to go over, from the goal back to the next one. Empty when nothing is under way.
  const std::vector<Eigen::Vector3d>& way_back() const { return way_; }

  enum class Progress {
    good,
    stopped,  ///< another way may do
    hopeless  ///< the goal is to be given up
  };
  /// Looks at how the last motion went. Precondition: is_under_way(). The caller stops what is not good,
  /// unless it can go_round(); hopeless comes after a finite number of looks, however often a way is begun in
  /// between, unless one arrives.
  Progress look(const Eigen::Vector3d& here, bool has_moved);

  /// The next motion. Precondition: is_under_way().
  Eigen::Vector3d next(const Steering&, const Eigen::Vector3d& here);

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  void set_way(std::vector<Eigen::Vector3d> way);
  long steps_for(const std::vector<Eigen::Vector3d>& way) const;
  bool is_on_detour() const { return way_.size() > planned_; }
  void begin_anew() { stops_ = 0, idle_ = 0, nearest_ = kFar; }
  bool comes_no_nearer(const Eigen::Vector3d& here);

  Visited visited_;
  double lambda_, step_;
  Eigen::Vector3d here_ = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> way_;               ///< the next place last
  std::size_t planned_ = 0;                        ///< places of the way; more come of a detour
  long steps_left_ = 0;                            ///< until the goal is given up
  int stops_ = 0;                                  ///< since the last travel that arrived
  Eigen::Vector3d leg_ = Eigen::Vector3d::Zero();  ///< the next place, at the last look
  double nearest_ = kFar;                          ///< that the control point has come to it
  int idle_ = 0;                                   ///< looks since then
};

}  // namespace limpet::following::internal
