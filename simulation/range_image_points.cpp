// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/simulation/range_image.hpp>
#include <limpet/simulation/range_image_internal.hpp>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;
namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
using Place = bg::model::point<double, 3, bg::cs::cartesian>;
using Entry = std::pair<Place, std::size_t>;
using PointTree = bgi::rtree<Entry, bgi::rstar<16>>;

constexpr unsigned kForNormal = 12;  ///< points: the two rings of neighbours in a square grid
/// Of the two variances in the fitted plane: below this ratio the points are in a line.
constexpr double kLine = 0.01;

Place place(const Vector3d& p) { return {p.x(), p.y(), p.z()}; }

PointTree tree_of(const std::vector<Vector3d>& points) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < points.size(); ++i) entries.emplace_back(place(points[i]), i);
  return PointTree(entries);
}

/// The points nearest to one of them, this one among them.
void nearest(const PointTree& tree, const std::vector<Vector3d>& points, std::size_t i, unsigned count,
             std::vector<Entry>& near) {
  near.clear();
  tree.query(bgi::nearest(place(points[i]), count), std::back_inserter(near));
}

Vector3d normal_through(const std::vector<Entry>& near, const std::vector<Vector3d>& points,
                        const Vector3d& direction) {
  Vector3d mean = Vector3d::Zero();
  for (const auto& [at, i] : near) mean += points[i] / static_cast<double>(near.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto& [at, i] : near) spread += (points[i] - mean) * (points[i] - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  if (solver.eigenvalues()[1] <= kLine * solver.eigenvalues()[2]) return -direction;
  const Vector3d normal = solver.eigenvectors().col(0);
  return normal.dot(direction) > 0 ? Vector3d(-normal) : normal;
}

}  // namespace

void require_image(const std::vector<Vector3d>& points) {
  if (points.size() < 2) throw MeshError("a range image needs two points or more");
  if (!std::all_of(points.begin(), points.end(), [](const Vector3d& p) { return p.allFinite(); }))
    throw MeshError("a range image has a point that is not finite");
}

double image_epsilon(const std::vector<Vector3d>& points) {
  require_image(points);
  const PointTree tree = tree_of(points);
  std::vector<Entry> near;
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    nearest(tree, points, i, 2, near);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [at, other] : near)
      if (other != i) least = std::min(least, (points[other] - points[i]).norm());
    largest = std::max(largest, least);
  }
  if (largest == 0) throw MeshError("each point of the range image is there more than once");
  return largest;
}

std::vector<Vector3d> image_normals(const std::vector<Vector3d>& points, const Vector3d& direction) {
  const PointTree tree = tree_of(points);
  std::vector<Entry> near;
  std::vector<Vector3d> normals;
  for (std::size_t i = 0; i < points.size(); ++i) {
    nearest(tree, points, i, kForNormal, near);
    normals.push_back(normal_through(near, points, direction));
  }
  return normals;
}

}  // namespace limpet::simulation
