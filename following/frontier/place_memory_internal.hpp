// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>

#include <limpet/following/space_hash_internal.hpp>

namespace limpet::following::internal {

/// What is remembered of places where surface was expected, facing a given way. Places are remembered and not
/// edges, because the edges near a place change all the time.
class PlaceMemory {
 public:
  explicit PlaceMemory(double resolution) : places_(resolution), near_(0.4 * resolution) {}

  /// What has been tried at a place.
  struct Tries {
    int empty = 0;    ///< steps at which a ray went through it and met nothing there
    int failed = 0;   ///< rays aimed at it that neither met it nor went through it
    int blocked = 0;  ///< no position to aim from could be reached
    int aimed = 0;    ///< steps towards positions to aim from, after which it still was to be felt

    bool is_empty() const { return empty >= kEmpty; }
    bool is_blocked() const { return blocked >= kBlocked || aimed >= kAimed; }
    bool is_given_up() const { return failed >= kFailed || is_blocked(); }
  };
  static constexpr int kEmpty = 2, kFailed = 3, kBlocked = 4, kAimed = 24;

  /// The tries at the place nearest to `at` that faces about the same way; all zero when there is none near.
  Tries at(const Eigen::Vector3d& at, const Eigen::Vector3d& normal) const;
  void note_empty(const Eigen::Vector3d& at, const Eigen::Vector3d& normal) { ++tries(at, normal).empty; }
  void note_failed(const Eigen::Vector3d& at, const Eigen::Vector3d& normal) { ++tries(at, normal).failed; }
  void note_blocked(const Eigen::Vector3d& at, const Eigen::Vector3d& normal) { ++tries(at, normal).blocked; }
  /// It need not be tried again until what was blocked is forgotten.
  void note_out_of_reach(const Eigen::Vector3d& at, const Eigen::Vector3d& normal) {
    tries(at, normal).blocked += kBlocked;
  }
  /// What was blocked is to be tried again.
  void forget_blocked() {
    for (Tries& tries : tries_) tries.blocked = tries.aimed = 0;
  }
  /// The same for what is within `reach` of a place.
  void forget_blocked(const Eigen::Vector3d& at, double reach) {
    places_.for_each_within(at, reach, [&](const Eigen::Vector3d&, const Place& place) {
      tries_[place.index].blocked = tries_[place.index].aimed = 0;
    });
  }
  void note_aimed(const Eigen::Vector3d& at, const Eigen::Vector3d& normal) { ++tries(at, normal).aimed; }

 private:
  struct Place {
    Eigen::Vector3d normal;
    std::size_t index;
  };
  /// Index into tries_ of the place near this one; none: tries_.size().
  std::size_t find(const Eigen::Vector3d& at, const Eigen::Vector3d& normal) const;
  Tries& tries(const Eigen::Vector3d& at, const Eigen::Vector3d& normal);

  SpaceHash<Place> places_;
  std::vector<Tries> tries_;
  double near_;
};

}  // namespace limpet::following::internal
