// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/model/spatial_index.hpp>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

namespace limpet::model {
namespace {

namespace bg = boost::geometry;
using Corner = bg::model::point<double, 3, bg::cs::cartesian>;
using TreeBox = bg::model::box<Corner>;
using Entry = std::pair<TreeBox, std::uint32_t>;

TreeBox tree_box(const Box3& b) {
  return {Corner(b.min().x(), b.min().y(), b.min().z()), Corner(b.max().x(), b.max().y(), b.max().z())};
}

}  // namespace

struct SpatialIndex::Tree {
  bg::index::rtree<Entry, bg::index::quadratic<16>> entries;
};

SpatialIndex::SpatialIndex() : tree_(std::make_unique<Tree>()) {}
SpatialIndex::~SpatialIndex() = default;
SpatialIndex::SpatialIndex(SpatialIndex&&) noexcept = default;
SpatialIndex& SpatialIndex::operator=(SpatialIndex&&) noexcept = default;

void SpatialIndex::insert(const Box3& box, std::uint32_t slot) {
  tree_->entries.insert({tree_box(box), slot});
}

void SpatialIndex::remove(const Box3& box, std::uint32_t slot) {
  tree_->entries.remove(Entry{tree_box(box), slot});
}

void SpatialIndex::query(const Box3& box, std::vector<std::uint32_t>& found) const {
  found.clear();
  tree_->entries.query(
      bg::index::intersects(tree_box(box)),
      boost::make_function_output_iterator([&](const Entry& e) { found.push_back(e.second); }));
}

std::size_t SpatialIndex::size() const { return tree_->entries.size(); }

}  // namespace limpet::model
