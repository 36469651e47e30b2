// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limits>
#include <limpet/drawing/depth_order.hpp>
#include <queue>

namespace limpet::drawing {
namespace {

constexpr std::size_t kMostPairwise = 3000;
constexpr double kTouching = 0.05;  // pixels: faces that meet at an edge are not in front of each other

/// What the order needs to know of a face.
struct Slab {
  Eigen::Vector3d low, high, normal, anchor;
  double mean_depth = 0;
};

Slab slab_of(const Patch& patch) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Slab slab{Eigen::Vector3d::Constant(kFar), Eigen::Vector3d::Constant(-kFar), patch.normal, {0, 0, 0}, 0};
  if (slab.normal.z() > 0) slab.normal = -slab.normal;  // towards the viewer
  const auto& points = patch.outlines.front().points;
  slab.anchor = points.front();
  for (const Eigen::Vector3d& p : points) {
    slab.low = slab.low.cwiseMin(p);
    slab.high = slab.high.cwiseMax(p);
    slab.mean_depth += p.z() / static_cast<double>(points.size());
  }
  return slab;
}

bool overlap(const Slab& a, const Slab& b) {
  for (int i = 0; i < 2; ++i) {
    if (a.low[i] >= b.high[i] - kTouching || b.low[i] >= a.high[i] - kTouching) return false;
  }
  return true;
}

/// Where `patch` lies of the plane of `slab`: 1 all before it, -1 all behind, 0 on both sides (or edge-on).
int side(const Patch& patch, const Slab& slab) {
  if (slab.normal.z() > -1e-6) return 0;
  bool before = false, behind = false;
  for (const Eigen::Vector3d& p : patch.outlines.front().points) {
    const double distance = slab.normal.dot(p - slab.anchor);
    before |= distance > kTouching;
    behind |= distance < -kTouching;
  }
  return before == behind ? 0 : before ? 1 : -1;
}

/// True when a must be painted before b.
bool is_behind(const Patch& a, const Slab& slab_a, const Patch& b, const Slab& slab_b) {
  if (slab_a.low.z() >= slab_b.high.z()) return true;
  if (slab_b.low.z() >= slab_a.high.z()) return false;
  if (const int s = side(a, slab_b); s != 0) return s < 0;
  if (const int s = side(b, slab_a); s != 0) return s > 0;
  return slab_a.mean_depth > slab_b.mean_depth;
}

}  // namespace

std::vector<int> depth_order(const std::vector<Patch>& patches) {
  std::vector<Slab> slabs;
  for (const Patch& patch : patches) slabs.push_back(slab_of(patch));
  const int count = static_cast<int>(patches.size());
  std::vector<int> by_depth(patches.size());
  for (int i = 0; i < count; ++i) by_depth[i] = i;
  std::stable_sort(by_depth.begin(), by_depth.end(),
                   [&](int a, int b) { return slabs[a].mean_depth > slabs[b].mean_depth; });
  if (patches.size() > kMostPairwise) return by_depth;

  std::vector<std::vector<int>> before(patches.size());  // faces to be painted after this one
  std::vector<int> waits_for(patches.size(), 0);
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (!overlap(slabs[a], slabs[b])) continue;
      const bool a_first = is_behind(patches[a], slabs[a], patches[b], slabs[b]);
      before[a_first ? a : b].push_back(a_first ? b : a);
      ++waits_for[a_first ? b : a];
    }
  }
  std::vector<int> rank(patches.size()), order;
  for (int i = 0; i < count; ++i) rank[by_depth[i]] = i;
  std::priority_queue<int, std::vector<int>, std::greater<>> ready;  // by rank, farthest first
  for (int i = 0; i < count; ++i) {
    if (waits_for[i] == 0) ready.push(rank[i]);
  }
  std::vector<bool> painted(patches.size(), false);
  for (int next_by_depth = 0; static_cast<int>(order.size()) < count;) {
    int face = 0;
    if (!ready.empty()) {
      face = by_depth[ready.top()];
      ready.pop();
    } else {  // a circle of overlaps: break it at the farthest face left
      while (painted[by_depth[next_by_depth]]) ++next_by_depth;
      face = by_depth[next_by_depth];
    }
    if (painted[face]) continue;
    painted[face] = true;
    order.push_back(face);
    for (const int later : before[face]) {
      if (--waits_for[later] == 0) ready.push(rank[later]);
    }
  }
  return order;
}

}  // namespace limpet::drawing
