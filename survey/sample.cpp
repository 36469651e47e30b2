// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/sample.hpp>

#include <bit>
#include <iterator>

namespace limpet::survey {
namespace {

/// The last step of splitmix64: each bit of the result depends on all of the word.
std::uint64_t mixed(std::uint64_t word) {
  word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9u;
  word = (word ^ (word >> 27)) * 0x94d049bb133111ebu;
  return word ^ (word >> 31);
}

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
  if (key > greatest_) {
    has_left_out_ = true;
    return;
  }
  by_hash_.try_emplace(key, point);
  if (by_hash_.size() > size_) {
    by_hash_.erase(std::prev(by_hash_.end()));
    has_left_out_ = true;
  }
  if (by_hash_.size() == size_) greatest_ = by_hash_.rbegin()->first;
}

std::vector<model::SensorPoint> PositionSample::points() const {
  std::vector<model::SensorPoint> points;
  points.reserve(by_hash_.size());
  for (const auto& [key, point] : by_hash_) points.push_back(point);
  return points;
}

double PositionSample::count() const {
  const auto kept = static_cast<double>(by_hash_.size());
  if (!has_left_out_) return kept;
  // The hashes of n positions cut 0 … 2⁶⁴ into n + 1 parts of equal mean length.
  return (kept - 1) / (static_cast<double>(by_hash_.rbegin()->first) * 0x1p-64);
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

double Sample::weight() const {
  if (points_.empty()) return 1;
  if (has_copies()) return positions_.count() / static_cast<double>(positions_.size());
  return static_cast<double>(count_) / static_cast<double>(points_.size());
}

bool Sample::has_copies() const {
  constexpr double kFew = 0.05;  // seven times as far as the number of positions may be off
  return positions_.count() < (1 - kFew) * static_cast<double>(count_);
}

}  // namespace limpet::survey
