// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limits>

namespace limpet {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace limpet
