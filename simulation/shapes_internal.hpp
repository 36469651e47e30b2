// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/simulation/mesh.hpp>

namespace limpet::simulation {

/// The room's furniture stands in the cells of a grid; the lines between the cells are aisles.
inline constexpr double kRoomCell = 2, kRoomHeight = 3;

// shapes_solids.cpp; shapes.hpp says what they are.
Mesh make_slab();
Mesh make_staircase();
Mesh make_notch();
Mesh make_cross();
Mesh make_icosahedron();
/// Precondition: an even number of meridians, 6 or more.
Mesh make_sphere(int meridians);
/// Precondition: a multiple of 4, 8 or more.
Mesh make_drum(int sides);

// shapes_cells.cpp
/// Precondition: count > 0.
Mesh make_cells(int count, std::uint64_t seed);

// shapes_scattered.cpp
/// Precondition: columns and rows of cells, each 1 or more.
Mesh make_room(std::uint64_t seed, int columns, int rows);
Mesh make_city(int boxes, std::uint64_t seed);

}  // namespace limpet::simulation
