// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limpet/evaluation/flat_polygon_internal.hpp>
#include <limpet/evaluation/region.hpp>
#include <limpet/evaluation/resolution_field_internal.hpp>
#include <limpet/model/record.hpp>
#include <limpet/model/sensor_point.hpp>
#include <limpet/survey/noise_law.hpp>
#include <memory>
#include <vector>

namespace limpet::evaluation {

/// A polygon of a model, made ready for readings.
struct Ground {
  Region region;
  FlatPolygon flat;
};

std::vector<Ground> grounds_of(const model::ModelRecord& model);

/// How far from a plane a reading of a model's scan may be and still be of it.
class Tolerance {
 public:
  explicit Tolerance(const model::ModelRecord& model);
  /// For a reading from this far.
  double at(double range) const;

 private:
  survey::NoiseLaw noise_;
  double least_, rounding_;
};

/// Which polygons readings lie on.
class Footing {
 public:
  /// `grounds` and `reach` outlive it; `reach` is how far beyond a perimeter a reading may project,
  /// `most_tolerance` the largest that will be asked for.
  Footing(const std::vector<Ground>& grounds, const ResolutionField& reach, double most_tolerance);
  ~Footing();

  /// A polygon that a reading lies on, and how far it is from the polygon itself.
  struct Foot {
    int polygon;
    double distance;
  };
  /// Calls `visit` with each of them, in ascending order.
  void each(const model::SensorPoint& reading, double tolerance,
            const std::function<void(const Foot&)>& visit) const;

 private:
  struct Index;
  const std::vector<Ground>& grounds_;
  const ResolutionField& reach_;
  std::unique_ptr<Index> index_;
};

}  // namespace limpet::evaluation
