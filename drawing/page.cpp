// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/drawing/page.hpp>

#include <zlib.h>

#include <cstdint>
#include <new>
#include <string_view>

#include "page_parts_internal.hpp"

namespace limpet::drawing {
namespace {

/// The template with `value` in place of {{name}}, which it holds once.
void fill(std::string& text, std::string_view name, std::string_view value) {
  const std::string place = "{{" + std::string(name) + "}}";
  const std::size_t at = text.find(place);
  if (at == std::string::npos) throw std::logic_error("the page has no place for " + std::string(name));
  text.replace(at, place.size(), value);
}

}  // namespace

void require_page() {
  if (internal::page_parts().program.empty())
    throw NoPage(
        "this program was built without its page: install npm (Node.js 18 or newer) and esbuild, then build "
        "again");
}

/// The parts that are not ours to look into come last: what stands in them is no place of the template.
std::string page(const std::string& title, const std::string& data) {
  require_page();
  const internal::PageParts& parts = internal::page_parts();
  std::string text(parts.html);
  fill(text, "data", base64(gzipped(data)));
  fill(text, "program", base64(gzipped(std::string(parts.program))));
  fill(text, "style", parts.style);
  fill(text, "title", html_text(title));
  return text;
}

std::string gzipped(const std::string& bytes) {
  z_stream stream{};
  constexpr int kGzip = 16;
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS + kGzip, MAX_MEM_LEVEL,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  gz_header header{};
  constexpr int kUnix = 3;
  header.os = kUnix;
  deflateSetHeader(&stream, &header);
  std::string result(deflateBound(&stream, bytes.size()), '\0');
  std::size_t taken = 0, given = 0;
  int state = Z_OK;
  while (state == Z_OK) {  // zlib counts in 32 bits
    constexpr std::size_t kPiece = std::size_t{1} << 30;
    const std::size_t in = std::min(bytes.size() - taken, kPiece),
                      out = std::min(result.size() - given, kPiece);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + taken));
    stream.avail_in = static_cast<uInt>(in);
    stream.next_out = reinterpret_cast<Bytef*>(result.data() + given);
    stream.avail_out = static_cast<uInt>(out);
    state = deflate(&stream, taken + in == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    taken += in - stream.avail_in, given += out - stream.avail_out;
  }
  deflateEnd(&stream);
  if (state != Z_STREAM_END) throw std::logic_error("zlib could not compress a page's data");
  result.resize(given);
  return result;
}

std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text.push_back(k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=');
  }
  return text;
}

std::string html_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (c == '\'')
      result += "&#39;";
    else
      result += c;
  }
  return result;
}

}  // namespace limpet::drawing
