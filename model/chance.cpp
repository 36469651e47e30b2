// Copyright the limpet authors. GPL-3.0-or-later.
#include "chance_internal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "series_internal.hpp"
#include "thresholds_internal.hpp"

namespace limpet::model::internal {
namespace {

using Eigen::Vector2d;

/// arccos for 0 ≤ x ≤ 1 to 7·10⁻⁵ (Abramowitz and Stegun 4.4.45), the same on every machine.
double arc_cosine(double x) {
  return std::sqrt(1 - x) * (1.5707288 + x * (-0.2121144 + x * (0.0742610 - x * 0.0187293)));
}

/// The part of a disc's area on this side of a line that is `height` away from the centre, in radii.
double part_before(double height) {
  if (height >= 1) return 1;
  const double h = std::max(0.0, height);
  return 1 - (arc_cosine(h) - h * std::sqrt(1 - h * h)) / std::numbers::pi;
}

Eigen::Vector3d middle_of(const Addition& addition) {
  Vector2d mean = Vector2d::Zero();
  for (const Vector2d& p : addition.outline) mean += p / static_cast<double>(addition.outline.size());
  return addition.origin + mean.x() * addition.x + mean.y() * addition.y;
}

/// Looks for a place of an addition in whose largest disc that was not felt more readings are expected than
/// chance may leave out: squares of places are divided while one of them may hold such a place.
class VoidSearch {
 public:
  VoidSearch(const Complex& complex, const Segment& s, const Addition& addition)
      : part_(*s.polygon),
        addition_(addition),
        lambda_(complex.setting().scale_at(middle_of(addition)).lambda),
        density_(part_.felt
                     ? part_.felt->density(complex.setting().least.lambda2 / (lambda_ * lambda_))
                     : static_cast<double>(s.count()) / area_felt(part_.chart, part_.perimeter, s.count())),
        most_(most_expected_in_empty_disc(complex.now())),
        unseen_(complex.rules().near ? kUnextended * lambda_ : 0),
        // No disc is looked at farther than where a quarter of it would be too much.
        reach_(std::max(lambda_, 2 * radius_of(most_) + unseen_) * 1.01),
        rounding_(4 * complex.setting().step) {}

  bool finds_any() {
    for (const Vector2d& p : addition_.outline) box_.extend(p);
    if (was_passed()) return true;
    const Vector2d sizes = box_.sizes();
    const double side = std::clamp(sizes.minCoeff(), lambda_ / 4, 4 * lambda_);
    for (double x = 0; x < sizes.x() || x == 0; x += side)
      for (double y = 0; y < sizes.y() || y == 0; y += side)
        if (finds_in(box_.min() + Vector2d(x + side / 2, y + side / 2), side / 2)) return true;
    return false;
  }

 private:
  double radius_of(double expected) const { return std::sqrt(expected / (std::numbers::pi * density_)); }

  /// How far a place is from where the polygon was felt.
  double distance(const Vector2d& place, double within) const {
    const Eigen::Vector3d p = addition_.origin + place.x() * addition_.x + place.y() * addition_.y;
    return part_.felt ? part_.felt->distance(p, within)
                      : distance_to(part_.chart, part_.perimeter, p, within);
  }

  /// Readings expected in the part of the disc that would become surface: at a corner of two sides, the
  /// product of what each leaves, which is right at right angles. `slack`: by which the disc may be moved
  /// away from the limits.
  double expected(const Vector2d& centre, double radius, double slack) const {
    radius -= unseen_;
    if (radius <= 0) return 0;
    double part = 1;
    for (const Addition::Limit& limit : addition_.limits)
      part *= part_before(((centre - limit.through).dot(limit.inwards) + slack) / radius);
    return density_ * std::numbers::pi * radius * radius * part;
  }

  bool holds(const Vector2d& p) const {
    bool inside = false;
    for (std::size_t i = 0, j = addition_.outline.size() - 1; i < addition_.outline.size(); j = i++) {
      const Vector2d &a = addition_.outline[i], &b = addition_.outline[j];
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
        inside = !inside;
    }
    return inside;
  }

