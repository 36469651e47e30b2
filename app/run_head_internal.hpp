// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/app/run_file.hpp>

#include "run_fields_internal.hpp"

namespace limpet::app::internal {

/// Reads what stands before the first set. What makes no sense is refused with its line, io::InputError.
RunHead read_head(RunFields&);

}  // namespace limpet::app::internal
