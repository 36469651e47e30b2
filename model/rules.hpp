// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace limpet::model {

/// The departures from the thesis, each of which can be switched off (docs/rules.md says what each is worth).
struct Rules {
  /// A point segment becomes a polygon when its normal is precise enough, not when s_pt² ≥ s_pp².
  bool promotion = true;
  bool chance = true;    ///< promotion waits while the points may lie in one plane by chance
  bool patch = true;     ///< promotion takes neighbouring point segments of one plane together
  bool arrival = true;   ///< promotion waits while a segment gets far fewer points than the rest of the scene
  bool residual = true;  ///< added data is judged by its own residual, not by the variance after the merger
  bool relief = true;    ///< within the tolerance, it must also continue the surface beside it
  bool best = true;      ///< a point goes to the best segment, polygons first; not to the lowest identity
  /// Young segments keep their points, and are dissolved beside mature polygons that these points fit.
  bool dissolve = true;
  /// When finishing, young polygons with points that lie in other planes are dissolved.
  bool strays = true;
  /// The initial plane follows the fit once its normal is known to μ/20, while the two differ by less than μ.
  bool refresh = true;
  bool near = true;   ///< points within λ/4 of a perimeter update the moments only
  bool holes = true;  ///< polygons have holes; perimeters are bridged where they come near themselves
  /// When finishing, holes and bays that may be chance gaps at the scan's density are closed.
  bool voids = true;
  /// When finishing, small or thin parts of a polygon beyond a line of intersection give way to it.
  bool spurs = true;
  /// When finishing, polygons whose planes meet at μ/2 to μ share edges, too.
  bool bends = true;
  /// When finishing, a polygon that fills two opposite quadrants between two others' planes is cut in two
  /// there.
  bool pinches = true;
  /// Two mature polygons that cover each other within the tolerance become one.
  bool twins = true;
  /// Readings with a range say where no surface is: such places are not filled, such polygons are deleted.
  bool rays = true;
  /// When finishing, segments without neighbours that lie on larger ones are deleted.
  bool position = true;
  bool finish = true;  ///< at the end of input, the update is repeated until nothing changes
  bool expiry = true;  ///< small point segments that nothing has joined for long are given up as outliers

  /// All rules off.
  static Rules thesis();
  /// Rules from the command line: "limpet" (all on), "thesis" (all off), or names separated by commas. Names
  /// alone switch on only these; with a minus ("-near,-holes") they switch these off and leave the others on.
  /// Throws std::invalid_argument, naming the unknown rule and the known ones.
  static Rules parse(std::string_view);
  /// The names of all rules, in the order above.
  static std::vector<std::string> names();
  /// The names of the rules that are on, separated by commas; "thesis" when none is.
  std::string to_string() const;
};

}  // namespace limpet::model
