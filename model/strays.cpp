// Copyright the limpet authors. GPL-3.0-or-later.
//
// The first points of a polygon may be of two faces, if the edge between them is blunt or the points are few.
// They turn its plane, so that it takes more of them. Here each point is asked which plane it lies nearest
// to, and the plane is fitted to those that are left, until they stay the same (k-planes: Bradley and
// Mangasarian 2000, with the other planes held).
#include "strays_internal.hpp"

#include <algorithm>
#include <limits>

#include "promotion_internal.hpp"
#include "standing_internal.hpp"

namespace limpet::model::internal {
namespace {

/// Parts the points of a young polygon into its own and strays.
class Parting {
 public:
  Parting(const Complex& complex, const Segment& s) : complex_(complex), raw_(s.data.raw()) {
    nearest_.assign(raw_.size(), std::numeric_limits<double>::infinity());
    Box3 box;
    for (const RawPoint& raw : raw_) box.extend(complex.setting().world(raw.at));
    std::vector<std::uint32_t> found;
    complex.polygons().query(box, found);
    for (const std::uint32_t slot : found) {
      const Segment& other = complex.at(slot);
      if (&other != &s && !other.initial() &&
          other.fit.normal.dot(s.fit.normal) < complex.setting().cos_angle)
        compare_with(other);
    }
    heights_over(s.fit);
    stray_.assign(raw_.size(), false);
  }

  /// Are there strays, without which the points lie nearer to the planes they are of, by four standard
  /// deviations, and are the others a polygon without them?
  bool find() {
    if (std::none_of(nearest_.begin(), nearest_.end(), [](double h2) { return std::isfinite(h2); }))
      return false;
    const double before = misfit();
    for (int round = 0; round < kMaxPartingRounds && part(); ++round) {
      own_sums_ = {};
      for (const RawPoint& raw : own()) own_sums_.add(raw);
      if (own_sums_.moments.count() < kFewestKept) return false;
      own_fit_ = fit_to(own_sums_.moments, complex_.setting().step, own_sums_.axis);
      heights_over(own_fit_);
    }
    const auto strays = static_cast<std::size_t>(std::count(stray_.begin(), stray_.end(), true));
    if (strays < kFewestStrays) return false;
    if (before - misfit() <= kStrayGain) return false;
    const std::vector<RawPoint> kept = own();
    for (const RawPoint& raw : kept) own_sums_.since += static_cast<double>(raw.since);
    return promotable(complex_, own_fit_, own_sums_, {&kept});
  }

  std::vector<RawPoint> own() const { return points(false); }
  std::vector<RawPoint> strays() const { return points(true); }

 private:
  /// Notes which points fit another polygon, and how well.
  void compare_with(const Segment& other) {
    for (std::size_t i = 0; i < raw_.size(); ++i) {
      const double height = other.fit.height_of(complex_.setting().world(raw_[i].at));
      if (height * height < nearest_[i] && fits(complex_.setting(), raw_[i], other))
        nearest_[i] = height * height;
    }
  }
  void heights_over(const Fit& fit) {
    heights_.clear();
    for (const RawPoint& raw : raw_) {
      const double height = fit.height_of(complex_.setting().world(raw.at));
      heights_.push_back(height * height);
    }
  }
  /// Each point goes to the plane it lies nearest to. Returns whether that has changed any.
  bool part() {
    std::vector<bool> stray(raw_.size());
    for (std::size_t i = 0; i < raw_.size(); ++i) stray[i] = nearest_[i] < heights_[i];
    const bool changed = stray != stray_;
    stray_ = std::move(stray);
    return changed;
  }
  /// The squares of the heights over the planes they are given to, in variances.
  double misfit() const {
    double sum = 0;
    for (std::size_t i = 0; i < raw_.size(); ++i)
      sum += (stray_[i] ? nearest_[i] : heights_[i]) / raw_[i].variance;
    return sum;
  }
  std::vector<RawPoint> points(bool stray) const {
    std::vector<RawPoint> result;
    for (std::size_t i = 0; i < raw_.size(); ++i)
      if (stray_[i] == stray) result.push_back(raw_[i]);
    return result;
  }

  const Complex& complex_;
  const std::vector<RawPoint>& raw_;
  std::vector<double> nearest_;  ///< squared heights over the nearest other plane; infinite where none fits
  std::vector<double> heights_;  ///< squared heights over the own plane
  std::vector<bool> stray_;
  SegmentData::Sums own_sums_;
  Fit own_fit_;
};

bool part_from_strays(Complex& complex, Insertion& insertion, const Segment& s) {
  Parting parting(complex, s);
  if (!parting.find()) return false;
  const std::vector<RawPoint> own = parting.own(), strays = parting.strays();
  complex.remove(s);
  insertion.insert_as_polygon(own);
  for (const RawPoint& stray : strays) insertion.pending().push_back(stray);
  insertion.insert_pending();
  return true;
}

/// Returns whether there were any.
bool part_all_once(Complex& complex, Insertion& insertion) {
  Turn young;
  complex.segments().for_each([&](const Segment& s) {
    if (s.polygon && s.young() && !s.initial()) young.emplace_back(s.id, s.slot);
  });
  std::sort(young.begin(), young.end());
  bool any = false;
  for (const auto& [id, slot] : young) {
    if (insertion.stopped()) return false;
    if (const Segment* s = complex.find(id, slot); s && s->young())
      any |= part_from_strays(complex, insertion, *s);
  }
  return any;
}

}  // namespace

void part_from_strays(Complex& complex, Insertion& insertion) {
  if (!complex.rules().strays) return;
  for (int turn = 0; turn < kMaxPartingTurns && part_all_once(complex, insertion); ++turn) {
  }
}

}  // namespace limpet::model::internal
