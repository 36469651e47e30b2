// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

namespace limpet {

/// Whether addresses are checked (ASan): slower by an order of magnitude, with an address space of its own.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
inline constexpr bool kSanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace limpet