  /// Have readings passed through the addition, where nothing was felt?
  bool was_passed() const {
    if (!part_.passages) return false;
    const auto& places = part_.passages->places();
    return std::any_of(places.begin(), places.end(), [&](const Passages::Place& passed) {
      const Eigen::Vector3d off = passed.at - addition_.origin;
      const Vector2d at(off.dot(addition_.x), off.dot(addition_.y));
      return passed.count >= kFewestThroughVoid && box_.contains(at) && holds(at) &&
             distance(at, lambda_ / 4) >= lambda_ / 4;
    });
  }

  /// Is no place of the square too far, if its centre is no farther than `radius` from where it was felt?
  bool none_in(const Vector2d& centre, double around, double radius) const {
    return radius + around <= lambda_ || expected(centre, radius + around, around) <= most_;
  }

  /// In the square of this centre and half side.
  bool finds_in(const Vector2d& centre, double half) {
    if (!box_.intersects(Eigen::AlignedBox2d(centre.array() - half, centre.array() + half))) return false;
    const double around = half * std::numbers::sqrt2;
    // Distances differ by no more than the places do.
    const double bound = std::min(reach_ + around, last_radius_ + (centre - last_centre_).norm() + rounding_);
    if (none_in(centre, around, bound)) return false;
    const double radius = distance(centre, bound);
    if (radius < bound) last_centre_ = centre, last_radius_ = radius;
    if (none_in(centre, around, radius)) return false;
    if (radius > lambda_ && expected(centre, radius, 0) > most_ && holds(centre)) return true;
    if (half < kLeastPlace * lambda_) return false;
    for (const double dx : {-half / 2, half / 2})
      for (const double dy : {-half / 2, half / 2})
        if (finds_in(centre + Vector2d(dx, dy), half / 2)) return true;
    return false;
  }

  const PolygonPart& part_;
  const Addition& addition_;
  Eigen::AlignedBox2d box_;  ///< of the addition
  double lambda_, density_, most_, unseen_, reach_, rounding_;
  /// The place looked at last whose distance is known.
  Vector2d last_centre_ = Vector2d::Zero();
  double last_radius_ = std::numeric_limits<double>::infinity();
};

/// By fixed-point iteration, which converges from any start above 1.
double solve_for_most_expected(std::int64_t m) {
  const double twice = 2 * static_cast<double>(std::max<std::int64_t>(m, 1));
  double a = 10, last = 0;
  for (int i = 0; i < 30 && a != last; ++i)
    last = std::exchange(a, natural_log(twice / kDiscsByChance * (1 + a)));
  return a;
}

}  // namespace

Addition addition_on(const PolygonPart& part, std::span<const geometry::Point2> outline) {
  const double step = part.chart.step();
  const Eigen::Vector3d origin = part.at({0, 0});
  // The chart's axes on the plane: its tilt is at most a few degrees.
  Addition addition{origin, (part.at({1, 0}) - origin) / step, (part.at({0, 1}) - origin) / step, {}, {}};
  for (const geometry::Point2 p : outline) addition.outline.emplace_back(step * p.x, step * p.y);
  return addition;
}

Addition::Limit limit_along(const PolygonPart& part, geometry::Point2 from, geometry::Point2 to) {
  const double step = part.chart.step();
  const Vector2d along = Vector2d(to.x - from.x, to.y - from.y).normalized();
  return {{step * from.x, step * from.y}, {-along.y(), along.x()}};
}

double most_expected_in_empty_disc(std::int64_t m) {
  // Nearly every call while finishing is for the same number of readings.
  thread_local std::pair<std::int64_t, double> last_asked{-1, 0};
  if (last_asked.first != m) last_asked = {m, solve_for_most_expected(m)};
  return last_asked.second;
}

bool chance_explains(const Complex& complex, const Segment& s, const Addition& addition) {
  return s.count() > 0 && addition.outline.size() >= 3 && !VoidSearch(complex, s, addition).finds_any();
}

}  // namespace limpet::model::internal
