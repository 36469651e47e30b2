// Copyright the limpet authors. GPL-3.0-or-later.
#include "spatial_index_internal.hpp"

#include <algorithm>

namespace limpet::model {
namespace {

constexpr double kFactor = 4;  ///< ratio of the cells' widths from one level to the next
constexpr double kSpan = 2;    ///< most cells that a box is wide, on its level

}  // namespace

void SpatialIndex::Blocks::add(const Index& cell) {
  const Index block = block_of(cell);
  std::size_t i = place_of(block);
  if (!places_[i].taken) {
    if (2 * (taken_ + 1) > places_.size()) make_room(), i = place_of(block);
    places_[i] = {block, 0, true};
    ++taken_;
  }
  places_[i].cells |= bit_of(cell);
}

void SpatialIndex::Blocks::remove(const Index& cell) {
  places_[place_of(block_of(cell))].cells &= ~bit_of(cell);
}

/// Forgets the blocks that have become empty, and enlarges the table if that does not free enough places.
void SpatialIndex::Blocks::make_room() {
  std::vector<Block> kept;
  for (const Block& block : places_)
    if (block.cells != 0) kept.push_back(block);
  std::size_t size = 16;
  while (size < 4 * (kept.size() + 1)) size *= 2;
  places_.assign(size, {});
  taken_ = kept.size();
  for (const Block& block : kept) places_[place_of(block.at)] = block;
}

SpatialIndex::Cell& SpatialIndex::Grid::find_or_make(const Index& at) {
  const std::uint64_t key = key_of(at);
  std::size_t i = place_of(key);
  if (places_[i].cell == 0) {
    if (2 * (cells_.size() + 1) > places_.size()) make_room(), i = place_of(key);
    cells_.emplace_back();
    places_[i] = {key, static_cast<std::uint32_t>(cells_.size())};
  }
  return cells_[places_[i].cell - 1];
}

/// Forgets the cells that have become empty, and enlarges the table if that does not free enough places.
void SpatialIndex::Grid::make_room() {
  std::vector<Cell> cells;
  std::vector<Place> kept;
  for (const Place& place : places_) {
    if (place.cell == 0 || cells_[place.cell - 1].empty()) continue;
    cells.push_back(std::move(cells_[place.cell - 1]));
    kept.push_back({place.key, static_cast<std::uint32_t>(cells.size())});
  }
  cells_ = std::move(cells);
  std::size_t size = 16;
  while (size < 4 * (cells_.size() + 1)) size *= 2;
  places_.assign(size, {});
  for (const Place& place : kept) places_[place_of(place.key)] = place;
}

void SpatialIndex::Grid::insert(const Entry& entry) {
  range_of(entry.box).for_each([&](const Index& at) {
    find_or_make(at).push_back(entry);
    in_use_.add(at);
  });
  ++size_;
  bounds_.extend(entry.box);
}

void SpatialIndex::Grid::remove(const Entry& entry) {
  range_of(entry.box).for_each([&](const Index& at) {
    Cell& cell = cells_[places_[place_of(key_of(at))].cell - 1];
    const auto mine =
        std::find_if(cell.begin(), cell.end(), [&](const Entry& e) { return e.slot == entry.slot; });
    *mine = cell.back();
    cell.pop_back();
    if (!cell.empty()) return;
    cell = Cell();  // `= {}` would keep the memory
    in_use_.remove(at);
  });
  --size_;
}

void SpatialIndex::Grid::query(const Eigen::Vector3d& p, std::vector<std::uint32_t>& found) const {
  const Cell* cell = find(index_of(p));
  if (!cell) return;
  for (const Entry& e : *cell) {
    const Eigen::Vector3d &low = e.box.min(), &high = e.box.max();
    if (p.x() >= low.x() && p.x() <= high.x() && p.y() >= low.y() && p.y() <= high.y() && p.z() >= low.z() &&
        p.z() <= high.z())
      found.push_back(e.slot);
  }
}

std::size_t SpatialIndex::level_of(const Box3& box) const {
  const double extent = box.sizes().maxCoeff();
  std::size_t level = 0;
  for (double width = smallest_; kSpan * width < extent; width *= kFactor) ++level;
  return level;
}

void SpatialIndex::insert(const Box3& box, std::uint32_t slot) {
  const std::size_t level = level_of(box);
  while (levels_.size() <= level)
    levels_.emplace_back(levels_.empty() ? smallest_ : kFactor * levels_.back().width());
  levels_[level].insert({box, slot});
}

void SpatialIndex::remove(const Box3& box, std::uint32_t slot) { levels_[level_of(box)].remove({box, slot}); }

void SpatialIndex::query(const Box3& box, std::vector<std::uint32_t>& found) const {
  found.clear();
  any_of(box, [&](std::uint32_t slot) {
    found.push_back(slot);
    return false;
  });
}

void SpatialIndex::query(const Eigen::Vector3d& point, std::vector<std::uint32_t>& found) const {
  found.clear();
  for (const Grid& grid : levels_)
    if (grid.size() > 0) grid.query(point, found);
}

std::pair<double, double> SpatialIndex::Ray::within(const Box3& box) const {
  double first = -std::numeric_limits<double>::infinity(), last = -first;
  for (int i = 0; i < 3; ++i) {
    if (axis[i] == 0) {
      if (from[i] < box.min()[i] || from[i] > box.max()[i]) return {1, 0};
      continue;
    }
    const double t = (box.min()[i] - from[i]) / axis[i], u = (box.max()[i] - from[i]) / axis[i];
    first = std::max(first, std::min(t, u)), last = std::min(last, std::max(t, u));
  }
  return {first, last};
}

Box3 SpatialIndex::bounds() const {
  Box3 all;
  for (const Grid& grid : levels_) all.extend(grid.bounds());
  return all;
}

std::size_t SpatialIndex::size() const {
  std::size_t size = 0;
  for (const Grid& grid : levels_) size += grid.size();
  return size;
}

}  // namespace limpet::model
