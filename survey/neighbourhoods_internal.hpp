// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstddef>
#include <functional>
#include <limpet/model/sensor_point.hpp>
#include <limpet/survey/sample.hpp>
#include <memory>
#include <vector>

namespace limpet::survey {

/// All points of a sample, or of the scan, that lie within a radius of a centre.
struct Neighbourhood {
  std::vector<model::SensorPoint> points;
  double radius = 0;
  double weight = 1;  ///< points of the scan that each of these stands for
};

/// A sample as a tree, for neighbourhoods of any number of points. The sample has to outlive it.
class SampleTree {
 public:
  explicit SampleTree(const Sampled&);
  ~SampleTree();
  Neighbourhood nearest(const model::SensorPoint& centre, int count) const;

 private:
  struct Tree;
  const Sampled& sample_;
  std::unique_ptr<Tree> tree_;
};

/// Indices of about a thousand points of the sample, whose neighbourhoods are looked at.
std::vector<std::size_t> centres_of(const Sampled&);

/// Fills the neighbourhoods of these centres, whose radii are given, with the points of the scan that lie in
/// them; in a scan with many copies each place counts once.
void collect(const std::function<void(const std::function<void(const model::SensorPoint&)>&)>& pass,
             const Sampled& sample, const std::vector<std::size_t>& centres,
             std::vector<Neighbourhood>& around);

/// The part of a neighbourhood that lies within this radius of its centre.
Neighbourhood within(Neighbourhood around, const Eigen::Vector3d& centre, double radius);

}  // namespace limpet::survey
