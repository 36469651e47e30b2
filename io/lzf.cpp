// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limpet/io/lzf.hpp>

namespace limpet::io {

std::vector<char> unpack_lzf(std::string_view packed, std::size_t limit) {
  std::vector<char> bytes;
  // A packed byte stands for at most a third of 264 bytes; the size that a header promises may be false.
  bytes.reserve(std::min(limit, packed.size() * 88 + 264));
  std::size_t at = 0;
  const auto left = [&] { return packed.size() - at; };
  const auto byte = [&] { return static_cast<std::size_t>(static_cast<unsigned char>(packed[at++])); };
  while (left() > 0 && bytes.size() < limit) {
    const std::size_t control = byte();
    if (control < 32) {  // a literal run of 1 to 32 bytes
      const std::size_t run = std::min({control + 1, left(), limit - bytes.size()});
      bytes.insert(bytes.end(), packed.begin() + at, packed.begin() + at + run);
      if (run < control + 1) return bytes;
      at += run;
      continue;
    }
    // A copy of 3 to 264 bytes from up to 8 KiB back; it may reach into what it makes.
    std::size_t length = control >> 5;
    if (length == 7) {
      if (left() == 0) return bytes;
      length += byte();
    }
    length += 2;
    if (left() == 0) return bytes;
    const std::size_t distance = ((control & 31) << 8) + byte() + 1;
    if (distance > bytes.size() || bytes.size() + length > limit) return bytes;
    for (std::size_t i = 0; i < length; ++i) bytes.push_back(bytes[bytes.size() - distance]);
  }
  return bytes;
}

}  // namespace limpet::io
