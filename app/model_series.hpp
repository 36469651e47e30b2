// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/record.hpp>
#include <string>

namespace limpet::app {

/// The finished model of a recorded run. Errors: io::InputError.
model::ModelRecord model_at_end(const std::string& run);

/// Writes a time series of a recorded run for ParaView: `path` (.pvd), which lists `stages` models at equal
/// distances along the run and the finished one, each a .vtp file in the folder beside it that has its name
/// without the ending. The time is the number of sets. Errors: io::InputError, io::OutputError.
void save_series(const std::string& path, const std::string& run, int stages, bool quiet);

}  // namespace limpet::app
