// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limpet/app/arguments.hpp>
#include <limpet/app/run_stages.hpp>
#include <limpet/evaluation/label_overlaps.hpp>
#include <limpet/following/follower.hpp>
#include <limpet/following/links/link_motion.hpp>
#include <limpet/model/rules.hpp>
#include <limpet/survey/point_stream.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The commands of the program, each in a file of its own. A command returns its exit code; it throws
/// UsageError, io::InputError, io::OutputError, simulation::MeshError or kinematics::RobotError for what is
/// the caller's to mend.
namespace limpet::app {

/// Exit codes (a contract: scripts rely on them).
enum ExitCode : int {
  kDone = 0,
  kFallsShort =
      1,          ///< a broken invariant, a run that was interrupted, a comparison or evidence out of bounds
  kBadInput = 2,  ///< bad usage, damaged input, output that cannot be written
};

struct ModelArguments {
  std::string scan;
  std::vector<std::string> models;                  ///< where to write the model; the format by extension
  std::optional<survey::ResolutionLaw> resolution;  ///< scan's unit; chosen from the scan when not given
  double angle_deg = 10;
  std::optional<survey::NoiseLaw> noise;  ///< chosen from the scan when not given
  std::optional<double> tolerance;        ///< scan's unit; by noise and resolution when not given
  std::int64_t set_size = survey::kSetSize;
  bool in_arrival_order = false;    ///< as the scan has its points, rather than along a curve
  std::int64_t order_memory = 256;  ///< MB that points to be ordered take in memory at most
  std::optional<Eigen::Vector3d> viewpoint;
  bool orient = false;  ///< find the axes by neighbour consistency, whatever the scan says
  model::Rules rules;
  std::string labels;
  std::string json;
  std::int64_t check_every = 0;  ///< sets; 0: the final model only
  int stages = 0;                ///< models to keep along the way
  std::string initial;           ///< a mesh of faces known beforehand
  bool open = false;             ///< no shared edges, no corner vertices
  RedundancyArgument redundancy;
  std::string checkpoint;                   ///< where all of the run is kept, now and then
  std::int64_t checkpoint_every = 100'000;  ///< sets
  bool resume = false;                      ///< go on from the checkpoint if there is one
  bool quiet = false;
};
int run(const ModelArguments&);

struct FollowArguments {
  std::string scene;                ///< a shape, a mesh file or a scene file (.toml)
  std::vector<std::string> models;  ///< where to write the model; the format by extension
  std::string robot;                ///< point, arm, .urdf or .toml; empty: the scene's, or the point robot
  std::vector<std::string> package_paths;  ///< where what the robot's file names is sought
  std::optional<following::Strategy> strategy;
  std::optional<following::Redundancy> avoidance;  ///< how an arm's links are kept off the surface
  std::optional<LinkSensors> link_sensors;
  std::optional<Eigen::Vector3d> start;
  std::string initial;  ///< a mesh of faces known beforehand
  std::optional<double> resolution, noise, encoder_noise, angle_deg;
  std::optional<RedundancyArgument> redundancy;
  std::optional<std::int64_t> max_sets;
  std::optional<std::uint64_t> seed;
  std::int64_t check_every = 0;   ///< sets; 0: the final model only
  std::string record;             ///< where to record the run; empty: nowhere
  std::string replay;             ///< a recorded run to model again, instead of a scene
  bool count_collisions = false;  ///< a collision does not end the run
  std::string page;               ///< a page of limpet view, to link to in what is said; empty: no links
  std::string json;
  bool quiet = false;
};
int run(const FollowArguments&);
/// `limpet follow --replay RUN`
int run_again(const FollowArguments&);

struct ScanArguments {
  std::string mesh;  ///< the name of a shape, or a mesh file
  std::string scan;
  std::int64_t points = 100'000;
  std::string order = "raster";
  double noise = 0;            ///< scan's unit
  double noise_per_range = 0;  ///< added to it times the range
  double outliers = 0;         ///< a fraction
  std::uint64_t seed = 1;
  std::vector<Eigen::Vector3d> viewpoints;
  bool faces = false;   ///< write the true face of each point too
  bool ranges = false;  ///< and how far it was from its sensor
  bool ascii = false;
  bool quiet = false;
};
int run(const ScanArguments&);

struct CheckArguments {
  std::string model;
  std::string scan{};  ///< the scan it was made of; empty: it is judged by its laws alone
  std::optional<Eigen::Vector3d> viewpoint{};  ///< of the scan, as for `limpet model`
  bool orient = false;                         ///< as for `limpet model`
  std::string page{};                          ///< of limpet view, to link to; empty: no links
  std::string json;
  bool quiet = false;
};
int run(const CheckArguments&);

struct LabelArguments {
  std::string column;  ///< of a scan, that holds the true labels; empty: by its name
  std::optional<std::vector<evaluation::LabelRange>> none;  ///< true labels that stand for no region
  std::string polygons;                      ///< a native model: labels of other segments are none
  double overlap = 0.8;                      ///< share of a region that must agree
  std::int64_t min_true = 1, min_found = 1;  ///< points of the smallest region that counts
  std::optional<double> min_correct;         ///< a bound: share of the true regions that must be correct
};

struct CompareArguments {
  std::string model;                   ///< or, by labels, a list of labels
  std::string truth;                   ///< the name of a shape, or a mesh file; by labels, a list or a scan
  std::optional<double> max_distance;  ///< both ways, scan's unit
  bool faces_exact = false;            ///< as many polygons as true faces
  bool by_labels = false;
  LabelArguments labels;
  std::string json;
  bool quiet = false;
};
int run(const CompareArguments&);
/// `limpet compare LABELS TRUTH --labels`
int run_by_labels(const CompareArguments&);

struct DrawArguments {
  std::vector<std::string> models;  ///< and recorded runs
  RunStages stages;                 ///< of each run
  std::string picture;
  int width = 1600;                    ///< pixels
  std::vector<Eigen::Vector3d> views;  ///< from where to look, as seen from the model
  std::optional<Eigen::Vector3d> up;
  bool quiet = false;
};
int run(const DrawArguments&);

struct ViewArguments {
  std::string source;                ///< a native model or a recorded run
  std::vector<std::string> outputs;  ///< .html, .glb, .vtp; of a run .pvd, too
  std::string truth;                 ///< the name of a shape, or a mesh file; empty: none
  int stages = 100;                  ///< of a run, in a .pvd
  bool times = false;                ///< of each update, as measured now
  bool quiet = false;
};
int run(const ViewArguments&);

}  // namespace limpet::app
