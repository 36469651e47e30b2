// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/moments_internal.hpp>
#include <vector>

namespace limpet::model::testing {

using Cloud = std::vector<GridPoint>;

inline Moments moments_of(const Cloud& points) {
  Moments m;
  for (const auto& p : points) m.add(p);
  return m;
}

inline bool same(const Moments& a, const Moments& b) {
  const auto x = a.record(), y = b.record();
  return x.count == y.count && x.sum == y.sum && x.product == y.product;
}

}  // namespace limpet::model::testing
