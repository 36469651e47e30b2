// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <map>
#include <set>
#include <string>

#include <limpet/geometry/chart.hpp>
#include <limpet/model/model.hpp>
#include <limpet/model/view.hpp>

namespace limpet::model::testing {

/// A copy of a model's segments and edges that is kept by applying changes, and asks the model for nothing
/// but where the edges are that the changes name (changes.hpp).
class Mirror {
 public:
  void apply(std::span<const Change> changes, const View& view) {
    std::set<geometry::EdgeId> named;
    for (const Change& c : changes) apply(c, named);
    for (const geometry::EdgeId id : named) look(id, view);
  }

  /// What is not as in the record; empty if nothing.
  std::string difference(const ModelRecord& record) const {
    std::string wrong;
    std::set<std::uint64_t> points, polygons;
    for (const auto& s : record.point_segments) points.insert(s.id);
    for (const auto& s : record.polygon_segments) polygons.insert(s.id);
    if (points != ids_of(points_) || polygons != ids_of(polygons_)) wrong += "other segments\n";
    std::size_t edges = 0;
    for (const auto& s : record.polygon_segments)
      for (const auto& cycle : s.cycles) {
        edges += cycle.size();
        for (std::size_t i = 0; i < cycle.size(); ++i)
          wrong += difference(s, cycle[i], cycle[(i + 1) % cycle.size()],
                              cycle[(i + cycle.size() - 1) % cycle.size()], record.grid_step);
      }
    if (edges != edges_.size())
      wrong += std::to_string(edges_.size()) + " edges instead of " + std::to_string(edges);
    return wrong;
  }

 private:
  struct Edge {
    SegmentId segment;
    geometry::EdgeId next, previous, partner;
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
  };

  void apply(const Change& c, std::set<geometry::EdgeId>& named) {
    switch (c.kind) {
      case Change::Kind::created:
        points_.insert(c.result);
        break;
      case Change::Kind::became_polygon:
        points_.erase(c.result), polygons_.insert(c.result);
        break;
      case Change::Kind::merged: {
        const bool polygon = polygons_.count(c.first) || polygons_.count(c.second);
        forget(c.first), forget(c.second);
        (polygon ? polygons_ : points_).insert(c.result);
        for (auto& [id, edge] : edges_)
          if (edge.segment == c.first || edge.segment == c.second) edge.segment = c.result;
        break;
      }
      case Change::Kind::deleted:
        forget(c.first);
        std::erase_if(edges_, [&](const auto& entry) { return entry.second.segment == c.first; });
        break;
      case Change::Kind::edges_removed:
        for (const auto id : c.edges) edges_.erase(id), named.erase(id);
        break;
      case Change::Kind::edges_created:
      case Change::Kind::edges_moved:
        for (const auto id : c.edges)
          edges_.try_emplace(id).first->second.segment = c.result, named.insert(id);
        break;
      case Change::Kind::shared:
        edges_[c.edges[0]].partner = c.edges[1], edges_[c.edges[1]].partner = c.edges[0];
        break;
      case Change::Kind::unshared:
        for (const auto id : c.edges)
          if (const auto edge = edges_.find(id); edge != edges_.end()) edge->second.partner = {};
        break;
      case Change::Kind::corner_formed:
        break;
    }
  }

  void forget(SegmentId id) { points_.erase(id), polygons_.erase(id); }

  /// Where the edge is now, and what that says of those beside it.
  void look(geometry::EdgeId id, const View& view) {
    const auto now = view.edge(id);
    if (!now) {
      edges_.erase(id);
      return;
    }
    Edge& edge = edges_[id];
    edge.segment = now->segment, edge.from = now->from, edge.to = now->to;
    edge.next = now->next, edge.previous = now->previous;
    if (const auto next = edges_.find(now->next); next != edges_.end()) next->second.previous = id;
    if (const auto previous = edges_.find(now->previous); previous != edges_.end())
      previous->second.next = id;
  }

  std::string difference(const PolygonSegmentRecord& s, const VertexRecord& v, const VertexRecord& next,
                         const VertexRecord& previous, double step) const {
    const std::string name = "edge " + std::to_string(v.edge);
    const auto entry = edges_.find({v.edge});
    if (entry == edges_.end()) return name + " is not known\n";
    const Edge& edge = entry->second;
    const geometry::Chart chart(s.chart_origin, s.chart_u, s.chart_v, s.chart_normal, step);
    const auto at = [&](const VertexRecord& p) -> Eigen::Vector3d {
      return chart.at({p.x, p.y}, s.height[0] + s.height[1] * p.x + s.height[2] * p.y);
    };
    if (edge.segment.value != s.id) return name + " is on another segment\n";
    if (edge.partner.value != v.partner) return name + " has another partner\n";
    if (edge.next.value != next.edge || edge.previous.value != previous.edge)
      return name + " has others beside it\n";
    if (edge.from != at(v) || edge.to != at(next)) return name + " is elsewhere\n";
    return {};
  }

  static std::set<std::uint64_t> ids_of(const std::set<SegmentId>& segments) {
    std::set<std::uint64_t> ids;
    for (const SegmentId id : segments) ids.insert(id.value);
    return ids;
  }

  std::set<SegmentId> points_, polygons_;
  std::map<geometry::EdgeId, Edge> edges_;
};

}  // namespace limpet::model::testing
