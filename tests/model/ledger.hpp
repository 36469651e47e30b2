// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <map>
#include <set>

#include "streams.hpp"

namespace limpet::model::testing {

/// What one knows of a model who reads its changes only, held against the model after every call.
class Ledger {
 public:
  /// Reads the changes of one call. Returns what is wrong with them, empty if nothing.
  std::string read(const std::vector<Change>& changes, const ModelRecord& now) {
    wrong_.clear();
    removed_.clear();
    gone_.clear();
    for (const Change& c : changes) read(c);
    compare_segments(now);
    compare_edges(now);
    return wrong_;
  }

 private:
  using Ids = std::set<std::uint64_t>;

  void require(bool good, const std::string& what) {
    if (!good) wrong_ += what + "\n";
  }

  void read(const Change& c) {
    const std::uint64_t first = c.first.value, second = c.second.value, result = c.result.value;
    switch (c.kind) {
      case Change::Kind::created:
        require_new(result);
        live_.insert(result);
        break;
      case Change::Kind::became_polygon:
        require(live_.count(result) && !polygons_.count(result), name(result) + " cannot become a polygon");
        polygons_.insert(result);
        break;
      case Change::Kind::merged: {
        require(live_.count(first) && live_.count(second) && first != second,
                name(first) + " and " + name(second) + " cannot merge");
        const bool polygon = polygons_.count(first) || polygons_.count(second);
        if (result != first && result != second) require_new(result);
        for (const auto id : {first, second}) {
          live_.erase(id), polygons_.erase(id);
          if (id != result) gone_.insert(id);
        }
        live_.insert(result);
        if (polygon) polygons_.insert(result);
        break;
      }
      case Change::Kind::deleted:
        require(live_.count(first) == 1, name(first) + " deleted twice");
        live_.erase(first), polygons_.erase(first), gone_.insert(first);
        break;
      case Change::Kind::edges_removed:
        require(polygons_.count(result) == 1, name(result) + " has no edges to lose");
        for (const auto edge : c.edges)
          require(removed_.insert(edge.value).second,
                  "edge " + std::to_string(edge.value) + " removed twice");
        break;
      default:
        break;
    }
  }

  void require_new(std::uint64_t id) {
    require(id > last_, name(id) + " used again");
    last_ = std::max(last_, id);
  }

  void compare_segments(const ModelRecord& now) {
    Ids live, polygons;
    for (const auto& s : now.point_segments) live.insert(s.id);
    for (const auto& s : now.polygon_segments) live.insert(s.id), polygons.insert(s.id);
    require(live == live_, "the changes do not lead to the segments there are");
    require(polygons == polygons_, "the changes do not lead to the polygons there are");
    require(last_ < now.next_segment, "the next identity has been used");
  }

  /// Edges that are gone were reported, or their segment was; new ones have new identities.
  void compare_edges(const ModelRecord& now) {
    std::map<std::uint64_t, std::uint64_t> edges;
    for (const auto& s : now.polygon_segments)
      for (const auto& cycle : s.cycles)
        for (const auto& v : cycle) {
          edges[v.edge] = s.id;
          require(!removed_.count(v.edge), "edge " + std::to_string(v.edge) + " was reported removed");
          require(edges_.count(v.edge) || v.edge >= next_edge_,
                  "edge " + std::to_string(v.edge) + " is back");
        }
    for (const auto& [edge, segment] : edges_)
      require(edges.count(edge) || removed_.count(edge) || gone_.count(segment),
              "edge " + std::to_string(edge) + " of " + name(segment) + " vanished");
    edges_ = std::move(edges);
    next_edge_ = now.next_edge;
  }

  static std::string name(std::uint64_t id) { return "segment " + std::to_string(id); }

  std::string wrong_;
  Ids live_, polygons_;
  Ids removed_, gone_;  ///< in this call: edges reported removed, segments merged or deleted
  std::uint64_t last_ = 0, next_edge_ = 1;
  std::map<std::uint64_t, std::uint64_t> edges_;  ///< with their segments
};

}  // namespace limpet::model::testing
