// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/evaluation/arm_planner_internal.hpp>
#include <limpet/evaluation/arm_reachable.hpp>
#include <limpet/evaluation/arm_sight_internal.hpp>
#include <optional>
#include <vector>

namespace limpet::evaluation {

/// Looks for configurations that see samples, in a roadmap that grows on the way.
class ArmSearch {
 public:
  using Node = ArmRoadmap::Node;
  using Sighting = ArmReachability::Sighting;

  /// All must outlive it.
  ArmSearch(const ArmSpace&, ArmPlanner&, const std::vector<SurfaceSample>&, double spacing,
            const SightOptions&, survey::Random&);

  /// Looks for all samples that are `wanted`, several times, with more effort each time: what was found for
  /// one helps with those beside it.
  void look_for(const std::vector<char>& wanted, const SearchProgress& progress);

  /// How a sample is seen from a node that is reached; none: none was found.
  std::optional<Sighting> sighting(std::size_t sample) const;

 private:
  /// A sensor that meets the surface near a sample, of a node or of a known configuration.
  struct Hint {
    double off = 0;
    bool known = false;
    std::size_t index = 0, sensor = 0;
  };

  void take_hints();
  void take_hints(bool known, std::size_t index);
  void look_by_hints(std::size_t sample);
  void look_from_near(std::size_t sample, std::size_t count);
  void look_from_anywhere(std::size_t sample, int tries);
  bool look_from(const kinematics::Configuration&, const std::vector<Node>& beside, std::size_t sensor,
                 std::size_t sample, bool search);
  std::size_t best_sensor(const kinematics::Configuration&, const SurfaceSample&) const;
  double nearest_for(std::size_t sensor) const;

  const ArmSpace& space_;
  ArmPlanner& planner_;
  const std::vector<SurfaceSample>& samples_;
  double spacing_;
  SightOptions sight_;
  survey::Random& random_;
  std::vector<std::vector<Hint>> hints_;      ///< of each sample, not tried yet; the best last
  std::vector<std::vector<Sighting>> found_;  ///< of each sample: from nodes that may not be reached
  Node hinted_ = 0;                           ///< nodes before this have been looked at for hints
};

}  // namespace limpet::evaluation
