// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cmath>
#include <cstdlib>
#include <optional>

#include "perimeter_case.hpp"

namespace limpet::cases {

/// Where coordinates lie.
enum class Regime {
  grid,  ///< small whole numbers, near the origin
  free,  ///< turned by an angle and scaled: any doubles, which the builds with a grid round
  far,   ///< whole numbers, up to 4·10⁹ steps from the origin
  any,   ///< the first and the last, mixed with scales of 1 to 10⁶
};

/// Makes up degenerate perimeters and operations on them as they grow: operands of the polygon's own shape,
/// on its vertices, touching its edges, a step beside them; points on, at and near its boundary.
class PerimeterScript {
 public:
  PerimeterScript(shapes::Random random, Regime regime, bool general = false)
      : random_(random), regime_(regime), general_(general) {}

  shapes::Random& random() { return random_; }

  /// A start, without steps.
  PerimeterCase begin() {
    PerimeterCase c;
    scale_ = regime_ == Regime::grid || random_.chance(0.5) ? 1 : random_.scale(1, 1e6);
    c.gap = random_.chance(0.5) ? random_.scale(2, 20) * scale_ : random_.scale(2, 1e4);
    c.gap = gap_ = std::floor(std::min(c.gap, 1e4));
    place_ = regime_ == Regime::far   ? random_.scale(1e6, 4e9)
             : regime_ != Regime::any ? 0
             : random_.chance(0.7)    ? 0
                                      : random_.scale(1, 4e9);
    const double angle = random_.scale(0.01, 1);
    cosine_ = std::cos(angle), sine_ = std::sin(angle);
    c.start = shape({});
    return c;
  }

  /// What to do next.
  Step next(const Polygon& polygon) {
    Step step;
    constexpr std::array kOften = {0, 0, 0, 1, 1, 2, 3, 3};
    step.operation = static_cast<Operation>(kOften[static_cast<std::size_t>(random_.whole(0, 7))]);
    const Cycles cycles = polygon.boundary();
    if (step.operation == Operation::extend) step.q = near(cycles);
    if (step.operation == Operation::merge || step.operation == Operation::unite)
      step.other = operand(cycles);
    if (step.operation == Operation::fill) step.all_fresh = random_.chance(0.3);
    return step;
  }

 private:
  /// A valid polygon; some edges are shared.
  Cycles shape(const std::optional<shapes::Map>& wanted) {
    for (int tries = 5;; --tries) {
      Cycles cycles = tries > 0 ? raw() : Cycles{shapes::rectangle(0, 0, 3, 2)};
      const shapes::Map map = wanted ? *wanted : random_map(random_, scale_, place_);
      map_all(cycles, map);
      if (regime_ == Regime::free && !wanted) turn(cycles);
      if (random_.chance(0.2))
        for (auto& c : cycles)
          for (NewVertex& v : c) v.shared = random_.chance(0.1);
      EdgeIds ids;
      if (Polygon::from_cycles(cycles, ids)) return cycles;
      if (tries < -3) std::abort();
    }
  }

  /// In general position no three vertices are on a line on purpose.
  Cycles raw() {
    if (!general_) return raw_shape(random_);
    Cycles cycles = star(random_, static_cast<int>(random_.whole(3, 60)), random_.scale(1e4, 1e6));
    for (NewVertex& v : cycles[0])
      v.at = v.at + Point2{static_cast<double>(random_.whole(-999, 999)),
                           static_cast<double>(random_.whole(-999, 999))};
    return cycles;
  }

  void turn(Cycles& cycles) const {
    for (auto& c : cycles)
      for (NewVertex& v : c)
        v.at = round_to_grid({cosine_ * v.at.x - sine_ * v.at.y, sine_ * v.at.x + cosine_ * v.at.y});
  }

  static NewVertex any_vertex(const Cycles& cycles, shapes::Random& random) {
    const auto& c =
        cycles[static_cast<std::size_t>(random.whole(0, static_cast<std::int64_t>(cycles.size()) - 1))];
    return c[static_cast<std::size_t>(random.whole(0, static_cast<std::int64_t>(c.size()) - 1))];
  }

  Point2 near(const Cycles& cycles) {
    const Point2 a = any_vertex(cycles, random_).at, b = any_vertex(cycles, random_).at;
    const double reach = random_.chance(0.5) ? 3 : gap_;
    Point2 p = a;
    if (!random_.chance(0.4)) {
      const double beyond = 1 + 2 / (1 + std::sqrt(squared_length(b - a)));
      p = a + (random_.chance(0.3) ? beyond : random_.unit()) * (b - a);
    }
    if (random_.chance(0.9)) {
      const double x = 2 * random_.unit() - 1, y = 2 * random_.unit() - 1;
      p = p + Point2{x * reach, y * reach};
    }
    return round_to_grid(p);
  }

  /// Something to merge with: often the polygon's own shape, or one that lies on its vertices.
  Cycles operand(const Cycles& cycles) {
    if (!general_ && random_.chance(0.3)) {
      Cycles copy = cycles;
      if (random_.chance(0.5)) copy.resize(1);
      const Point2 p = any_vertex(cycles, random_).at, q = any_vertex(cycles, random_).at;
      Point2 by{0, 0};
      if (!random_.chance(0.2)) {
        by = q - p;
        if (!random_.chance(0.5)) {
          const auto x = random_.whole(-3, 3), y = random_.whole(-3, 3);
          by = {static_cast<double>(x), static_cast<double>(y)};
        }
      }
      for (auto& c : copy)
        for (NewVertex& v : c) v.at = v.at + by, v.edge = {};
      return copy;
    }
    shapes::Map map = random_map(random_, random_.chance(0.6) ? scale_ : random_.scale(1, 1 + scale_), 0);
    const Point2 at = random_.chance(0.6) ? any_vertex(cycles, random_).at : near(cycles);
    const auto x = static_cast<double>(random_.whole(0, 6)), y = static_cast<double>(random_.whole(0, 6));
    map.x = 0, map.y = 0;
    const Point2 shift = map({x, y});
    map.x = at.x - shift.x, map.y = at.y - shift.y;
    return shape(map);
  }

  shapes::Random random_;
  Regime regime_;
  bool general_;
  double scale_ = 1, gap_ = 2, place_ = 0, cosine_ = 1, sine_ = 0;
};

}  // namespace limpet::cases
