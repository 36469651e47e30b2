// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limits>
#include <limpet/model/sensor_point.hpp>
#include <limpet/survey/random.hpp>
#include <map>
#include <vector>

namespace limpet::survey {

/// A uniform random sample, of bounded size, of the positions in a stream of points: one that occurs several
/// times counts once. Positions are kept by the least of their hashes, so that neither how often nor in which
/// order they come makes a difference. Of points with the same position the first is kept.
class PositionSample {
 public:
  /// Precondition: size > 1.
  explicit PositionSample(std::size_t size) : size_(size) {}
  void add(const model::SensorPoint& point);
  std::vector<model::SensorPoint> points() const;
  std::size_t size() const { return by_hash_.size(); }
  /// How many positions the stream has: exact up to the sample's size, beyond to about 1/√size of it.
  double count() const;

 private:
  std::size_t size_;
  std::map<std::uint64_t, model::SensorPoint> by_hash_;
  std::uint64_t greatest_ = std::numeric_limits<std::uint64_t>::max();  ///< that may still come in
  bool has_left_out_ = false;
};

/// A uniform random sample, of bounded size, of a stream of points. A stream in which exact copies make out a
/// twentieth of the points or more is sampled by its positions, and any other by its points (reservoir
/// sampling): there, copies count as what they are. The seed is fixed, so that the same stream gives the same
/// sample.
class Sample {
 public:
  explicit Sample(std::size_t size = 20'000) : size_(size), positions_(size) {}
  void add(const model::SensorPoint& point);
  std::vector<model::SensorPoint> points() const { return has_copies() ? positions_.points() : points_; }
  /// Points of the stream so far, copies too.
  std::int64_t count() const { return count_; }
  /// How many points of the stream, or positions where it has copies, one point of the sample stands for.
  double weight() const;
  /// Does the stream have so many exact copies that they are left out?
  bool has_copies() const;

 private:
  std::size_t size_;
  std::vector<model::SensorPoint> points_;
  PositionSample positions_;
  std::int64_t count_ = 0;
  Random random_{1};
};

}  // namespace limpet::survey
