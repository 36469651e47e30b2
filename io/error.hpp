// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <stdexcept>
#include <string>

namespace limpet::io {

/// Bad input, the caller's to mend: a file that is missing, damaged or of the wrong kind. what() is one line
/// that says where (file, then line, byte or record), what is wrong and, where it helps, what to do about it.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& line) : std::runtime_error(line) {}
  InputError(const std::string& where, const std::string& what) : std::runtime_error(where + ": " + what) {}
};

/// The outside world failed us while writing (no space, no permission, no such folder). what() is one line
/// that names the file and the system's reason.
class OutputError : public std::runtime_error {
 public:
  explicit OutputError(const std::string& line) : std::runtime_error(line) {}
};

}  // namespace limpet::io
