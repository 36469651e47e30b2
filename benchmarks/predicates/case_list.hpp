// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>
#include <vector>

#include "../../tests/cases/perimeter_case.hpp"

namespace limpet::benchmarks {

/// Cases one behind the other in a file. Throws cases::CaseError.
std::vector<cases::PerimeterCase> load_cases(const std::string& path);
void save_cases(const std::string& path, const std::vector<cases::PerimeterCase>&);

/// The whole file. Throws cases::CaseError.
std::string load_text(const std::string& path);

}  // namespace limpet::benchmarks
