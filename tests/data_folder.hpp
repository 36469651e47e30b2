// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdlib>
#include <filesystem>

namespace limpet::testing {

/// Files nobody here wrote: the folder named by LIMPET_DATA, else ../shared/data beside the project. Tests
/// that need one report themselves skipped where it is absent.
inline std::filesystem::path data_folder() {
  const char* named = std::getenv("LIMPET_DATA");
  return named ? named : LIMPET_DATA_DEFAULT;
}

}  // namespace limpet::testing
