// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <limpet/model/sensor_point.hpp>
#include <limpet/survey/random.hpp>
#include <vector>

namespace limpet::survey {

/// What a sample holds of a stream.
struct Sampled {
  std::vector<model::SensorPoint> points;
  double weight = 1;             ///< how many points of the stream, copies left out, each of these stands for
  std::int64_t count = 0;        ///< points of the stream, copies too
  bool copies_left_out = false;  ///< the stream has so many exact copies that they are left out
};

/// A uniform random sample, of bounded size, of the positions in a stream of points: one that occurs several
/// times counts once. Positions are kept by the least of their hashes, so that neither how often nor in which
/// order they come makes a difference. Of points with the same position the first is kept.
class PositionSample {
 public:
  struct Result {
    std::vector<model::SensorPoint> points;
    double positions = 0;  ///< of the stream: exact up to the sample's size, beyond to about 1/√size of it
  };

  /// Precondition: size > 1.
  explicit PositionSample(std::size_t size) : size_(size) {}
  void add(const model::SensorPoint& point);
  Result result() const;

 private:
  struct Key {
    std::uint64_t hash;
    std::uint32_t index;
    auto operator<=>(const Key&) const = default;
  };
  std::vector<Key> least() const;
  void tidy();

  std::size_t size_;
  std::vector<Key> keys_;                   ///< more than are kept: they are sorted out now and then
  std::vector<model::SensorPoint> points_;  ///< by the keys' indices
  std::uint64_t greatest_ = std::numeric_limits<std::uint64_t>::max();  ///< hash that may still come in
};

/// A uniform random sample, of bounded size, of a stream of points. A stream in which exact copies make out a
/// twentieth of the points or more is sampled by its positions, and any other by its points (reservoir
/// sampling), copies as they are. The seed is fixed, so that the same stream gives the same sample.
class Sample {
 public:
  /// Precondition: size > 1.
  explicit Sample(std::size_t size = 20'000) : size_(size), positions_(size) {}
  void add(const model::SensorPoint& point);
  Sampled result() const;

 private:
  std::size_t size_;
  std::vector<model::SensorPoint> points_;
  PositionSample positions_;
  std::int64_t count_ = 0;
  Random random_{1};
};

}  // namespace limpet::survey
