// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/record.hpp>
#include <string>

namespace limpet::io::internal {

/// A model as VTK's PolyData in XML (.vtp): point segments as vertices, edges as lines, polygons (those with
/// holes as triangles). Each cell says of which segment it is, by how many sensor points, what it is (0 point
/// segment, 1 shared edge, 2 open edge, 3 polygon), its edge and the partner of that, and its colour.
std::string vtp_text(const model::ModelRecord&);

}  // namespace limpet::io::internal
