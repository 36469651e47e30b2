// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/link_clearance.hpp>

#include <algorithm>
#include <cmath>
#include <limpet/evaluation/moved_body_internal.hpp>
#include <vector>

namespace limpet::evaluation {
namespace {

using kinematics::Configuration;
using kinematics::Posture;
using kinematics::Robot;

class Measuring {
 public:
  Measuring(const Robot& robot, const TrueSurface& truth, const Configuration& first)
      : robot_(robot), truth_(truth), body_(robot, first) {}

  /// The smallest distances in a configuration.
  void look(const Configuration& at) {
    const std::vector<model::Capsule> capsules = body_.in_world(Posture(robot_, at));
    for (std::size_t i = 0; i < capsules.size(); ++i) {
      const double distance = truth_.distance_along(capsules[i].a, capsules[i].b) - capsules[i].radius;
      if (distance < surface_) surface_ = distance, link_ = body_.parts()[i].link;
    }
    for (const auto& [i, j] : body_.pairs())
      itself_ = std::min(itself_, gap_between(capsules[i], capsules[j]));
  }
  void begin() { surface_ = itself_ = std::numeric_limits<double>::infinity(); }
  double surface() const { return surface_; }
  double itself() const { return itself_; }
  std::size_t link() const { return link_; }

  /// The farthest that an end of a part is from where it was.
  double farthest(const Configuration& from, const Configuration& to) const {
    const auto one = body_.in_world(Posture(robot_, from)), other = body_.in_world(Posture(robot_, to));
    double most = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
      most = std::max({most, (one[i].a - other[i].a).norm(), (one[i].b - other[i].b).norm()});
    return most;
  }

 private:
  const Robot& robot_;
  const TrueSurface& truth_;
  MovedBody body_;
  double surface_ = 0, itself_ = 0;
  std::size_t link_ = 0;
};

}  // namespace

LinkClearance link_clearance(const Robot& robot, std::span<const Configuration> way, const TrueSurface& truth,
                             double fineness) {
  LinkClearance result;
  if (way.empty()) return result;
  Measuring measuring(robot, truth, way.front());
  const std::size_t steps = std::max<std::size_t>(1, way.size() - 1);  // of one configuration, it alone
  for (std::size_t i = 0; i < steps; ++i) {
    const Configuration& from = way[i];
    const Configuration& to = way[std::min(i + 1, way.size() - 1)];
    // A turn takes a point by more than its ends are apart: by less than twice, for turns up to half a
    // circle.
    const int pieces = 1 + static_cast<int>(std::ceil(2 * measuring.farthest(from, to) / fineness));
    measuring.begin();
    for (int k = 0; k <= pieces; ++k) measuring.look(from + (to - from) * (static_cast<double>(k) / pieces));
    if (measuring.surface() < result.to_surface)
      result.to_surface = measuring.surface(), result.worst = i, result.worst_link = measuring.link();
    result.to_itself = std::min(result.to_itself, measuring.itself());
    result.collisions += measuring.surface() <= 0;
    result.self_collisions += measuring.itself() <= 0;
  }
  return result;
}

}  // namespace limpet::evaluation
