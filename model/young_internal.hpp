// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cmath>

#include "fit_internal.hpp"
#include "setting_internal.hpp"
#include "thresholds_internal.hpp"

namespace limpet::model::internal {

/// May a segment with `count` points, spread as the fit says, still be young?
inline bool may_be_young(const Setting& setting, std::int64_t count, const Fit& fit) {
  if (count <= kYoung || count > kMostYoung) return count <= kYoung;
  return 12 * std::sqrt(fit.u1 * fit.u2) <
         kYoungArea * setting.scale_at(fit.centroid).lambda2;  // a rectangle with these variances
}

}  // namespace limpet::model::internal
