// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/record.hpp>
#include <string>

namespace limpet::io {

/// True for the extensions save_mesh knows: off, ply, obj, stl, glb, vtp (lower case, no dot).
bool is_mesh_extension(const std::string& extension);

/// The file that save_model() writes beside `path`; empty: none. The materials of an OBJ file.
std::string side_file(const std::string& path);

/// Is there a side file of this name that limpet has not written?
bool is_foreign_side_file(const std::string& side_file);

/// Writes the polygon segments as a mesh, in the format of `path`'s extension; point segments have no place
/// in it. Coordinates read back as the same doubles, except from STL, whose format has floats. Faces:
/// polygons; those with holes are triangulated, in STL all are. OFF and PLY carry a colour per segment, OBJ
/// does so by a .mtl file beside it. What a manifold mesh cannot hold (an edge of three faces) is written
/// over vertices of its own. For looking at, with edges as lines, those shared told from those open: glTF
/// (.glb; positions are floats about the model's middle) and VTK (.vtp; all that is known of a cell beside
/// it, and point segments). Errors: OutputError; std::invalid_argument for another extension.
void save_mesh(const std::string& path, const model::ModelRecord& model);

/// Writes a model in the format of the extension: limpet (native), or a mesh.
/// Errors: OutputError, also for another extension.
void save_model(const std::string& path, const model::ModelRecord& model);

}  // namespace limpet::io
