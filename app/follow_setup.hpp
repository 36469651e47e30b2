// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <limpet/app/commands.hpp>
#include <limpet/app/scene_file.hpp>
#include <limpet/following/follower.hpp>
#include <limpet/following/links/link_motion.hpp>
#include <limpet/kinematics/posture.hpp>
#include <limpet/kinematics/robot.hpp>
#include <limpet/model/parameters.hpp>
#include <limpet/simulation/sensing.hpp>
#include <limpet/simulation/world_description.hpp>
#include <optional>
#include <string>

namespace limpet::app {

/// All that a simulated run of following is made of.
struct FollowSetup {
  simulation::BuiltWorld world;
  simulation::SensingErrors errors;
  kinematics::Robot robot;
  std::string chosen_tip;                   ///< of an arm, as RobotFile has it
  Eigen::Vector3d start;                    ///< of the control point
  kinematics::Configuration configuration;  ///< of the robot, there
  /// How its links are kept off the surface; none: it has no links that could come near it.
  std::optional<following::LinkParameters> links;
  model::Parameters model;
  following::Parameters following;
  following::Strategy strategy = following::Strategy::frontier;
  std::int64_t max_sets = 0;
  bool end_at_collision = false;                                 ///< where the true surface is known
  double max_seconds = std::numeric_limits<double>::infinity();  ///< for a run that must not hang
  std::uint64_t seed = 1;
};

/// The scene that the arguments name, with their options put over it. Errors: as of read_scene().
SceneFile scene_of(const FollowArguments&);

/// Puts together what a scene says. What it does not say is chosen: λ by the object (chosen_resolution()),
/// all other lengths by λ as in thesis §4.3, the start at random by the seed. Throws UsageError when lengths
/// do not fit each other (λ < δ < range, σ_max < range, γ·r < range), or something is missing, and what
/// read_scene() and build_world() throw.
FollowSetup make_setup(const SceneFile&);
/// The same for what the scene and the command line say; options of the command line come first.
FollowSetup make_setup(const FollowArguments&);

/// The λ that an object asks for: a quarter of its narrowest place, but from a fortieth to a twentieth of its
/// largest side.
double chosen_resolution(const simulation::Mesh&);

}  // namespace limpet::app
