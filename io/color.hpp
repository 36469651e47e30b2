// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cstdint>

namespace limpet::io {

/// Red, green, blue.
using Color = std::array<std::uint8_t, 3>;

/// A segment's colour: the same in every picture and mesh; identities near each other get colours far apart.
Color segment_color(std::uint64_t id);

}  // namespace limpet::io
