// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limpet/evaluation/arm_roadmap.hpp>
#include <limpet/evaluation/reachable.hpp>
#include <limpet/evaluation/true_surface.hpp>
#include <limpet/kinematics/posture.hpp>
#include <limpet/simulation/mesh.hpp>
#include <memory>
#include <utility>
#include <vector>

namespace limpet::evaluation {

/// A robot with links, and where it begins.
struct PlacedArm {
  kinematics::Robot robot;
  kinematics::Configuration start;
  /// Configurations that follow each other from the start, as those of a run: what is clear of them is taken
  /// into the roadmap. May be empty.
  std::vector<kinematics::Configuration> known;
  double link_clearance = 0;  ///< as of ArmSearchOptions
  double spared = 0;
};

/// How it is sought what an arm can feel. Lengths in the scan's unit.
struct ArmSearchOptions {
  double resolution = 0;         ///< λ; > 0
  double control_clearance = 0;  ///< δ − λ: of the control point from the surface; > 0
  double link_clearance = 0;     ///< of links from the surface; 0: λ/10
  double spared = 0;  ///< of the control point's link what is this near to it keeps λ/10 only; ≥ 0
  double least_cosine = 0.087;  ///< of the angle of incidence, as in Sensing
  std::uint64_t seed = 1;
};

/// What an arm can feel of the true surface, and how it is known.
struct ArmReachability {
  Reachability reachability;

  /// Of a sample that is reachable: where the robot stands, and with which sensor, when it sees it.
  struct Sighting {
    ArmRoadmap::Node node = 0;
    std::size_t sensor = 0;
  };
  std::vector<Sighting> sightings;  ///< of each sample; of one that is not reachable it says nothing
};

/// Told, often, how far a search is: `done` of `whole` looks for samples are over. The first ones take least.
using SearchProgress = std::function<void(std::int64_t done, std::int64_t whole)>;

/// Finds what an arm can feel. A sample of the surface is
///   - reachable (Verdict::yes) when a configuration is found that the arm gets to from its start over clear
///     configurations, and in which any of its sensors sees the sample: along its axis, within its range,
///     with no more than the largest incidence, nothing between. Clear: the control point keeps δ − λ from
///     the surface, all that joints move keeps the links' clearance from it, links that are not joined keep
///     λ/10 from each other, and joints keep their limits;
///   - ruled out (Verdict::no) when it is out of reach: farther from where the joints begin than sensors get
///     and sense; or, if all sensors are at the control point, when no place from which anything could be
///     seen is one that a point robot gets to (FreeSpace);
///   - else doubtful: a search by sampling does not prove that there is none.
///
/// Searched in a roadmap that grows: from the known configurations and random ones; then, for each sample,
/// from nodes that nearly see it, and from random configurations, by inverse kinematics. A sample takes a
/// fraction of a millisecond where it is seen soon, and some ten milliseconds where it never is. The same
/// calls in the same order give the same results.
class ArmReach {
 public:
  /// All must outlive it. Throws std::invalid_argument if an option is out of range, the robot has no
  /// sensors, or the start is not one of its configurations.
  ArmReach(const simulation::Mesh& mesh, const TrueSurface& truth, const PlacedArm& arm,
           const ArmSearchOptions& options);
  ~ArmReach();

  /// What is reachable of some samples of the mesh, `spacing` apart. Samples that are not `asked` for, if it
  /// says which are, are doubtful unless they are ruled out.
  ArmReachability of(std::vector<SurfaceSample> samples, double spacing, std::vector<char> asked = {},
                     const SearchProgress& progress = {});

  /// With the ways from the start.
  const ArmRoadmap& roadmap() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

/// Samples of a mesh, about `count`, evenly; but at least one a face, unless the faces are more than twice
/// `count`: then some have none. Returns how far apart they are, too. Precondition: count > 0.
std::pair<std::vector<SurfaceSample>, double> about(std::size_t count, const simulation::Mesh& mesh);

}  // namespace limpet::evaluation
