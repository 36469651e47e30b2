// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <string>

namespace limpet::drawing {

/// Whole numbers as bytes, small ones in few: seven bits a byte, the low ones first, the high bit set on all
/// bytes but the last (LEB128). Signed ones are put as 0, −1, 1, −2, 2 … (zigzag).
class VarintWriter {
 public:
  void put(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) bytes_.push_back(static_cast<char>((value & 0x7f) | 0x80));
    bytes_.push_back(static_cast<char>(value));
  }
  void put_signed(std::int64_t value) { put(zigzag(value)); }
  const std::string& bytes() const { return bytes_; }

  static std::uint64_t zigzag(std::int64_t value) {
    return (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
  }

 private:
  std::string bytes_;
};

}  // namespace limpet::drawing
