// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace limpet::model {

/// A 64-bit digest of numbers and bytes, the same on every machine, to detect damage and differences. If two
/// inputs differ in a single word, their digests always differ. It is not cryptographic.
class Digest {
 public:
  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x9e3779b97f4a7c15u;
    value_ ^= value_ >> 32;
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  /// Adds the bytes as little-endian words of eight, the last one padded with zeros, and then their number.
  void add(std::string_view bytes) {
    std::size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8) add(word_at(bytes.data() + i, 8));
    if (i < bytes.size()) add(word_at(bytes.data() + i, bytes.size() - i));
    add(std::uint64_t{bytes.size()});
  }
  std::uint64_t value() const { return value_; }

  friend bool operator==(const Digest&, const Digest&) = default;

 private:
  static std::uint64_t word_at(const char* bytes, std::size_t count) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < count; ++i)
      word |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    return word;
  }

  std::uint64_t value_ = 0x6c696d7065740000u;
};

}  // namespace limpet::model
