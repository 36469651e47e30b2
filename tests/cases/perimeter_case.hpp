// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <limpet/geometry/merge.hpp>
#include <limpet/geometry/polygon.hpp>
#include <limpet/geometry/predicates.hpp>

#include "../geometry/perimeter_shapes.hpp"
#include "case.hpp"

namespace limpet::cases {

using geometry::EdgeId;
using geometry::EdgeIds;
using geometry::NewVertex;
using geometry::Point2;
using geometry::Polygon;
using geometry::round_to_grid;
using geometry::Slot;
using shapes::Cycles;

enum class Operation { extend, merge, unite, fill };
inline constexpr std::array kOperations = {"extend", "merge", "unite", "fill"};

/// One operation on a perimeter, with all it is given.
struct Step {
  Operation operation = Operation::fill;
  Point2 q;                ///< extend: the point
  Cycles other;            ///< merge, unite: the operand, outer cycle first
  bool all_fresh = false;  ///< fill: look at all edges, not at those put in place since the last fill
};

/// A polygon and what is done to it; grid steps.
struct PerimeterCase {
  static constexpr const char* kKind = "perimeter";
  double gap = 2;  ///< λ
  Cycles start;
  std::vector<Step> steps;
  std::string law;               ///< that it once broke
  double area_tolerance = 1e-9;  ///< part of the area that rounding may lose
  double step_tolerance = 2;     ///< steps by which a boundary may shrink where rounded
};

/// The laws of every operation, by the names they are counted under.
enum class PerimeterLaw {
  simple,     ///< the result, judged from scratch, is a valid polygon
  audit,      ///< and so says the oracle, which shares no code with geometry/
  identity,   ///< identities are unique; each that is gone was logged, once
  untouched,  ///< an operation that reports no change made none
  area,       ///< no operation loses area
  growth,     ///< what it adds lies within the gap of what there was
  sides,      ///< locate() agrees with all edges
  contains,   ///< what lay deeper inside before than operands are moved lies inside now
  exception,  ///< nothing is thrown
  kCount
};
inline constexpr std::array kPerimeterLaws = {"simple", "audit", "identity", "untouched", "area",
                                              "growth", "sides", "contains", "exception"};

/// What became of an operation.
enum class Outcome { changed, nothing, refused };

/// By how many steps operands are moved at most (see unite.hpp), rounding included.
inline constexpr double kMoves = 64;

/// A polygon under trial: operations are applied to it and the result is judged.
class PerimeterTrial {
 public:
  /// Throws CaseError when the polygon is not valid.
  PerimeterTrial(const Cycles& start, double gap, double area_tolerance = 1e-9, double step_tolerance = 2);

  /// Takes up what a step needs; apply() then does nothing but the operation, so that it can be timed.
  /// False when the operand is no valid polygon.
  bool prepare(const Step&);
  Outcome apply();
  /// The first law that the last operation broke. `thorough`: also those that take long.
  std::optional<PerimeterLaw> judge(shapes::Random& places, bool thorough);

  const Polygon& polygon() const { return polygon_; }
  const Cycles& before() const { return before_; }
  /// Of the last unite: how many outlines were taken. Of the last merge: what it was.
  std::size_t attempts() const { return attempts_; }
  geometry::Merger merger() const { return merger_; }

 private:
  bool identities_hold(const Cycles& after);
  bool sides_hold(const Cycles& after, shapes::Random& places) const;
  bool contains_all(const Cycles& of, shapes::Random& places) const;
  /// How far what is added may lie from what there was.
  double reach() const { return gap_ + kMoves + step_tolerance_; }
  bool adds_only_near(const Cycles& after, shapes::Random& places) const;

  double gap_, area_tolerance_, step_tolerance_;
  EdgeIds ids_;
  Polygon polygon_;
  Cycles before_;
  Step step_;
  std::optional<Polygon> other_;
  std::vector<std::pair<Slot, EdgeId>> fresh_;
  Outcome outcome_ = Outcome::nothing;
  std::size_t attempts_ = 0;
  geometry::Merger merger_{};
  bool threw_ = false;
};

/// Runs all steps; the first broken law. Steps whose operand is no valid polygon are passed over.
std::optional<BrokenLaw> broken_law(const PerimeterCase&);

std::string to_text(const PerimeterCase&);
/// Throws CaseError.
PerimeterCase perimeter_case(std::string_view text);

/// Smaller cases that may break the same law, the smallest first.
std::vector<PerimeterCase> reductions(const PerimeterCase&);

double area_of(const Cycles&);
double length_of(const Cycles&);
bool audit_accepts(const Cycles&);

}  // namespace limpet::cases
