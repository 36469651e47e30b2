// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/audit/laws.hpp>

/// The laws in groups, one file for each. judge_finite() reports numbers that are not finite; the others
/// require finite numbers in what they are given, or skip what has others.
namespace limpet::audit::internal {

class Report {
 public:
  void add(const char* law, std::string where, std::string what) {
    violations_.push_back({law, std::move(where), std::move(what)});
  }
  std::vector<Violation> take() { return std::move(violations_); }

 private:
  std::vector<Violation> violations_;
};

inline std::string segment_name(const Segment& segment) { return "segment " + std::to_string(segment.id); }
inline std::string cycle_name(const Polygon& polygon, std::size_t cycle) {
  return segment_name(polygon) + " cycle " + std::to_string(cycle);
}
inline std::string vertex_name(const Polygon& polygon, std::size_t cycle, std::size_t vertex) {
  return cycle_name(polygon, cycle) + " vertex " + std::to_string(vertex);
}

// laws_header.cpp
void judge_finite(const Document&, Report&);
void judge_parameters(const Document&, Report&);
void judge_identities(const Document&, Report&);
void judge_counts(const Document&, Report&);
bool is_finite(const Segment&);
bool is_finite(const Polygon&);

// laws_fit.cpp
void judge_data(const Segment&, Report&);
void judge_point(const Segment&, double step, double resolution, Report&);
void judge_plane(const Polygon&, double step, double resolution, Report&);

// laws_grid.cpp
void judge_points_on_grid(const Segment&, Report&);
void judge_chart_on_grid(const Polygon&, double step, Report&);
/// `rounded`: are the vertices to be grid points?
void judge_vertices_on_grid(const Polygon&, bool rounded, Report&);

// laws_perimeter.cpp
void judge_perimeter(const Polygon&, Report&);

// laws_shared.cpp; polygons with numbers that are not finite are left out of the geometric laws
void judge_shared_edges(const Document&, Report&);

}  // namespace limpet::audit::internal
