// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/simulation/mesh.hpp>
#include <string>
#include <vector>

namespace limpet::simulation {

/// Named worlds, whose true faces are known by construction. Lengths are in the scan's unit; all coordinates
/// are multiples of 1/64 unless a parameter or a round surface says otherwise. `feature` is the smallest
/// width of a face, or gap between faces, that a model should show: a linear resolution well below it is
/// needed to see all faces.
///
///   name            what                                                        faces    feature
///   cube            1 × 1 × 1                                                        6    1
///   L               1 × 1 × 1 without a quarter: one concave edge                    8    0.5
///   step_hole       block with a step and a square hole through the lower part      12    0.25
///   plate3          3 × 1 × 0.25 with three square holes through it                 18    0.25
///   open_box        cube's outside without the lid: an open sheet                    5    1
///   thin_plate:T    1 × 1 × T, 0 < T ≤ 1                                             6    T
///   pyramid         square base 1 × 1, height 1                                      5    1
///   octahedron      corners at distance 1 from the centre                            8    1.2247
///   icosahedron     edges of length 1                                               20    0.8660
///   box             1.5 × 1 × 0.5                                                    6    0.5
///   step            stairs of three steps, each 0.5 high and deep, 1 wide           10    0.5
///   notch           1.5 × 1 × 1 with a groove of 0.5 × 0.5 across its top           10    0.5
///   cross           two bars of 1.5 × 0.5 × 0.5                                     14    0.5
///   sphere:N        diameter 1; facets between N meridians and N/2 parallels     N·N/2    1
///   drum:N          a cylinder of N sides on a block of 1 × 1 × 0.375,           N + 7    0.1875
///                   diameter 0.625, 0.5 high
///   cells:N[:SEED]  N cells of a sheared lattice joined by their faces; one sheet,     varies  0.75
///                   whose vertices may have four faces, two of them in one plane, or
///                   six, of which pairs lie in one plane and touch there only
///   room:SEED[:COLUMNS[:ROWS]]  a room seen from inside, 3 high, COLUMNS × ROWS      about 200 0.25
///                   cells of 2 × 2 (6 × 4 if left out), with boxes on the floor in
///                   each, against the walls and on one another (SEED 1 if left out)
///   city:N[:SEED]   N boxes of 0.8 to 1.2 × 0.8 to 1.2, 0.5 to 1.5 high, on a        5N + 1       0.5
///                   ground sheet, one in each cell of a grid of pitch 2.125, at
///                   least 0.5 apart; the ground is one face with N holes
///
/// All but open_box, room and city are closed. Throws MeshError on a name that is none of these, or a
/// parameter out of range (N of a city from 1 to 100 000, of cells from 1 to 1000,
/// columns and rows of a room from 1 to 100, of a sphere or drum a
/// multiple of 4 from 8 to 1024, 64 if left out). The same name gives the same mesh on every machine.
Mesh make_shape(const std::string& name);

/// The `feature` of a shape. Throws as make_shape does.
double feature_size(const std::string& name);

/// True if the name's first part (up to a colon) is that of a shape.
bool is_shape(const std::string& name);

/// One working name of each kind of shape.
std::vector<std::string> shape_names();

}  // namespace limpet::simulation
