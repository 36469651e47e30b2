// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <limpet/kinematics/posture.hpp>
#include <limpet/model/view.hpp>
#include <utility>
#include <vector>

namespace limpet::evaluation {

/// A capsule of a link that a joint moves, in the link's frame.
struct MovedPart {
  std::size_t link = 0;
  model::Capsule capsule;
};

/// What joints move of a robot, and which of it must not touch, as the judge sees it: it shares no code with
/// what keeps links away in a run, but for where links are.
class MovedBody {
 public:
  /// Parts of one rigid body and of those that are joined, also through some without extent, may touch; and
  /// so may what does in the first configuration, or with all joints at rest (at 0, or the limit nearest to
  /// it): it is taken to be made so.
  MovedBody(const kinematics::Robot&, const kinematics::Configuration& first);

  const std::vector<MovedPart>& parts() const { return parts_; }
  /// Indices of parts that are to be apart.
  const std::vector<std::pair<std::size_t, std::size_t>>& pairs() const { return pairs_; }
  /// The parts in the world, in their order.
  std::vector<model::Capsule> in_world(const kinematics::Posture&) const;

 private:
  std::vector<MovedPart> parts_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

/// Distance between two capsules; negative when they overlap.
double gap_between(const model::Capsule&, const model::Capsule&);

}  // namespace limpet::evaluation
