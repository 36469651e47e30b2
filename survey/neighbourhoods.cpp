// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/model/spatial_index_internal.hpp>
#include <limpet/survey/neighbourhoods_internal.hpp>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

namespace limpet::survey {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using PointTree = bgi::rtree<std::pair<Point, std::uint32_t>, bgi::rstar<16>>;

constexpr std::size_t kCentres = 1000;
constexpr std::size_t kMostInNeighbourhood = 1300;

Point to_point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

bool holds_copy(const Neighbourhood& around, const model::SensorPoint& point) {
  return std::any_of(around.points.begin(), around.points.end(),
                     [&](const model::SensorPoint& other) { return other.position == point.position; });
}

/// The boxes of these neighbourhoods.
model::SpatialIndex index_of(const Sampled& sample, const std::vector<std::size_t>& centres,
                             const std::vector<Neighbourhood>& around) {
  double narrowest = std::numeric_limits<double>::max(), farthest = 0;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    if (around[i].radius > 0) narrowest = std::min(narrowest, 2 * around[i].radius);
    farthest = std::max(farthest, sample.points[centres[i]].position.cwiseAbs().maxCoeff());
  }
  model::SpatialIndex boxes(std::max(narrowest, 0x1p-60 * farthest));  // cells are counted by whole numbers
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const Eigen::Vector3d& at = sample.points[centres[i]].position;
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(around[i].radius);
    if (around[i].radius > 0)
      boxes.insert(model::Box3(at - reach, at + reach), static_cast<std::uint32_t>(i));
  }
  return boxes;
}

}  // namespace

struct SampleTree::Tree {
  PointTree points;
};

SampleTree::SampleTree(const Sampled& sample) : sample_(sample) {
  std::vector<std::pair<Point, std::uint32_t>> items;
  for (std::size_t i = 0; i < sample.points.size(); ++i)
    items.emplace_back(to_point(sample.points[i].position), static_cast<std::uint32_t>(i));
  tree_ = std::make_unique<Tree>(Tree{PointTree(items)});
}
SampleTree::~SampleTree() = default;

Neighbourhood SampleTree::nearest(const model::SensorPoint& centre, int count) const {
  std::vector<std::pair<Point, std::uint32_t>> found;
  tree_->points.query(bgi::nearest(to_point(centre.position), static_cast<unsigned>(count)),
                      std::back_inserter(found));
  Neighbourhood around;
  around.weight = sample_.weight;
  for (const auto& [point, index] : found) {
    around.points.push_back(sample_.points[index]);
    around.radius = std::max(around.radius, (around.points.back().position - centre.position).norm());
  }
  return around;
}

std::vector<std::size_t> centres_of(const Sampled& sample) {
  std::vector<std::size_t> centres;
  const std::size_t n = sample.points.size();
  const std::size_t stride = std::max<std::size_t>(1, n / kCentres);
  for (std::size_t i = 0; i < n; i += stride) centres.push_back(i);
  return centres;
}

void collect(const std::function<void(const std::function<void(const model::SensorPoint&)>&)>& pass,
             const Sampled& sample, const std::vector<std::size_t>& centres,
             std::vector<Neighbourhood>& around) {
  const model::SpatialIndex boxes = index_of(sample, centres, around);
  const model::Box3 all = boxes.bounds();
  std::vector<std::uint32_t> near;
  pass([&](const model::SensorPoint& point) {
    if (!all.contains(point.position)) return;
    boxes.query(point.position, near);
    for (const std::uint32_t i : near) {
      Neighbourhood& one = around[i];
      const auto& centre = sample.points[centres[i]];
      if (one.points.size() == kMostInNeighbourhood || (point.position - centre.position).norm() > one.radius)
        continue;
      if (!sample.copies_left_out || !holds_copy(one, point)) one.points.push_back(point);
    }
  });
}

Neighbourhood within(Neighbourhood around, const Eigen::Vector3d& centre, double radius) {
  std::erase_if(around.points,
                [&](const model::SensorPoint& p) { return (p.position - centre).norm() > radius; });
  around.radius = radius;
  return around;
}

}  // namespace limpet::survey
