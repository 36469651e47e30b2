// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/record.hpp>
#include <string>

namespace limpet::io::internal {

/// A model as binary glTF 2.0 (.glb): faces with a colour each, shared edges as dark lines and open edges as
/// orange ones. Positions are floats about the middle of the model, which its node puts where it was; z is
/// turned to y, which is up in glTF.
std::string glb_bytes(const model::ModelRecord&);

}  // namespace limpet::io::internal
