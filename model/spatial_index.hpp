// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

namespace limpet::model {

using Box3 = Eigen::AlignedBox3d;

/// An R-tree over the boxes of segments, by their storage slot.
class SpatialIndex {
 public:
  SpatialIndex();
  ~SpatialIndex();
  SpatialIndex(SpatialIndex&&) noexcept;
  SpatialIndex& operator=(SpatialIndex&&) noexcept;

  void insert(const Box3&, std::uint32_t slot);
  /// Precondition: inserted with exactly this box.
  void remove(const Box3&, std::uint32_t slot);
  /// Slots whose boxes meet `box`, in no particular order; `found` is cleared first.
  void query(const Box3& box, std::vector<std::uint32_t>& found) const;
  std::size_t size() const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace limpet::model
