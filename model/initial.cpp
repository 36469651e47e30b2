// Copyright the limpet authors. GPL-3.0-or-later.
//
// Initial model segments (thesis §4.3): faces known beforehand. They represent no sensor points, merge with
// nothing and are never modified, but they share edges and corners. Points on them are counted
// (Insertion::insert_one()).
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include <limpet/geometry/predicates.hpp>

#include "common_line_internal.hpp"
#include "initial_internal.hpp"
#include "sharing_internal.hpp"

namespace limpet::model::internal {
namespace {

/// Of a vertex in its chart, in grid steps: as the law `grid` says.
constexpr double kMostInChart = 0x1p40;

constexpr const char* kNotSimple = "is no simple polygon at this resolution";

/// Twice the area of a cycle, as a vector along its normal.
Eigen::Vector3d area_vector(const std::vector<Eigen::Vector3d>& cycle) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < cycle.size(); ++i)
    sum += (cycle[i] - cycle[0]).cross(cycle[i + 1] - cycle[0]);
  return sum;
}

[[noreturn]] void refuse(std::size_t face, const char* what) {
  throw Refused("initial face " + std::to_string(face) + " " + what);
}

void require_near(std::size_t number, const InitialFace& face, double step) {
  const double farthest = static_cast<double>(kMaxSteps) * step;
  for (const auto& cycle : face.cycles)
    for (const Eigen::Vector3d& v : cycle) {
      if (!v.allFinite()) refuse(number, "has a vertex that is not finite");
      if (v.cwiseAbs().maxCoeff() > farthest)
        refuse(number, "has a vertex beyond 2^48 grid steps: too far away for this resolution");
    }
}

/// In the chart, on the grid.
std::vector<std::vector<geometry::NewVertex>> vertices_of(std::size_t number, const InitialFace& face,
                                                          const geometry::Chart& chart) {
  std::vector<std::vector<geometry::NewVertex>> cycles;
  for (const auto& cycle : face.cycles) {
    auto& vertices = cycles.emplace_back();
    for (const Eigen::Vector3d& v : cycle) {
      const geometry::Point2 at = geometry::round_to_grid(chart.project(v));
      if (!std::isfinite(at.x) || !std::isfinite(at.y)) refuse(number, kNotSimple);
      if (std::max(std::abs(at.x), std::abs(at.y)) > kMostInChart)
        refuse(number, "is wider than 2^40 grid steps: too large for this resolution");
      vertices.push_back({at});
    }
  }
  return cycles;
}

const Segment& add_face(Complex& complex, std::size_t number, const InitialFace& face) {
  if (face.cycles.empty() || face.cycles.front().size() < 3) refuse(number, "has fewer than three vertices");
  require_near(number, face, complex.setting().step);
  const auto& outer = face.cycles.front();
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(), normal = area_vector(outer);
  for (const auto& v : outer) centre += v / static_cast<double>(outer.size());
  const double length = std::sqrt(normal.dot(normal));
  if (!(length > 0) || !std::isfinite(length)) refuse(number, "has no area");
  normal /= length;

  auto polygon = std::make_unique<PolygonPart>();
  PolygonPart& part = *polygon;
  part.chart = geometry::Chart({centre, normal}, outer[1] - outer[0], complex.setting().step);
  part.published = geometry::Lift(part.chart, {centre, normal});
  part.outward = normal;
  part.initial = {centre, normal};
  auto perimeter = geometry::Polygon::from_cycles(vertices_of(number, face, part.chart), complex.edge_ids());
  if (!perimeter) refuse(number, kNotSimple);
  part.perimeter = std::move(*perimeter);
  Fit fit;
  fit.centroid = centre, fit.normal = normal;
  return complex.create_initial(fit, std::move(polygon));
}

using Place = std::array<double, 3>;

/// The edges of faces, by the vertices that they lead from and to.
class CommonEdges {
 public:
  explicit CommonEdges(Complex& complex) : complex_(complex) {}

