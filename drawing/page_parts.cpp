// Copyright the limpet authors. GPL-3.0-or-later.
#include "page_parts_internal.hpp"

#include <cstddef>

// The files of the build, as they are (page_parts.S).
extern "C" {
extern const char kLimpetPageHtml[], kLimpetPageHtmlEnd[];
extern const char kLimpetPageStyle[], kLimpetPageStyleEnd[];
extern const char kLimpetPageProgram[], kLimpetPageProgramEnd[];
}

namespace limpet::drawing::internal {
namespace {

std::string_view part(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

PageParts page_parts() {
  return {part(kLimpetPageHtml, kLimpetPageHtmlEnd), part(kLimpetPageStyle, kLimpetPageStyleEnd),
          part(kLimpetPageProgram, kLimpetPageProgramEnd)};
}

}  // namespace limpet::drawing::internal
