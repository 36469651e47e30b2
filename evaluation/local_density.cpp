// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limpet/evaluation/local_density_internal.hpp>

namespace limpet::evaluation {
namespace {

constexpr std::int64_t kSquaresAround = 3;

}  // namespace

LocalDensity::Key LocalDensity::key(std::int64_t x, std::int64_t y) {
  return static_cast<Key>(x) << 32 ^ static_cast<Key>(y & 0xffffffff);
}

LocalDensity::LocalDensity(const std::vector<Eigen::Vector2d>& readings, double edge) : edge_(edge) {
  for (const Eigen::Vector2d& reading : readings)
    ++count_[key(std::llround(reading.x() / edge_), std::llround(reading.y() / edge_))];
}

double LocalDensity::density(std::vector<int>& counts) const {
  if (counts.empty()) return 0;
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::nth_element(counts.begin(), middle, counts.end());
  return *middle / (edge_ * edge_);
}

double LocalDensity::at(const Eigen::Vector2d& place) const {
  const std::int64_t x = std::llround(place.x() / edge_), y = std::llround(place.y() / edge_);
  const auto [known, is_new] = known_.try_emplace(key(x, y), 0);
  if (!is_new) return known->second;
  std::vector<int> counts;
  for (std::int64_t dx = -kSquaresAround; dx <= kSquaresAround; ++dx)
    for (std::int64_t dy = -kSquaresAround; dy <= kSquaresAround; ++dy)
      if (const auto found = count_.find(key(x + dx, y + dy)); found != count_.end())
        counts.push_back(found->second);
  return known->second = density(counts);
}

double LocalDensity::overall() const {
  std::vector<int> counts;
  for (const auto& [square, count] : count_) counts.push_back(count);
  return density(counts);
}

}  // namespace limpet::evaluation
