// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/parameters.hpp>
#include <string>

namespace limpet::survey {

/// A linear resolution λ as fixed + per_range · range, range being the distance to the nearest place where a
/// sensor stood.
struct ResolutionLaw {
  double fixed = 0;      ///< scan's unit
  double per_range = 0;  ///< a pure number

  ResolutionLaw() = default;
  ResolutionLaw(double everywhere, double growth = 0) : fixed(everywhere), per_range(growth) {}
  /// λ at this distance, scan's unit.
  double at(double range) const { return fixed + per_range * range; }
  bool varies() const { return per_range > 0; }
};

/// λ of a model.
inline ResolutionLaw resolution_of(const model::Parameters& p) {
  return {p.resolution, p.resolution_per_range};
}

/// As it is typed at the command line, each number to four digits: "a" or "a,b".
std::string short_text(const ResolutionLaw& resolution);

}  // namespace limpet::survey
