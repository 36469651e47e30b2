// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace limpet::model {

/// The departures from the thesis, each of which can be switched off (docs/rules.md says what each is worth).
struct Rules {
  bool promotion =
      true;  ///< a point segment becomes a polygon by the precision of its normal, not when s_pt² ≥ s_pp²
  bool chance = true;    ///< nor while so few points could lie in a plane by chance
  bool patch = true;     ///< neighbouring point segments in one plane become a polygon together
  bool arrival = true;   ///< nor when far fewer points came to it than to the rest of the scene
  bool residual = true;  ///< added data is judged by its own residual, not by the variance after the merger
  bool relief = true;    ///< and, within the tolerance, by how it goes on from the surface beside it
  bool best = true;      ///< a point goes to the best segment, polygons first; not to the first in memory
  bool dissolve =
      true;  ///< young segments keep their points and are dissolved beside a mature polygon that they fit
  bool refresh = true;  ///< the initial plane follows the fit while that is still uncertain
  bool near = true;     ///< points within λ/4 of a perimeter update the moments only
  bool holes = true;    ///< polygons have holes; perimeters are bridged where they meet themselves
  bool voids =
      true;  ///< when finishing, holes that chance alone would leave empty at the scan's density are dropped
  bool spurs = true;  ///< when finishing, what goes on beyond a line, but is small or thin, gives way to it
  bool position =
      true;  ///< when finishing, segments that lie on larger ones and have no neighbours are deleted
  bool finish = true;  ///< at the end of input everything is tried again until nothing changes
  bool expiry = true;  ///< small point segments that nothing joins for long are given up as outliers

  static Rules thesis();
  /// From the command line: "limpet" (all on), "thesis" (all off), or names separated by commas, those to
  /// leave on; with a minus
  /// ("-near,-holes") those to leave out. Throws std::invalid_argument that names an unknown rule and the
  /// known ones.
  static Rules parse(std::string_view);
  static std::vector<std::string> names();
  /// The names of the rules that are on, separated by commas; "thesis" when none is.
  std::string to_string() const;
};

}  // namespace limpet::model
