// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace limpet::io {

static_assert(std::endian::native == std::endian::little,
              "binary scans are read on little-endian machines only");

enum class NumberType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kInt64, kUint64, kFloat, kDouble };

inline std::size_t size_of(NumberType type) {
  switch (type) {
    case NumberType::kInt8:
    case NumberType::kUint8:
      return 1;
    case NumberType::kInt16:
    case NumberType::kUint16:
      return 2;
    case NumberType::kInt32:
    case NumberType::kUint32:
    case NumberType::kFloat:
      return 4;
    default:
      return 8;
  }
}

inline bool is_integer(NumberType type) { return type < NumberType::kFloat; }

template <class Number>
double decode_as(const char* bytes, bool swapped) {
  Number value;
  std::memcpy(&value, bytes, sizeof value);
  if (swapped) {
    unsigned char raw[sizeof value];
    for (std::size_t i = 0; i < sizeof raw; ++i)
      raw[i] = static_cast<unsigned char>(bytes[sizeof raw - 1 - i]);
    std::memcpy(&value, raw, sizeof value);
  }
  return static_cast<double>(value);
}

/// The number in `bytes` (little-endian, or big-endian where `swapped`); 64-bit integers are rounded.
inline double decode(const char* bytes, NumberType type, bool swapped) {
  switch (type) {
    case NumberType::kInt8:
      return decode_as<std::int8_t>(bytes, swapped);
    case NumberType::kUint8:
      return decode_as<std::uint8_t>(bytes, swapped);
    case NumberType::kInt16:
      return decode_as<std::int16_t>(bytes, swapped);
    case NumberType::kUint16:
      return decode_as<std::uint16_t>(bytes, swapped);
    case NumberType::kInt32:
      return decode_as<std::int32_t>(bytes, swapped);
    case NumberType::kUint32:
      return decode_as<std::uint32_t>(bytes, swapped);
    case NumberType::kInt64:
      return decode_as<std::int64_t>(bytes, swapped);
    case NumberType::kUint64:
      return decode_as<std::uint64_t>(bytes, swapped);
    case NumberType::kFloat:
      return decode_as<float>(bytes, swapped);
    case NumberType::kDouble:
      return decode_as<double>(bytes, swapped);
  }
  return 0;
}

}  // namespace limpet::io
