// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/short_tour.hpp>

#include <algorithm>
#include <limpet/evaluation/road_map_internal.hpp>

namespace limpet::evaluation {
namespace {

constexpr double kLeastGain = 1e-9;  // of a tour's leg: less is rounding

ShortTour by_nearest_neighbour(const RoadMap& map, std::size_t places) {
  ShortTour tour{{0}, {}, {}};
  std::vector<char> visited(places, 0);
  visited[0] = 1;
  for (;;) {
    const auto next = map.nearest(
        tour.order.back(), [&](std::size_t place) { return visited[place] == 0; },
        std::numeric_limits<double>::infinity());
    if (next.to == tour.order.back()) break;
    visited[next.to] = 1;
    tour.order.push_back(next.to);
    tour.legs.push_back(map.length(tour.order[tour.order.size() - 2], next.to));
  }
  for (std::size_t i = 0; i < places; ++i)
    if (!visited[i]) tour.lonely.push_back(i);
  return tour;
}

/// Two legs of a tour, (a, b) and (c, d) in its order, become (a, c) and (b, d): what lies between is turned.
class TwoOpt {
 public:
  TwoOpt(const RoadMap& map, ShortTour& tour, std::size_t places)
      : map_(map), order_(tour.order), legs_(tour.legs), at_(places, places) {
    for (std::size_t i = 0; i < order_.size(); ++i) at_[order_[i]] = i;
  }

  /// Goes once over all legs; did that gain anything?
  bool improve() {
    bool improved = false;
    for (std::size_t i = 0; i + 1 < order_.size(); ++i)
      while (improve_from(i) || improve_to(i)) improved = true;
    return improved;
  }

 private:
  /// Looks for a better successor of the place at i.
  bool improve_from(std::size_t i) {
    for (const RoadMap::Road& road : map_.roads(order_[i])) {
      if (road.length >= legs_[i]) break;
      const std::size_t j = at_[road.to];
      if (j >= order_.size() || j == i) continue;
      if (exchange(std::min(i, j), std::max(i, j))) return true;
    }
    return false;
  }

  /// Looks for a better predecessor of the place at i + 1.
  bool improve_to(std::size_t i) {
    for (const RoadMap::Road& road : map_.roads(order_[i + 1])) {
      if (road.length >= legs_[i]) break;
      const std::size_t j = at_[road.to];
      if (j >= order_.size() || j == 0 || j == i + 1) continue;
      if (exchange(std::min(i, j - 1), std::max(i, j - 1))) return true;
    }
    return false;
  }

  /// Turns order[i + 1 … j] if that makes the tour shorter.
  bool exchange(std::size_t i, std::size_t j) {
    const bool has_end = j + 1 == order_.size();  // the last place has no leg beyond
    const double before = legs_[i] + (has_end ? 0 : legs_[j]) - kLeastGain;
    const double first = map_.length(order_[i], order_[j], before);
    if (first >= before) return false;
    const double second = has_end ? 0 : map_.length(order_[i + 1], order_[j + 1], before - first);
    if (first + second >= before) return false;
    std::reverse(order_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                 order_.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    std::reverse(legs_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                 legs_.begin() + static_cast<std::ptrdiff_t>(j));
    legs_[i] = first;
    if (!has_end) legs_[j] = second;
    for (std::size_t k = i + 1; k <= j; ++k) at_[order_[k]] = k;
    return true;
  }

  const RoadMap& map_;
  std::vector<std::size_t>& order_;
  std::vector<double>& legs_;
  std::vector<std::size_t> at_;  ///< where each place is in the order
};

}  // namespace

ShortTour short_tour(const std::vector<Eigen::Vector3d>& places, const TrueSurface& truth,
                     const FreeSpace& space) {
  if (places.empty()) return {};
  const RoadMap map(places, truth, space);
  ShortTour tour = by_nearest_neighbour(map, places.size());
  TwoOpt two_opt(map, tour, places.size());
  while (two_opt.improve()) {
  }
  return tour;
}

}  // namespace limpet::evaluation
