// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cstdint>
#include <limpet/model/open_edges.hpp>

namespace limpet::io {

/// Red, green, blue.
using Color = std::array<std::uint8_t, 3>;

/// A segment's colour: the same in every picture and mesh; identities near each other get colours far apart.
Color segment_color(std::uint64_t id);

/// An open edge's colour, by what refused it a neighbour.
Color open_edge_color(model::Refusal refusal);

}  // namespace limpet::io
