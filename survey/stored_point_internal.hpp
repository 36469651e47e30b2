// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <limpet/model/sensor_point.hpp>

namespace limpet::survey {

/// A sensor point as it lies in a temporary file.
struct StoredPoint {
  StoredPoint() = default;
  explicit StoredPoint(const model::SensorPoint& p)
      : numbers{p.position.x(), p.position.y(), p.position.z(), p.axis.x(), p.axis.y(), p.axis.z(), p.range} {
  }
  model::SensorPoint restored() const {
    const auto& n = numbers;
    return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n[6]};
  }

  std::array<double, 7> numbers;
};

}  // namespace limpet::survey
