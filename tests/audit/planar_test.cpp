// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/audit/planar_internal.hpp>
#include <limpet/audit/sweep.hpp>

#include "models.hpp"

namespace limpet::audit {
namespace {

constexpr double kHuge = 0x1p1000;

using Planar = SeededTest;

void expect_orientation_laws(const Point& a, const Point& b, const Point& c) {
  const int sign = orientation(a, b, c);
  EXPECT_EQ(orientation_by_big_numbers(a, b, c), sign);
  EXPECT_EQ(orientation(b, c, a), sign);
  EXPECT_EQ(orientation(c, a, b), sign);
  EXPECT_EQ(orientation(b, a, c), -sign);
  EXPECT_EQ(orientation(a, c, b), -sign);
  EXPECT_EQ(orientation(c, b, a), -sign);
  EXPECT_EQ(orientation(a, a, c), 0);
  EXPECT_EQ(orientation(a, b, a), 0);
  EXPECT_EQ(orientation(a, b, b), 0);
}

// Points next to a line through points far apart, where rounding decides nearly nothing right.
TEST_F(Planar, OrientationLawsOnNearlyCollinearPoints) {
  int collinear = 0;
  for (int run = 0; run < 20000; ++run) {
    const double scale = std::ldexp(1.0, static_cast<int>(uniform(-60, 60)));
    const double reach = uniform(0, 1) ? 1 : 0.1;  // 0.1: no number is whole, whatever the scale
    const double t = uniform_whole(-1000, 1000);
    const Point direction = uniform_point(-50, 50);
    const Point a = uniform_point(-50, 50);
    const Point b = {a.x + 7 * direction.x, a.y + 7 * direction.y};
    Point c = {a.x + t * direction.x, a.y + t * direction.y};
    if (uniform(0, 2) == 0) c.x = std::nextafter(c.x, kHuge);
    const auto place = [&](const Point& p) { return Point{scale * reach * p.x, scale * reach * p.y}; };
    expect_orientation_laws(place(a), place(b), place(c));
    collinear += orientation(place(a), place(b), place(c)) == 0;
  }
  EXPECT_GT(collinear, 2000);
}

// The same points as small whole numbers and as fractions take different paths and must agree.
TEST_F(Planar, OrientationDoesNotDependOnScaleByPowersOfTwo) {
  for (int run = 0; run < 20000; ++run) {
    const std::int64_t limit = std::int64_t{1} << uniform(1, 45);
    const Point p[] = {uniform_point(-limit, limit), uniform_point(-limit, limit),
                       uniform_point(-limit, limit)};
    const int sign = orientation(p[0], p[1], p[2]);
    for (const double scale : {0x1p-80, 0x1p30, 0x1p900}) {
      const auto at = [&](int i) { return Point{scale * p[i].x, scale * p[i].y}; };
      EXPECT_EQ(orientation(at(0), at(1), at(2)), sign);
    }
  }
}

TEST(Orientation, OneStepDecides) {
  const double far = 0x1p40;
  EXPECT_EQ(orientation({-far, -far}, {far, far}, {1, 1}), 0);
  EXPECT_EQ(orientation({-far, -far}, {far, far}, {1, 2}), 1);
  EXPECT_EQ(orientation({-far, -far}, {far, far}, {2, 1}), -1);
  EXPECT_EQ(orientation({0, 0}, {far, far - 1}, {far - 1, far - 2}), -1);
  const double tiny = 0x1p-1074;
  EXPECT_EQ(orientation({-1, -1}, {kHuge, kHuge}, {0, tiny}), 1);
  EXPECT_EQ(orientation({-1, -1}, {kHuge, kHuge}, {tiny, 0}), -1);
  EXPECT_EQ(orientation({-1, -1}, {kHuge, kHuge}, {tiny, tiny}), 0);
}

// The meeting of two lines by Cramer's rule in small integers.
Meeting expected_meeting(const Line& s, const Line& t) {
  const auto cross = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
  const double rx = s.b.x - s.a.x, ry = s.b.y - s.a.y, qx = t.b.x - t.a.x, qy = t.b.y - t.a.y;
  const double wx = t.a.x - s.a.x, wy = t.a.y - s.a.y;
  double d = cross(rx, ry, qx, qy);
  if (d != 0) {
    double along_s = cross(wx, wy, qx, qy), along_t = cross(wx, wy, rx, ry);
    if (d < 0) d = -d, along_s = -along_s, along_t = -along_t;
    if (along_s < 0 || along_s > d || along_t < 0 || along_t > d) return Meeting::kNone;
    const bool inner = along_s > 0 && along_s < d && along_t > 0 && along_t < d;
    return inner ? Meeting::kCross : Meeting::kTouch;
  }
  if (cross(wx, wy, rx, ry) != 0) return Meeting::kNone;
  const double length = rx * rx + ry * ry;
  const double begin = wx * rx + wy * ry, end = begin + qx * rx + qy * ry;
  const double low = std::max(0.0, std::min(begin, end)), high = std::min(length, std::max(begin, end));
  if (low > high) return Meeting::kNone;
  return low == high ? Meeting::kTouch : Meeting::kOverlap;
}

/// The ith point of an n by n lattice.
Point lattice_point(int i, int n) {
  const int row = i / n;
  return {double(i % n), double(row)};
}

TEST(Meeting, AgreesWithCramersRuleOnEveryPairOfASmallGrid) {
  constexpr int n = 3;
  std::vector<Line> lines;
  for (int i = 0; i < n * n; ++i)
    for (int j = 0; j < n * n; ++j)
      if (i != j) lines.push_back({lattice_point(i, n), lattice_point(j, n)});
  for (const Line& s : lines)
    for (const Line& t : lines) {
      ASSERT_EQ(meeting(s, t), expected_meeting(s, t));
      ASSERT_EQ(meeting(t, s), meeting(s, t));
    }
}

TEST(SideOf, AgreesWithOrientationOnEverySmallTriangle) {
  constexpr int n = 4;
  const auto at = [](int i) { return lattice_point(i, n); };
  for (int i = 0; i < n * n; ++i)
    for (int j = 0; j < n * n; ++j)
      for (int k = 0; k < n * n; ++k) {
        const Outline triangle = {at(i), at(j), at(k)};
        if (orientation(at(i), at(j), at(k)) == 0) continue;
        for (int l = 0; l < n * n; ++l) {
          std::set<int> signs;
          for (int e = 0; e < 3; ++e) signs.insert(orientation(triangle[e], triangle[(e + 1) % 3], at(l)));
          const bool outside = signs.count(1) && signs.count(-1);
          const Side expected = outside ? Side::kOutside : signs.count(0) ? Side::kOn : Side::kInside;
          ASSERT_EQ(side_of(at(l), triangle), expected);
        }
      }
}

TEST(SideOf, KnowsNotchesAndOneStep) {
  const Outline comb = {{0, 0}, {8, 0}, {8, 8}, {6, 8}, {6, 2}, {4, 2}, {4, 8}, {2, 8}, {2, 4}, {0, 4}};
  EXPECT_EQ(side_of({5, 2}, comb), Side::kOn);
  EXPECT_EQ(side_of({5, 3}, comb), Side::kOutside);
  EXPECT_EQ(side_of({5, 1}, comb), Side::kInside);
  EXPECT_EQ(side_of({1, 4}, comb), Side::kOn);
  EXPECT_EQ(side_of({3, 4}, comb), Side::kInside);
  EXPECT_EQ(side_of({-1, 4}, comb), Side::kOutside);
  EXPECT_EQ(side_of({-1, 8}, comb), Side::kOutside);
  EXPECT_EQ(side_of({9, 2}, comb), Side::kOutside);
}

TEST(TwiceArea, IsExactAndSigned) {
  const double far = 0x1p40;
  const Outline sliver = {{-far, -far}, {far, far - 1}, {far, far}};
  EXPECT_EQ(twice_area(sliver), Dyadic(2 * far));
  EXPECT_EQ(twice_area(reversed(sliver)), Dyadic(-2 * far));
  EXPECT_EQ(twice_area(scaled(sliver, 0x1p-70)), Dyadic(2 * far * 0x1p-140));
  EXPECT_EQ(twice_area(scaled(sliver, 0x1p20)), Dyadic(2 * far * 0x1p40));
  EXPECT_EQ(area_sign(sliver), 1);
  EXPECT_EQ(area_sign(reversed(sliver)), -1);
  EXPECT_EQ(area_sign(Outline{{0, 0}, {2, 2}, {1, 1}}), 0);
  EXPECT_EQ(area_sign(Outline{{0, 0}, {2, 2}}), 0);
}

TEST_F(Planar, DyadicArithmeticAgreesWithIntegers) {
  for (int run = 0; run < 5000; ++run) {
    const std::int64_t a = uniform(-1000000, 1000000), b = uniform(-1000, 1000);
    const double scale = std::ldexp(1.0, static_cast<int>(uniform(-200, 200)));
    const Dyadic x = static_cast<double>(a) * scale, y = static_cast<double>(b) * scale;
    EXPECT_EQ(x + y, Dyadic(static_cast<double>(a + b) * scale));
    EXPECT_EQ(x - y, Dyadic(static_cast<double>(a - b) * scale));
    EXPECT_EQ(x * y, Dyadic(static_cast<double>(a * b)) * Dyadic(scale) * Dyadic(scale));
    EXPECT_EQ(x < y, a < b);
    EXPECT_EQ(x <= y, a <= b);
    EXPECT_DOUBLE_EQ((x * y).approximate(), static_cast<double>(a * b) * scale * scale);
  }
}

bool has_clash_by_pairs(const std::vector<Outline>& cycles) {
  struct Edge {
    Line line;
    std::size_t cycle, index, next;
  };
  std::vector<Edge> edges;
  for (std::size_t c = 0; c < cycles.size(); ++c)
    for (std::size_t i = 0; i < cycles[c].size(); ++i) {
      const std::size_t next = (i + 1) % cycles[c].size();
      edges.push_back({{cycles[c][i], cycles[c][next]}, c, i, next});
    }
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Edge &e = edges[i], &f = edges[j];
      const bool consecutive = e.cycle == f.cycle && (e.next == f.index || f.next == e.index);
      const Meeting how = meeting(e.line, f.line);
      if (consecutive ? how == Meeting::kOverlap : how != Meeting::kNone) return true;
    }
  return false;
}

// Small grids make every degeneracy common: touching vertices, overlaps, spikes, vertical edges.
TEST_F(Planar, SweepAgreesWithTestingEveryPair) {
  int simple = 0, clashing = 0;
  for (int run = 0; run < 200000; ++run) {
    const std::int64_t size = uniform(2, 6);
    std::vector<Outline> cycles(static_cast<std::size_t>(uniform(0, 3) == 0 ? 2 : 1));
    bool degenerate = false;
    for (Outline& cycle : cycles) {
      for (std::int64_t n = uniform(3, 7); n > 0; --n) cycle.push_back(uniform_point(0, size));
      for (std::size_t i = 0; i < cycle.size(); ++i)
        degenerate = degenerate || cycle[i] == cycle[(i + 1) % cycle.size()];
    }
    if (degenerate) continue;
    const bool expected = has_clash_by_pairs(cycles);
    ASSERT_EQ(find_clash(cycles).has_value(), expected) << ::testing::PrintToString(run);
    ++(expected ? clashing : simple);
  }
  EXPECT_GT(simple, 10000);
  EXPECT_GT(clashing, 10000);
}

}  // namespace
}  // namespace limpet::audit
