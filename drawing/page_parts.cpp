// Copyright the limpet authors. GPL-3.0-or-later.
#include "page_parts_internal.hpp"

#include <cstddef>

// The files of the build, as they are (page_parts.S).
extern "C" {
extern const char limpet_page_html[], limpet_page_html_end[];
extern const char limpet_page_style[], limpet_page_style_end[];
extern const char limpet_page_program[], limpet_page_program_end[];
}

namespace limpet::drawing::internal {
namespace {

std::string_view part(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

PageParts page_parts() {
  return {part(limpet_page_html, limpet_page_html_end), part(limpet_page_style, limpet_page_style_end),
          part(limpet_page_program, limpet_page_program_end)};
}

}  // namespace limpet::drawing::internal
