// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/collision_watch.hpp>

#include <limpet/io/text.hpp>

namespace limpet::app {
namespace {

using kinematics::Configuration;
using kinematics::Posture;

std::string name_of_link(const kinematics::Robot& robot, std::size_t link) {
  return robot.links[link].name.empty() ? "link " + std::to_string(link)
                                        : "link '" + robot.links[link].name + "'";
}

}  // namespace

std::string text_of(const Collision& collision) {
  const std::string how = collision.depth > 0 ? " reached " + io::short_text(collision.depth) + " into "
                                              : std::string(" touched ");
  return collision.part + how + collision.with + " at set " + std::to_string(collision.set);
}

CollisionWatch::CollisionWatch(const kinematics::Robot& robot, const simulation::Mesh& truth, bool with_links,
                               double fineness)
    : robot_(robot), truth_(truth), with_links_(with_links), fineness_(fineness) {}

std::optional<Collision> CollisionWatch::look(const Configuration& at) {
  ++sets_;
  if (with_links_ && !links_) links_ = std::make_unique<evaluation::LinkWatch>(robot_, truth_, fineness_, at);
  std::optional<Collision> found;
  if (before_) found = of_links(at);
  if (before_ && !found &&
      truth_.meets(Posture(robot_, *before_).control_point(), Posture(robot_, at).control_point()))
    found = Collision{sets_, "the control point", "the surface", 0};
  before_ = at;
  return found;
}

std::optional<Collision> CollisionWatch::of_links(const Configuration& at) {
  if (!links_) return std::nullopt;
  const auto touched = links_->touched(*before_, at);
  if (!touched) return std::nullopt;
  if (touched->collisions > 0)
    return Collision{sets_, name_of_link(robot_, touched->worst_link), "the surface", -touched->to_surface};
  const auto [first, second] = touched->nearest_links;
  return Collision{sets_, name_of_link(robot_, first), name_of_link(robot_, second), -touched->to_itself};
}

}  // namespace limpet::app
