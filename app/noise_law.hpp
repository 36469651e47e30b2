// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/app/arguments.hpp>
#include <vector>

namespace limpet::app {

/// What one flat neighbourhood of a scan says of its noise: a standard deviation along the sensing axis, and
/// from how far; scan's unit, range 0 where it is not known.
struct NoiseAt {
  double range = 0, noise = 0;
};

/// The noise of a scan as a + b·range + c·range². One number unless the scan clearly says otherwise. Robust:
/// up to half of the neighbourhoods, at every range, may cross edges of the surface.
NoiseArgument noise_law(std::vector<NoiseAt> found);

/// The value that this part, 0 to 1, of the values lie below; 0 when there is none.
double quantile(std::vector<double> values, double part);

}  // namespace limpet::app
