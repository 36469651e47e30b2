// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cstdint>
#include <limpet/drawing/boundary.hpp>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace limpet::drawing::testing {

/// Reads what Timeline writes, as docs/page_format.md has it: the other half of the format, for tests alone.
class TimelineReader {
 public:
  struct Point {
    Place at{};
    std::int64_t count = 0;
    friend bool operator==(const Point&, const Point&) = default;
  };
  struct Polygon {
    std::int64_t count = 0, residual = 0;
    std::array<std::int64_t, 4> plane{};
    bool initial = false;
    Boundary boundary;
  };
  using Reason = std::pair<std::uint64_t, std::uint64_t>;
  struct Intent {
    std::vector<Place> targets, aim, way, slice;
    std::uint64_t edge = 0, segment = 0;
  };

  TimelineReader(std::string bytes, bool with_intent) : bytes_(std::move(bytes)), with_intent_(with_intent) {}

  std::map<std::uint64_t, Point> points;
  std::map<std::uint64_t, Polygon> polygons;
  std::map<std::uint64_t, Reason> reasons;
  Intent intent;

  bool at_end() const { return at_ == bytes_.size(); }

  void step() {
    std::uint64_t id = 0;
    for (auto n = number(); n > 0; --n) {
      id += number();
      if (points.erase(id) + polygons.erase(id) != 1) throw std::runtime_error("gone, but it was not there");
    }
    id = 0;
    for (auto n = number(); n > 0; --n) {
      Point& point = points[id += number()];
      point.at = place(point.at);
      point.count = static_cast<std::int64_t>(number());
    }
    id = 0;
    for (auto n = number(); n > 0; --n) read_polygon(id += number());
    id = 0;
    for (auto n = number(); n > 0; --n) {
      const auto edge = id += number();
      const auto code = number(), other = number();
      reasons[edge] = {code, other};
      if (code == 17) reasons.erase(edge);
    }
    if (with_intent_) read_intent();
  }

 private:
  std::uint64_t number() {
    std::uint64_t value = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<std::uint8_t>(bytes_.at(at_++));
      value |= std::uint64_t{byte & 0x7fu} << shift;
      if (byte < 0x80) return value;
    }
  }
  static std::int64_t unfolded(std::uint64_t n) {
    return static_cast<std::int64_t>(n >> 1) ^ -static_cast<std::int64_t>(n & 1);
  }
  std::int64_t signed_number() { return unfolded(number()); }
  Place place(const Place& from) {
    Place result = from;
    for (std::int64_t& x : result) x += signed_number();
    return result;
  }
  std::vector<Place> places() {
    std::vector<Place> result;
    Place last{};
    for (auto n = number(); n > 0; --n) result.push_back(last = place(last));
    return result;
  }

  void read_polygon(std::uint64_t id) {
    points.erase(id);
    Polygon& polygon = polygons[id];
    const auto flags = number();
    if (flags & 1) {
      polygon.count = static_cast<std::int64_t>(number());
      polygon.residual = static_cast<std::int64_t>(number());
    }
    if (flags & 2)
      for (std::int64_t& x : polygon.plane) x = signed_number();
    if (flags & 4) polygon.boundary = boundary(polygon.boundary);
    polygon.initial = (flags & 8) != 0;
    for (const auto& cycle : polygon.boundary.cycles)
      for (const BoundaryVertex& vertex : cycle.vertices)
        if (vertex.partner != 0) reasons.erase(vertex.edge);
  }

  Boundary boundary(const Boundary& before) {
    std::vector<BoundaryVertex> old;
    for (const auto& cycle : before.cycles)
      old.insert(old.end(), cycle.vertices.begin(), cycle.vertices.end());
    Boundary result;
    BoundaryVertex last;
    std::int64_t expected = 0;
    for (auto cycles = number(); cycles > 0; --cycles) {
      auto& cycle = result.cycles.emplace_back();
      cycle.hole = number() != 0;
      for (auto runs = number(); runs > 0; --runs) {
        const auto head = number();
        if (head % 2 == 0) expected += signed_number();
        for (auto n = head / 2; n > 0; --n) {
          last = head % 2 ? told_in_full(last, old) : old.at(static_cast<std::size_t>(expected++));
          cycle.vertices.push_back(last);
        }
      }
    }
    return result;
  }

  BoundaryVertex told_in_full(const BoundaryVertex& last, const std::vector<BoundaryVertex>& old) {
    BoundaryVertex vertex;
    vertex.edge = last.edge + static_cast<std::uint64_t>(signed_number());
    const auto partner = number();
    if (partner > 0) vertex.partner = vertex.edge + static_cast<std::uint64_t>(unfolded(partner - 1));
    Place from = last.at;
    for (const BoundaryVertex& v : old)
      if (v.edge == vertex.edge) from = v.at;
    vertex.at = place(from);
    return vertex;
  }

  void read_intent() {
    intent = {};
    const auto flags = number();
    if (flags & 1) intent.targets = places();
    if (flags & 2) {
      intent.aim.push_back(place({}));
      intent.aim.push_back(place({}));
    }
    if (flags & 4) intent.way = places();
    if (flags & 8) intent.edge = number();
    if (flags & 16) intent.segment = number();
    if (flags & 32) intent.slice = places();
  }

  std::string bytes_;
  std::size_t at_ = 0;
  bool with_intent_;
};

}  // namespace limpet::drawing::testing
