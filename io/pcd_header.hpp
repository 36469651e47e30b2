// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <limpet/io/binary_number.hpp>
#include <limpet/io/byte_source.hpp>
#include <optional>
#include <string>
#include <vector>

namespace limpet::io {

struct PcdField {
  std::string name;
  NumberType type = NumberType::kFloat;
  std::size_t count = 1;  ///< numbers in the field
};

struct PcdHeader {
  enum class Encoding { kAscii, kBinary, kCompressed };
  Encoding encoding = Encoding::kAscii;
  std::vector<PcdField> fields;
  std::int64_t points = 0;
  std::optional<Eigen::Vector3d> viewpoint;  ///< where the sensor stood; its turn is of no use here
};

/// Reads the header, up to its DATA line and with it. Errors: InputError.
PcdHeader read_pcd_header(ByteSource& source);

}  // namespace limpet::io
