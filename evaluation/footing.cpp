// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <iterator>
#include <limpet/evaluation/footing_internal.hpp>
#include <utility>

namespace limpet::evaluation {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

using Eigen::Vector3d;
using Place = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<Place>;
using Entry = std::pair<Box, int>;

constexpr double kDeviations = 3;

Place place(const Vector3d& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

std::vector<Ground> grounds_of(const model::ModelRecord& model) {
  std::vector<Ground> grounds;
  for (const PlanarFace& face : planar_faces(model)) grounds.push_back({Region(face), FlatPolygon(face)});
  return grounds;
}

Tolerance::Tolerance(const model::ModelRecord& model)
    : noise_(survey::noise_of(model.parameters)),
      least_(model.parameters.tolerance),
      rounding_(2 * model.grid_step + model.parameters.input_quantum) {}

double Tolerance::at(double range) const {
  return std::max(least_, kDeviations * noise_.at(range)) + rounding_;
}

struct Footing::Index {
  bgi::rtree<Entry, bgi::quadratic<16>> boxes;
};

Footing::Footing(const std::vector<Ground>& grounds, const ResolutionField& reach, double most_tolerance)
    : grounds_(grounds), reach_(reach), index_(std::make_unique<Index>()) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < grounds.size(); ++i) {
    const Region& region = grounds[i].region;
    if (region.triangles.empty()) continue;
    // λ a little outside the box is larger than in it by no more than a quarter of the way.
    const double most = reach.largest(region.low, region.high);
    const Vector3d beyond = Vector3d::Constant(std::hypot(reach.grows() ? 2 * most : most, most_tolerance));
    entries.emplace_back(Box(place(region.low - beyond), place(region.high + beyond)), static_cast<int>(i));
  }
  index_->boxes = decltype(index_->boxes)(entries);
}

Footing::~Footing() = default;

void Footing::each(const model::SensorPoint& reading, double tolerance,
                   const std::function<void(const Foot&)>& visit) const {
  std::vector<Entry> near;
  index_->boxes.query(bgi::intersects(place(reading.position)), std::back_inserter(near));
  std::sort(near.begin(), near.end(), [](const Entry& a, const Entry& b) { return a.second < b.second; });
  for (const auto& [box, polygon] : near) {
    const Region& region = grounds_[polygon].region;
    if (region.face.normal.dot(reading.axis) >= 0) continue;
    const double height = std::abs(grounds_[polygon].flat.height(reading.position));
    if (height > tolerance) continue;
    const double beside = region.surface.distance(region.foot(reading.position));
    if (beside <= reach_.at(reading.position)) visit({polygon, std::hypot(height, beside)});
  }
}

}  // namespace limpet::evaluation
