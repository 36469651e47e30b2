// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limpet/evaluation/road_map_internal.hpp>
#include <map>
#include <queue>

namespace limpet::evaluation {
namespace {

constexpr std::size_t kRoads = 12;  // out of each place: more hardly shorten a tour
constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

RoadMap::RoadMap(const std::vector<Eigen::Vector3d>& places, const TrueSurface& truth, const FreeSpace& space)
    : places_(places), truth_(truth), space_(space), roads_(places.size()) {
  join_near();
  join_components();
  for (auto& roads : roads_)
    std::stable_sort(roads.begin(), roads.end(),
                     [](const Road& a, const Road& b) { return a.length < b.length; });
}

void RoadMap::add(std::size_t a, std::size_t b, double length) {
  const auto is_there = [b](const Road& road) { return road.to == b; };
  if (std::any_of(roads_[a].begin(), roads_[a].end(), is_there)) return;
  roads_[a].push_back({b, length});
  roads_[b].push_back({a, length});
}

void RoadMap::join_near() {
  std::vector<std::pair<double, std::size_t>> others;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    others.clear();
    for (std::size_t j = 0; j < places_.size(); ++j)
      if (j != i) others.emplace_back((places_[j] - places_[i]).norm(), j);
    const auto end = others.begin() + static_cast<std::ptrdiff_t>(std::min(3 * kRoads, others.size()));
    std::partial_sort(others.begin(), end, others.end());
    std::size_t count = 0;
    for (auto other = others.begin(); other != end && count < kRoads; ++other) {
      if (!truth_.keeps(places_[i], places_[other->second], space_.clearance())) continue;
      add(i, other->second, other->first);
      ++count;
    }
  }
}

/// For each place the lowest one that it hangs together with.
std::vector<std::size_t> RoadMap::component_of() const {
  std::vector<std::size_t> component(places_.size(), places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    std::vector<std::size_t> open{i};
    while (!open.empty()) {
      const std::size_t place = open.back();
      open.pop_back();
      if (component[place] <= i) continue;
      component[place] = i;
      for (const Road& road : roads_[place]) open.push_back(road.to);
    }
  }
  return component;
}

/// Joins every component to that of place 0, by way of the pair of places that are nearest to each other.
void RoadMap::join_components() {
  std::vector<std::size_t> component = component_of();
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (component[i] == 0) continue;
    const std::size_t own = component[i];
    std::pair<std::size_t, std::size_t> pair{i, 0};
    double least = kInfinite;
    for (std::size_t a = i; a < places_.size(); ++a) {
      if (component[a] != own) continue;
      for (std::size_t b = 0; b < places_.size(); ++b) {
        if (component[b] != 0) continue;
        const double distance = (places_[a] - places_[b]).norm();
        if (distance < least) least = distance, pair = {a, b};
      }
    }
    const double length = length_of(space_.way(places_[pair.first], places_[pair.second]));
    if (length > 0) add(pair.first, pair.second, length);
    for (std::size_t& c : component)
      if (c == own) c = 0;
  }
}

RoadMap::Road RoadMap::nearest(std::size_t from, const std::function<bool(std::size_t)>& wanted,
                               double limit) const {
  using Entry = std::pair<double, std::size_t>;
  std::map<std::size_t, double> best{{from, 0.0}};
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  open.emplace(0.0, from);
  while (!open.empty()) {
    const auto [length, place] = open.top();
    open.pop();
    if (length >= limit) break;
    if (length > best.at(place)) continue;
    if (place != from && wanted(place)) return {place, length};
    for (const Road& road : roads_[place]) {
      const auto [known, is_new] = best.try_emplace(road.to, length + road.length);
      if (!is_new && known->second <= length + road.length) continue;
      known->second = length + road.length;
      open.emplace(known->second, road.to);
    }
  }
  return {from, kInfinite};
}

double RoadMap::length(std::size_t a, std::size_t b, double limit) const {
  const double straight = (places_[a] - places_[b]).norm();
  if (straight >= limit) return kInfinite;
  for (const Road& road : roads_[a])
    if (road.to == b) return road.length < limit ? road.length : kInfinite;
  if (truth_.keeps(places_[a], places_[b], space_.clearance())) return straight;
  return nearest(
             a, [b](std::size_t place) { return place == b; }, limit)
      .length;
}

}  // namespace limpet::evaluation