  void add(const InitialFace& face, const Segment& s) {
    const PolygonPart& part = *s.polygon;
    std::map<std::pair<double, double>, Place> vertices;  // by what they are rounded to
    for (const auto& cycle : face.cycles)
      for (const Eigen::Vector3d& v : cycle) vertices[rounded(part, v)] = {v.x(), v.y(), v.z()};
    for_each_edge(part.perimeter, [&](geometry::Slot slot) {
      const auto &from = part.perimeter.node(slot), &to = part.perimeter.node(part.perimeter.next(slot));
      const auto begin = vertices.find({from.at.x, from.at.y}), end = vertices.find({to.at.x, to.at.y});
      if (begin != vertices.end() && end != vertices.end())
        edges_[{begin->second, end->second}].push_back({s.slot, slot, from.edge});
    });
  }

  void share() {
    for (const auto& [ends, edges] : edges_) {
      const auto back = edges_.find({ends.second, ends.first});
      if (ends.second < ends.first || back == edges_.end()) continue;
      if (edges.size() == 1 && back->second.size() == 1) share(edges.front(), back->second.front());
    }
  }

 private:
  static constexpr double kSteps = 1.5;  ///< that an end may be off the other plane

  struct Edge {
    std::uint32_t segment;
    geometry::Slot slot;
    geometry::EdgeId id;
  };

  static std::pair<double, double> rounded(const PolygonPart& part, const Eigen::Vector3d& v) {
    const geometry::Point2 at = geometry::round_to_grid(part.chart.project(v));
    return {at.x, at.y};
  }

  /// Do both ends of the edge lie in this plane, to the rounding?
  bool lies_in(const Edge& edge, const geometry::Plane& plane) const {
    const PolygonPart& part = *complex_.at(edge.segment).polygon;
    const auto is_in = [&](geometry::Slot vertex) {
      return std::abs(plane.height_of(part.position(vertex))) < kSteps * complex_.setting().step;
    };
    return is_in(edge.slot) && is_in(part.perimeter.next(edge.slot));
  }

  double length_along(const CommonLine& line, const Edge& edge) const {
    const PolygonPart& part = *complex_.at(edge.segment).polygon;
    return line.along.dot(part.position(part.perimeter.next(edge.slot)) - part.position(edge.slot));
  }
  /// Of the copies, so that they overlap however they are rounded.
  double least_length(const CommonLine& line) const {
    return (kLeastSharedSteps + 4 * kSteps / line.sine) * complex_.setting().step;
  }

  void share(const Edge& a, const Edge& b) {
    if (a.segment == b.segment) return;
    const Segment &s = complex_.at(a.segment), &other = complex_.at(b.segment);
    const geometry::Plane plane = s.polygon->plane(), other_plane = other.polygon->plane();
    const auto line = common_line(plane, other_plane, plane.point);
    if (!line || !lies_in(a, other_plane) || !lies_in(b, plane)) return;
    const double along = length_along(*line, a), back = -length_along(*line, b);
    if (along * back <= 0 || std::min(std::abs(along), std::abs(back)) < least_length(*line)) return;
    const auto [first, is_first] = is_convex_.try_emplace(std::minmax(a.segment, b.segment), along > 0);
    if (!is_first && first->second != (along > 0)) return;
    complex_.share_open(a.id, b.id);
    if (!order_stays(complex_, a.id) && (is_disordered(complex_, s) || is_disordered(complex_, other)))
      complex_.unshare(a.id);
  }

  Complex& complex_;
  std::map<std::pair<Place, Place>, std::vector<Edge>> edges_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> is_convex_;  ///< of pairs that share, by slots
};

}  // namespace

void add_initial(Complex& complex, std::span<const InitialFace> faces) {
  CommonEdges common(complex);
  for (std::size_t i = 0; i < faces.size(); ++i) common.add(faces[i], add_face(complex, i, faces[i]));
  if (complex.setting().parameters.neighbours) common.share();
}

}  // namespace limpet::model::internal
