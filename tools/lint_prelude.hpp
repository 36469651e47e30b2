// Copyright the limpet authors. GPL-3.0-or-later.
//
// For clang-tidy alone. Boost 1.74 casts -1 to enumerations in constants, which clang has refused since 16.
#pragma once

#include <boost/mpl/aux_/static_cast.hpp>
#include <type_traits>

namespace limpet::lint {

template <class To, class From>
constexpr To constant(From value) {
  if constexpr (std::is_enum_v<To>)
    return __builtin_bit_cast(To, static_cast<std::underlying_type_t<To>>(value));
  else
    return static_cast<To>(value);
}

}  // namespace limpet::lint

#undef BOOST_MPL_AUX_STATIC_CAST
#define BOOST_MPL_AUX_STATIC_CAST(T, expr) ::limpet::lint::constant<T>(expr)
