// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/io/color.hpp>
#include <limpet/model/open_edges.hpp>

namespace limpet::drawing {

/// An open edge's colour, by the condition that refused it a neighbour.
io::Color open_edge_color(model::Refusal refusal);

}  // namespace limpet::drawing
