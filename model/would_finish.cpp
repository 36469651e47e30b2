// Copyright the limpet authors. GPL-3.0-or-later.
//
// What finish() would close, tried on a copy. An edge that still exists on the copy is closed if it is shared
// there. If it is gone, the nearest edge of its segment within λ of its middle stands for it; if there is
// none, the gap has been filled.
#include "would_finish_internal.hpp"

#include <algorithm>
#include <unordered_map>

#include "open_edges_internal.hpp"
#include "piece_internal.hpp"
#include "state_internal.hpp"

namespace limpet::model::internal {
namespace {

using geometry::EdgeId;
using geometry::Slot;

Piece piece_of(const PolygonPart& part, Slot edge) {
  return {part.position(edge), part.position(part.perimeter.next(edge))};
}

double squared_distance(const Piece& piece, const Eigen::Vector3d& p) {
  return (piece.at(piece.nearest(p)) - p).squaredNorm();
}

/// The edges of a finished model, by place.
class Finished {
 public:
  explicit Finished(const Complex& complex) : setting_(complex.setting()), index_(setting_.least.lambda) {
    complex.segments().for_each([&](const Segment& s) {
      if (!s.polygon) return;
      for_each_edge(s.polygon->perimeter, [&](Slot slot) {
        const Piece piece = piece_of(*s.polygon, slot);
        Box3 box(piece.a);
        index_.insert(box.extend(piece.b), static_cast<std::uint32_t>(edges_.size()));
        edges_.push_back({s.id, s.polygon->perimeter.node(slot).edge, piece});
      });
    });
  }

  /// The edge nearest to p within λ, on this segment, or on any if `on` is none.
  std::optional<EdgeId> nearest(const Eigen::Vector3d& p, SegmentId on) const {
    std::vector<std::uint32_t> found;
    const Scale scale = setting_.scale_at(p);
    index_.query(box_around(p, scale.lambda), found);
    std::pair<double, EdgeId> best{scale.lambda2, {}};
    for (const std::uint32_t i : found)
      if (!on || edges_[i].segment == on)
        best = std::min(best, std::pair(squared_distance(edges_[i].piece, p), edges_[i].edge));
    return best.second ? std::optional(best.second) : std::nullopt;
  }

 private:
  struct Edge {
    SegmentId segment;
    EdgeId edge;
    Piece piece;
  };
  const Setting& setting_;
  std::vector<Edge> edges_;
  SpatialIndex index_;
};

void add_open_edges(const Segment& s, std::vector<Outcome::Left>& left) {
  for_each_edge(s.polygon->perimeter, [&](Slot slot) {
    if (s.polygon->perimeter.node(slot).shared) return;
    const Piece piece = piece_of(*s.polygon, slot);
    left.push_back({s.id, piece.a, piece.b});
  });
}

}  // namespace

Outcome would_finish(const Engine& e) {
  const std::string bytes = to_state(e, false);
  const StoredState stored(bytes);
  Engine copy(stored.parameters());
  stored.restore(copy);
  finish(copy);

  Outcome outcome;
  std::unordered_map<std::uint64_t, OpenEdge> still_open;
  for (const OpenEdge& open : open_edges(copy.complex, last_reach(copy.setting.rules())))
    still_open.emplace(open.edge.value, open);
  const Finished finished(copy.complex);
  copy.complex.segments().for_each([&](const Segment& s) {
    if (!s.polygon) return;
    ++outcome.polygons;
    add_open_edges(s, outcome.left);
  });
  std::stable_sort(outcome.left.begin(), outcome.left.end(),
                   [](const auto& a, const auto& b) { return a.segment < b.segment; });
  outcome.open_edges = copy.complex.edges().size() - 2 * copy.complex.edges().pair_count();

  e.complex.segments().for_each([&](const Segment& s) {
    if (!s.polygon) return;
    const SegmentId now = copy.complex.find(s.id) ? s.id : copy.successors.of(s.id);
    for_each_edge(s.polygon->perimeter, [&](Slot slot) {
      const auto& node = s.polygon->perimeter.node(slot);
      if (node.shared) return;
      std::optional<EdgeId> stands_for = node.edge;
      if (!copy.complex.edges().find(node.edge)) {
        const Piece piece = piece_of(*s.polygon, slot);
        stands_for = finished.nearest((piece.a + piece.b) / 2, now);
      }
      Outcome::Edge edge{s.id, node.edge, !stands_for || copy.complex.edges().shared(*stands_for), {}, {}};
      if (!edge.closes)
        if (const auto open = still_open.find(stands_for->value); open != still_open.end())
          edge.refusal = open->second.refusal, edge.other = open->second.other;
      outcome.edges.push_back(edge);
    });
  });
  std::sort(outcome.edges.begin(), outcome.edges.end(), [](const auto& a, const auto& b) {
    return std::pair(a.segment, a.edge) < std::pair(b.segment, b.edge);
  });
  return outcome;
}

}  // namespace limpet::model::internal
