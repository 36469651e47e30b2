// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string_view>
#include <vector>

namespace limpet::io {

/// Unpacks LZF, the compression of PCD files, until `limit` bytes are made, the packed bytes end, or they
/// make no sense; what was unpacked until then is returned (`limit` bytes exactly when all is well). Memory
/// is at most the smaller of `limit` and 88 times the packed bytes.
std::vector<char> unpack_lzf(std::string_view packed, std::size_t limit);

}  // namespace limpet::io
