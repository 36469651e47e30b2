// Copyright the limpet authors. GPL-3.0-or-later.
#include "contestants.hpp"

namespace limpet::benchmarks {

/// Takes the place of answer_polyfit.cpp where GLPK is not installed.
Json answer_polyfit(const Json&) { return {{"failed", "built without GLPK"}}; }

}  // namespace limpet::benchmarks
