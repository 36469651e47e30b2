// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <set>

#include "judged_scan.hpp"

namespace limpet::model::testing {

/// The neighbour relation as one knows it who reads the changes only, held against the model after every
/// call.
class NeighbourLedger {
 public:
  /// Reads the changes of one call. Returns what is wrong with them, empty if nothing.
  std::string read(const std::vector<Change>& changes, const ModelRecord& now) {
    wrong_.clear();
    for (const Change& c : changes) read(c);
    require(partners_ == partners_of(now), "the changes do not lead to the shared edges there are");
    return wrong_;
  }

  long shared() const { return shared_; }
  long unshared() const { return unshared_; }
  long corners() const { return corners_; }

 private:
  void require(bool good, const std::string& what) {
    if (!good) wrong_ += what + "\n";
  }

  void read(const Change& c) {
    switch (c.kind) {
      case Change::Kind::became_polygon:
        polygons_.insert(c.result.value);
        break;
      case Change::Kind::merged: {
        const bool polygon = polygons_.erase(c.first.value) + polygons_.erase(c.second.value) > 0;
        if (polygon) polygons_.insert(c.result.value);
        break;
      }
      case Change::Kind::deleted:
        polygons_.erase(c.first.value);
        break;
      case Change::Kind::edges_removed:
        for (const auto edge : c.edges) dropped_.insert(edge.value);
        break;
      case Change::Kind::shared:
        ++shared_;
        read_pair(c, true);
        break;
      case Change::Kind::unshared:
        ++unshared_;
        read_pair(c, false);
        break;
      case Change::Kind::corner_formed:
        ++corners_;
        require(c.edges.size() >= 3, "a corner of fewer than three edges");
        for (const auto edge : c.edges)
          require(partners_.count(edge.value) == 1, name(edge.value) + " is at a corner and not shared");
        break;
      default:
        break;
    }
  }

  void read_pair(const Change& c, bool shared) {
    const std::string what = shared ? " shared" : " unshared";
    if (c.edges.size() != 2) return require(false, "not a pair" + what);
    const std::uint64_t a = c.edges[0].value, b = c.edges[1].value;
    require(c.first != c.second && polygons_.count(c.first.value) && polygons_.count(c.second.value),
            name(a) + what + " by segments " + std::to_string(c.first.value) + " and " +
                std::to_string(c.second.value) + ", which are no two polygons");
    if (shared) {
      require(!partners_.count(a) && !partners_.count(b) && a != b, name(a) + " shared twice");
      require(!dropped_.count(a) && !dropped_.count(b), name(a) + " is gone and shared");
      partners_[a] = b, partners_[b] = a;
      return;
    }
    const auto known = partners_.find(a);
    require(known != partners_.end() && known->second == b, name(a) + " is no partner to be unshared");
    partners_.erase(a), partners_.erase(b);
  }

  static std::string name(std::uint64_t edge) { return "edge " + std::to_string(edge); }

  std::string wrong_;
  std::set<std::uint64_t> polygons_, dropped_;
  std::map<std::uint64_t, std::uint64_t> partners_;
  long shared_ = 0, unshared_ = 0, corners_ = 0;
};

}  // namespace limpet::model::testing
