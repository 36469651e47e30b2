// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include <limpet/model/parameters.hpp>
#include <limpet/model/sensor_point.hpp>

/// Clouds that are hard on an incremental model: long perimeters, many holes, surfaces that cross, no surface
/// at all. Readings come in random order, so that a surface grows everywhere at once, about five to λ²: no
/// denser than a model needs.
namespace limpet::benchmarks {

struct HostileSpec {
  /// holes:n, a plate with n square holes, 2.5 to 3 λ wide, 6 λ apart;
  /// combs:n, two combs in one plane, of n teeth each, in each other's gaps;
  /// planes:n, n rectangles that cross within a cube;
  /// noise:n, n readings anywhere in a cube, five to λ³, with any axes, and σ given as a fifth of λ;
  /// city:n, the shape of that name.
  std::string shape;
  std::int64_t points = 0;  ///< of a city; those of the others follow from the shape
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HostileSpec, shape, points)

/// Hands its readings, the same for the same specification, to `take`; returns the parameters to model them
/// by. Throws std::invalid_argument if there is no such shape.
struct HostileCloud {
  model::Parameters parameters;
  std::function<void(const std::function<void(const model::SensorPoint&)>& take)> scan;
};
HostileCloud hostile_cloud(const HostileSpec&);

}  // namespace limpet::benchmarks
