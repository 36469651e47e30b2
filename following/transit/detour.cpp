// Copyright the limpet authors. GPL-3.0-or-later.
#include "detour_internal.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <queue>
#include <tuple>

namespace limpet::following::internal {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr int kReach = 12;   ///< spacings
constexpr int kNearer = 6;   ///< spacings nearer to the end: far enough
constexpr int kMost = 8000;  ///< motions that are looked at

/// A motion to a place that is yet to be looked at: places are reached first by the shortest way (A*).
struct Step {
  double bound;    ///< on the length of a whole way through the place
  long order;      ///< breaks ties
  double length;   ///< of the way so far
  Vector3i place;  ///< on the lattice
  Vector3i before;

  bool operator<(const Step& other) const {
    return std::tie(bound, order) > std::tie(other.bound, other.order);
  }
};

struct Before {
  bool operator()(const Vector3i& a, const Vector3i& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
};

class Search {
 public:
  Search(const model::View& view, const Clearance& clearance, const Vector3d& from, const Vector3d& to,
         double spacing)
      : view_(view), clearance_(clearance), from_(from), to_(to), spacing_(spacing) {}

  std::vector<Vector3d> way() {
    if (clearance_.is_clear(view_, from_, to_)) return {to_};
    const bool is_near = distance(Vector3i::Zero()) <= kNearer * spacing_;
    if (is_near && !is_clear(to_)) return {};
    put(Vector3i::Zero(), Vector3i::Zero(), 0);
    for (int looked = 0; looked < kMost && !steps_.empty(); ++looked) {
      const Step step = steps_.top();
      steps_.pop();
      if (before_.contains(step.place)) continue;
      const bool is_first = step.place.isZero();
      if (!is_first && !clearance_.is_clear(view_, at(step.before), at(step.place))) continue;
      before_.emplace(step.place, step.before);
      if (clearance_.is_clear(view_, at(step.place), to_)) return way_over(step.place, true);
      if (distance(step.place) < distance(Vector3i::Zero()) - kNearer * spacing_)
        return way_over(step.place, false);
      put_neighbours(step);
    }
    return {};
  }

 private:
  bool is_clear(const Vector3d& place) const {
    return clearance_.at(view_, place, clearance_.least()) >= clearance_.least();
  }
  Vector3d at(const Vector3i& place) const { return from_ + spacing_ * place.cast<double>(); }

  double distance(const Vector3i& place) const { return (at(place) - to_).norm(); }

  void put(const Vector3i& place, const Vector3i& before, double length) {
    steps_.push({length + distance(place), ++order_, length, place, before});
  }

  void put_neighbours(const Step& step) {
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          const Vector3i way(x, y, z), place = step.place + way;
          if (place.cwiseAbs().maxCoeff() <= kReach && !before_.contains(place))
            put(place, step.place, step.length + spacing_ * way.cast<double>().norm());
        }
  }

  std::vector<Vector3d> way_over(Vector3i place, bool reaches_end) const {
    std::vector<Vector3d> way;
    if (reaches_end) way.push_back(to_);
    for (; !place.isZero(); place = before_.at(place)) way.push_back(at(place));
    std::reverse(way.begin(), way.end());
    return way;
  }

  const model::View& view_;
  const Clearance& clearance_;
  Vector3d from_, to_;
  double spacing_;
  std::priority_queue<Step> steps_;
  std::map<Vector3i, Vector3i, Before> before_;
  long order_ = 0;
};

}  // namespace

std::vector<Vector3d> detour(const model::View& view, const Clearance& clearance, const Vector3d& from,
                             const Vector3d& to, double spacing) {
  return Search(view, clearance, from, to, spacing).way();
}

}  // namespace limpet::following::internal
