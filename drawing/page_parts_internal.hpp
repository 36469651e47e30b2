// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string_view>

namespace limpet::drawing::internal {

/// What the build has made of drawing/page/. All empty: it could not make the page.
struct PageParts {
  std::string_view html;     ///< with places for title, style, program and data
  std::string_view style;    ///< CSS
  std::string_view program;  ///< JavaScript, three.js included
};

PageParts page_parts();

}  // namespace limpet::drawing::internal
