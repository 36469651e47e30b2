// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/sample.hpp>

#include <algorithm>
#include <bit>
#include <utility>

namespace limpet::survey {
namespace {

/// Uniform over all of its range, whatever lattice the positions lie on; the same for both zeros.
std::uint64_t hash(const Eigen::Vector3d& position) {
  std::uint64_t result = 0;
  for (int i = 0; i < 3; ++i)
    result = mixed(result + 0x9e3779b97f4a7c15u + std::bit_cast<std::uint64_t>(position[i] + 0.0));
  return result;
}

}  // namespace

void PositionSample::add(const model::SensorPoint& point) {
  const std::uint64_t key = hash(point.position);
  if (key > greatest_) return;
  keys_.push_back({key, static_cast<std::uint32_t>(points_.size())});
  points_.push_back(point);
  if (points_.size() >= 2 * size_) tidy();
}

/// Sorted, the first of each hash, and one more than the sample's size where there are so many.
std::vector<PositionSample::Key> PositionSample::least() const {
  std::vector<Key> keys = keys_;
  std::sort(keys.begin(), keys.end());
  const auto same = [](const Key& a, const Key& b) { return a.hash == b.hash; };
  keys.erase(std::unique(keys.begin(), keys.end(), same), keys.end());
  if (keys.size() > size_ + 1) keys.resize(size_ + 1);
  return keys;
}

void PositionSample::tidy() {
  keys_ = least();
  std::vector<model::SensorPoint> kept;
  kept.reserve(2 * size_);
  for (Key& key : keys_) {
    kept.push_back(points_[key.index]);
    key.index = static_cast<std::uint32_t>(kept.size() - 1);
  }
  points_ = std::move(kept);
  if (keys_.size() > size_) greatest_ = keys_.back().hash;
}

PositionSample::Result PositionSample::result() const {
  std::vector<Key> keys = least();
  Result result{{}, static_cast<double>(keys.size())};
  if (keys.size() > size_) {
    // The hashes of n positions cut 0 … 2⁶⁴ into n + 1 parts of equal mean length.
    result.positions = static_cast<double>(size_) / (static_cast<double>(keys.back().hash) * 0x1p-64);
    keys.pop_back();
  }
  for (const Key& key : keys) result.points.push_back(points_[key.index]);
  return result;
}

void Sample::add(const model::SensorPoint& point) {
  ++count_;
  positions_.add(point);
  if (points_.size() < size_) {
    points_.push_back(point);
  } else if (const auto at = random_.below(static_cast<std::uint64_t>(count_)); at < size_) {
    points_[at] = point;
  }
}

Sampled Sample::result() const {
  constexpr double kFew = 0.05;  // seven times as far as the number of positions may be off
  const auto weight = [](double all, const std::vector<model::SensorPoint>& points) {
    return points.empty() ? 1 : all / static_cast<double>(points.size());
  };
  const auto count = static_cast<double>(count_);
  PositionSample::Result places = positions_.result();
  if (places.positions < (1 - kFew) * count) {
    const double each = weight(places.positions, places.points);
    return {std::move(places.points), each, count_, true};
  }
  return {points_, weight(count, points_), count_, false};
}

}  // namespace limpet::survey
