// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/curved_patches.hpp>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limpet/survey/noise_law.hpp>

namespace limpet::survey {
namespace {

constexpr std::size_t kFewestPoints = 12;  ///< twice as many as a quadric has coefficients
constexpr double kOnePlace = 1e-24;        ///< of the distance from the origin, squared: rounding
constexpr double kExplained = 1.2;         ///< of the noise: scatter about a quadric that fits
constexpr double kTurnsAway = 1.25;        ///< of the noise: scatter about a plane that does not

/// Standard deviation of the heights about their best fit by the first `Count` terms. By normal equations:
/// patches are as wide as 1, and what is asked is whether two scatters differ by a fifth.
template <int Count>
double scatter_about(const Eigen::Matrix<double, Eigen::Dynamic, 6>& terms, const Eigen::VectorXd& heights) {
  const auto used = terms.leftCols<Count>();
  const Eigen::Matrix<double, Count, Count> normal = used.transpose() * used;
  const Eigen::Matrix<double, Count, 1> best = normal.ldlt().solve(used.transpose() * heights);
  return (heights - used * best).norm() / std::sqrt(static_cast<double>(terms.rows() - Count));
}

}  // namespace

std::optional<PatchScatter> patch_scatter(const std::vector<Eigen::Vector3d>& points,
                                          const Eigen::Vector3d& normal) {
  if (points.size() < kFewestPoints) return std::nullopt;
  const auto rows = static_cast<Eigen::Index>(points.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& p : points) mean += p / static_cast<double>(rows);
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  Eigen::Matrix<double, Eigen::Dynamic, 6> terms(rows, 6);
  Eigen::VectorXd heights(rows);
  double width2 = 0;
  for (const auto& p : points) width2 = std::max(width2, (p - mean).squaredNorm());
  if (!(width2 > kOnePlace * mean.squaredNorm())) return std::nullopt;
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Eigen::Vector3d d = (points[static_cast<std::size_t>(i)] - mean) / std::sqrt(width2);
    const double x = d.dot(u), y = d.dot(v);
    terms.row(i) << 1, x, y, x * x, x * y, y * y;
    heights[i] = d.dot(normal) * std::sqrt(width2);
  }
  return PatchScatter{scatter_about<3>(terms, heights), scatter_about<6>(terms, heights)};
}

double surface_curvature(const std::vector<WidePatch>& wide, std::size_t centres) {
  std::vector<double> found;
  for (const WidePatch& patch : wide) {
    const auto& [plane, quadric] = patch.scatter;
    if (plane > kTurnsAway * patch.noise && quadric < kExplained * patch.noise)
      found.push_back(4 * std::sqrt(plane * plane - quadric * quadric) / (patch.radius * patch.radius));
  }
  return 2 * found.size() < centres ? 0 : quantile(found, 0.5);
}

}  // namespace limpet::survey
