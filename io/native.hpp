// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <iosfwd>
#include <limpet/model/record.hpp>
#include <string>

namespace limpet::io {

/// Writes the native model file (docs/native_format.md). Lossless: what is read back is the same to the bit,
/// and writing that gives the same bytes. Preconditions: the arithmetic is not empty and holds no blanks
/// (std::invalid_argument otherwise); every number is finite (not judged here, but refused when read).
void write_native(std::ostream& stream, const model::ModelRecord& model);

/// Reads a native model file from the stream's position to its end. `name` stands for the file in messages.
/// Judges the form only: whether the model keeps its own laws is for the oracle to say.
/// Errors: InputError with the line number, when anything is not as the format says.
model::ModelRecord read_native(std::istream& stream, const std::string& name);

/// The same by path; written aside and renamed, so never half written. Errors: OutputError.
void save_native(const std::string& path, const model::ModelRecord& model);

/// Reads a native file by path; "-" is standard input. Errors: InputError.
model::ModelRecord load_native(const std::string& path);

}  // namespace limpet::io
