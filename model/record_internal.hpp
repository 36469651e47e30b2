// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/record.hpp>

#include "engine_internal.hpp"

namespace limpet::model::internal {

ModelRecord to_record(const Engine&);
/// Precondition: the engine is new. Throws std::invalid_argument as Model(const ModelRecord&) does.
void from_record(Engine&, const ModelRecord&);

}  // namespace limpet::model::internal
