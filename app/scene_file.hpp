// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limpet/app/arguments.hpp>
#include <limpet/app/arm_placement.hpp>
#include <limpet/following/follower.hpp>
#include <limpet/following/links/link_motion.hpp>
#include <limpet/simulation/placement.hpp>
#include <limpet/simulation/sensing.hpp>
#include <limpet/simulation/world_description.hpp>
#include <limpet/survey/noise_law.hpp>
#include <optional>
#include <string>

namespace limpet::app {

/// The robot of a scene.
struct SceneRobot {
  /// "point", "arm", or the path of a URDF or a robot file.
  std::optional<std::string> kind;
  std::optional<following::Redundancy> avoidance;  ///< how an arm's links are kept off the surface
  std::optional<double> gain, influence;           ///< α and √(2 d₀) of (4); the latter in scan's unit
  std::optional<int> exponent;                     ///< g of (4)
  std::optional<ObjectPlace> object_place;         ///< where the object is, as seen from an arm
  std::optional<LinkSensors> link_sensors;         ///< of an arm
  std::vector<std::string> package_paths;          ///< where what the robot's file names is sought
  std::optional<double> sensing_range;             ///< scan's unit
  std::optional<double> ceiling;                   ///< γ of prismatic joints, scan's unit
  std::optional<double> ceiling_rad;               ///< γ of revolute joints
  simulation::Turn heading;
};

/// The parameters of modelling and following in a scene.
struct SceneParameters {
  std::optional<double> resolution;              ///< λ
  std::optional<double> angle_rad;               ///< μ
  std::optional<survey::NoiseLaw> noise;         ///< that the model expects
  std::optional<double> tolerance;               ///< how far a surface may be from its plane
  std::optional<RedundancyArgument> redundancy;  ///< ψ and φ
  std::optional<double> follow_distance;         ///< δ
  std::optional<double> step;                    ///< σ_max
  std::optional<double> stray;                   ///< ρ
  std::optional<int> period;                     ///< τ
};

/// What a run of `limpet follow` is about: SCENE on its command line. What is not given is left to the
/// caller.
struct SceneFile {
  simulation::WorldDescription world;
  SceneRobot robot;
  SceneParameters parameters;
  simulation::SensingErrors errors;  ///< seed: `seed`, where it is given
  std::optional<Eigen::Vector3d> start;
  std::optional<following::Strategy> strategy;
  std::optional<std::uint64_t> seed;
  std::optional<std::int64_t> max_sets;
};

/// The scene of this name: a shape's name, a mesh file, or a `.toml` file as docs/scenes.md describes it, in
/// which the names of files are relative to its folder. Throws io::InputError, in one line: for a scene file,
/// with its name, the line, and what to do; UsageError when the name is none of the three.
SceneFile read_scene(const std::string& scene);

/// The same for the text of a scene file. `path`: for messages, and for the folder of the files it names.
SceneFile parse_scene(const std::string& text, const std::string& path);

}  // namespace limpet::app
