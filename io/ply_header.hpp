// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/io/binary_number.hpp>
#include <limpet/io/byte_source.hpp>
#include <string>
#include <vector>

namespace limpet::io {

struct PlyProperty {
  std::string name;
  NumberType type = NumberType::kFloat;  ///< of the number, or of each item of the list
  bool is_list = false;
  NumberType count_type = NumberType::kUint8;  ///< of a list's length; an integer type
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
  std::size_t fixed_size = 0;  ///< bytes of one binary record; 0 when a list makes it vary
};

struct PlyHeader {
  enum class Encoding { kAscii, kLittleEndian, kBigEndian };
  Encoding encoding = Encoding::kAscii;
  std::vector<std::string> comments;  ///< written, one line each; not read
  std::vector<PlyElement> elements;
};

/// Reads the header, up to its "end_header" line and with it. Errors: InputError.
PlyHeader read_ply_header(ByteSource& source);

/// A header as text, with "end_header" and its line's end. Counts are written with blanks in front, as wide
/// as `count_width` at least, so that one can be written over once it is known.
std::string ply_header_text(const PlyHeader& header, std::size_t count_width = 1);

}  // namespace limpet::io
