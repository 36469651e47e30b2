// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/outcome.hpp>

#include "engine_internal.hpp"

namespace limpet::model::internal {

Outcome would_finish(const Engine&);

}  // namespace limpet::model::internal
