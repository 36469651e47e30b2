// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/survey/estimate.hpp>
#include <vector>

namespace limpet::survey {

inline Estimate estimate_of(const std::vector<model::SensorPoint>& points) {
  return estimate([&](const Take& take) {
    for (const auto& p : points) take(p);
  });
}

}  // namespace limpet::survey
