// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/evaluation/planar_face.hpp>
#include <string>
#include <vector>

namespace limpet::evaluation {

/// A surface that is judged, from whatever kind of file it came.
struct Subject {
  std::vector<PlanarFace> faces;
  std::int64_t edges = 0, open_edges = 0;
  bool closed() const { return edges > 0 && open_edges == 0; }
};

/// Reads a native model file (.limpet) or a mesh file, told by the extension. Errors: io::InputError,
/// simulation::MeshError.
Subject load_subject(const std::string& path);

}  // namespace limpet::evaluation
