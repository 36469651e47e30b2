// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/record.hpp>

#include "engine_internal.hpp"

namespace limpet::model::internal {

ModelRecord to_record(const Engine&);
/// Precondition: the engine is new. Throws std::invalid_argument as Model(const ModelRecord&) does.
void from_record(Engine&, const ModelRecord&);

// record_checks.cpp

/// Throws std::invalid_argument, with the reason, when a number of the record is not finite or beyond what a
/// model can hold, or an identity is 0, too large or an edge's that occurs twice.
void require_sound(const Setting&, const ModelRecord&);
/// Why further points cannot be added to these sums, or the covariance computed from them, without overflow;
/// null when they can.
const char* fault_of(const MomentsRecord&);

}  // namespace limpet::model::internal
