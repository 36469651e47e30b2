// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>
#include <limpet/audit/exact_internal.hpp>
#include <limpet/audit/laws_internal.hpp>

namespace limpet::audit::internal {
namespace {

constexpr double kUnitTolerance = 1e-9;
constexpr double kAxisTolerance = 1e-6;
constexpr double kTanMaxTilt = 0.05240777928304120;  // tan 3 degrees

// The index of the product of coordinates i and j among xx xy xz yy yz zz.
constexpr int kProduct[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

using Matrix = std::array<ExactVector, 3>;

// m² times the covariance matrix.
Matrix scaled_covariance(const Moments& moments) {
  Matrix c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      c[i][j] = Dyadic(moments.m) * Dyadic(moments.product[kProduct[i][j]]) -
                Dyadic(moments.sum[i]) * Dyadic(moments.sum[j]);
  return c;
}

// A symmetric matrix is positive semidefinite when all its principal minors are >= 0.
bool is_positive_semidefinite(const Matrix& c) {
  for (int i = 0; i < 3; ++i) {
    if (c[i][i].sign() < 0) return false;
    const int j = (i + 1) % 3;
    if ((c[i][i] * c[j][j] - c[i][j] * c[i][j]).sign() < 0) return false;
  }
  return dot(c[0], cross(c[1], c[2])).sign() >= 0;
}

bool is_zero(const Moments& moments) {
  for (const Int128 x : moments.sum)
    if (x != 0) return false;
  for (const Int128 x : moments.product)
    if (x != 0) return false;
  return true;
}

double product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Vector& a) { return std::sqrt(product(a, a)); }
double distance(const Vector& a, const Vector& b) { return length({a[0] - b[0], a[1] - b[1], a[2] - b[2]}); }

void judge_moments(const Segment& segment, Report& report) {
  const Moments& moments = segment.moments;
  if (moments.m == 0 && !is_zero(moments))
    report.add("moments", segment_name(segment), "sums of no points are not zero");
  if (moments.m > 0 && !is_positive_semidefinite(scaled_covariance(moments)))
    report.add("moments", segment_name(segment), "no set of points has this covariance");
}

void judge_raw(const Segment& segment, Report& report) {
  if (segment.raw.empty()) return;
  const Moments& moments = segment.moments;
  if (segment.raw.size() != moments.m) {
    report.add("raw", segment_name(segment),
               std::to_string(segment.raw.size()) + " raw points of " + std::to_string(moments.m));
    return;
  }
  ExactVector sum;
  Matrix products;
  for (const RawPoint& point : segment.raw) {
    const ExactVector p = exact(point.position);
    sum = sum + p;
    for (int i = 0; i < 3; ++i) products[i] = products[i] + p[i] * p;
  }
  bool equal = true;
  for (int i = 0; i < 3; ++i) {
    equal = equal && sum[i] == Dyadic(moments.sum[i]);
    for (int j = i; j < 3; ++j) equal = equal && products[i][j] == Dyadic(moments.product[kProduct[i][j]]);
  }
  if (!equal) report.add("raw", segment_name(segment), "raw points do not sum to the moments");
}

void judge_axes(const Segment& segment, Report& report) {
  const double slack = kAxisTolerance * (1 + static_cast<double>(segment.moments.m));
  if (length(segment.axis_sum) > static_cast<double>(segment.moments.m) + slack)
    report.add("axes", segment_name(segment), "the axis sum is longer than m unit vectors");
  if (segment.raw.empty() || segment.raw.size() != segment.moments.m) return;
  Vector sum{};
  for (const RawPoint& point : segment.raw) {
    if (std::abs(length(point.axis) - 1) > kAxisTolerance)
      report.add("axes", segment_name(segment), "a raw axis is no unit vector");
    for (int i = 0; i < 3; ++i) sum[i] += point.axis[i];
  }
  if (distance(sum, segment.axis_sum) > slack)
    report.add("axes", segment_name(segment), "raw axes do not sum to the axis sum");
}

void judge_chart(const Polygon& polygon, Report& report) {
  const Vector &u = polygon.u, &v = polygon.v, &n = polygon.n;
  const Vector right_handed = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                               u[0] * v[1] - u[1] * v[0]};
  const bool orthonormal = std::abs(length(u) - 1) <= kUnitTolerance &&
                           std::abs(length(v) - 1) <= kUnitTolerance &&
                           std::abs(product(u, v)) <= kUnitTolerance;
  if (!orthonormal || distance(right_handed, n) > kUnitTolerance)
    report.add("chart", segment_name(polygon), "u, v, n are not orthonormal and right-handed");
  if (!(std::abs(length(polygon.initial_normal) - 1) <= kUnitTolerance))
    report.add("chart", segment_name(polygon), "the initial normal is no unit vector");
}

void judge_tilt(const Polygon& polygon, Report& report) {
  if (polygon.hx * polygon.hx + polygon.hy * polygon.hy > kTanMaxTilt * kTanMaxTilt)
    report.add("tilt", segment_name(polygon), "plane and chart differ by more than 3 degrees");
}

void judge_outward(const Polygon& polygon, const ExactPlane& plane, Report& report) {
  if (polygon.moments.m > 0 && dot(exact(polygon.axis_sum), plane.normal).sign() >= 0)
    report.add("outward", segment_name(polygon), "the normal does not face against the sensing axes");
}

// The mean squared distance of the m sensor points p from the plane must be below resolution². With N the
// plane's normal, q a point on it, S = Σppᵀ and s = Σp, both sides multiplied by m·|N|²:
//   Σ (N·(step·p - q))² = step²·NᵀSN - 2·step·(N·q)(N·s) + m·(N·q)² < m·resolution²·|N|².
void judge_plane_variance(const Polygon& polygon, const ExactPlane& plane, const Dyadic& step,
                          const Dyadic& resolution, Report& report) {
  const Moments& moments = polygon.moments;
  if (moments.m == 0) return;
  const ExactVector& normal = plane.normal;
  const ExactVector sum = {moments.sum[0], moments.sum[1], moments.sum[2]};
  Dyadic quadratic;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      quadratic = quadratic + normal[i] * normal[j] * Dyadic(moments.product[kProduct[i][j]]);
  const Dyadic offset = dot(normal, plane.q);
  const Dyadic m = moments.m;
  const Dyadic deviation =
      step * step * quadratic - Dyadic(2) * step * offset * dot(normal, sum) + m * offset * offset;
  const Dyadic limit = m * resolution * resolution * dot(normal, normal);
  if (!(deviation < limit))
    report.add("plane-variance", segment_name(polygon),
               "variance about the plane is " +
                   std::to_string(deviation.approximate() / limit.approximate()) + " of resolution^2");
}

}  // namespace

void judge_data(const Segment& segment, Report& report) {
  judge_moments(segment, report);
  judge_raw(segment, report);
  judge_axes(segment, report);
}

void judge_point(const Segment& segment, double step, double resolution, Report& report) {
  const Matrix c = scaled_covariance(segment.moments);
  const Dyadic variance = Dyadic(step) * Dyadic(step) * (c[0][0] + c[1][1] + c[2][2]);
  const Dyadic m = segment.moments.m;
  const Dyadic limit = m * m * Dyadic(resolution) * Dyadic(resolution);
  if (segment.moments.m > 0 && !(variance < limit))
    report.add(
        "point-variance", segment_name(segment),
        "variance is " + std::to_string(variance.approximate() / limit.approximate()) + " of resolution^2");
}

void judge_plane(const Polygon& polygon, double step, double resolution, Report& report) {
  const ExactPlane plane(polygon, step);
  judge_plane_variance(polygon, plane, step, resolution, report);
  judge_chart(polygon, report);
  judge_tilt(polygon, report);
  judge_outward(polygon, plane, report);
}

}  // namespace limpet::audit::internal
