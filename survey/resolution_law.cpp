// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/resolution_law.hpp>

#include <limpet/io/text.hpp>

namespace limpet::survey {

std::string short_text(const ResolutionLaw& resolution) {
  return io::short_text(resolution.fixed) +
         (resolution.varies() ? "," + io::short_text(resolution.per_range) : "");
}

}  // namespace limpet::survey
