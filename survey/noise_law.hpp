// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/model/parameters.hpp>
#include <string>
#include <vector>

namespace limpet::survey {

/// How exact the readings of a scan are: the standard deviation of a reading along its sensing axis as
/// fixed + per_range · range + per_range2 · range².
struct NoiseLaw {
  double fixed = 0;       ///< scan's unit
  double per_range = 0;   ///< a pure number
  double per_range2 = 0;  ///< one over the scan's unit
  /// Standard deviation of a reading from this far, scan's unit.
  double at(double range) const { return fixed + (per_range + per_range2 * range) * range; }
  /// Does it grow with the range?
  bool varies() const { return per_range > 0 || per_range2 > 0; }
};

/// The noise that a model was told.
inline NoiseLaw noise_of(const model::Parameters& p) {
  return {p.noise, p.noise_per_range, p.noise_per_range2};
}

/// As it is typed at the command line, each number to four digits: "a", "a,b" or "a,b,c".
std::string short_text(const NoiseLaw& noise);

/// What one flat neighbourhood of a scan says of its noise: a standard deviation along the sensing axis, and
/// from how far; scan's unit, range 0 where it is not known. `cosine`: of the angle at which it was seen.
struct NoiseAt {
  double range = 0, noise = 0, cosine = 1;
};

/// The law that fits these neighbourhoods best. One number unless the scan clearly says otherwise. Robust: up
/// to half of the neighbourhoods, at every range, may cross edges of the surface. A sensor may know its
/// directions less well than its ranges; then readings scatter about a surface that they graze by more than
/// this noise along the axis would make them, and the law is raised to that.
NoiseLaw fit_noise_law(const std::vector<NoiseAt>& found);

/// The quantile of some values: `part` of them, 0 to 1, lie below it. 0 where there are no values.
double quantile(std::vector<double> values, double part);

}  // namespace limpet::survey
