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
  std::vector<PlyElement> elements;
};

/// Takes the header, up to and with its "end_header" line. Errors: InputError.
PlyHeader read_ply_header(ByteSource& source);

}  // namespace limpet::io
