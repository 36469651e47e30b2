// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/topology.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

namespace limpet::evaluation {
namespace {

/// A side of a face as the mesh has it.
struct HalfEdge {
  int from, to, beyond;
};

/// The half-edges at the border of each face, as loops.
std::vector<std::vector<HalfEdge>> loops_of(std::multimap<int, HalfEdge> from) {
  std::vector<std::vector<HalfEdge>> loops;
  while (!from.empty()) {
    auto& loop = loops.emplace_back();
    for (auto next = from.begin(); next != from.end(); next = from.find(loop.back().to)) {
      loop.push_back(next->second);
      from.erase(next);
    }
  }
  return loops;
}

bool straight(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d p = (b - a).normalized(), q = (c - b).normalized();
  return p.dot(q) > 0 && p.cross(q).norm() < 1e-4;
}

SideLoop without_flat_vertices(const simulation::Mesh& mesh, const std::vector<HalfEdge>& loop) {
  SideLoop result;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const HalfEdge &before = loop[(i + n - 1) % n], &after = loop[i];
    if (before.beyond == after.beyond &&
        straight(mesh.vertices[before.from], mesh.vertices[before.to], mesh.vertices[after.to]))
      continue;
    result.begins.push_back(mesh.vertices[after.from]);
    result.beyond.push_back(after.beyond);
  }
  return result;
}

/// An open side is bounded by as many edges as it takes: they count as one.
SideLoop with_open_sides_joined(const SideLoop& loop) {
  const std::size_t n = loop.beyond.size();
  std::size_t first = 0;
  while (first < n && loop.beyond[first] == -1) ++first;
  if (first == n) return {{loop.begins.front()}, {-1}};
  SideLoop result;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = (first + i) % n;
    if (loop.beyond[k] == -1 && result.beyond.back() == -1) continue;
    result.begins.push_back(loop.begins[k]);
    result.beyond.push_back(loop.beyond[k]);
  }
  return result;
}

/// The turn k for which loop `a`, begun k sides later, has the neighbours of `b`; of several the one with the
/// least distance between vertices. −1: none.
struct Alignment {
  bool found = false;
  double distance = 0;
};
Alignment align(const SideLoop& truth, const SideLoop& model) {
  Alignment best;
  const std::size_t n = truth.beyond.size();
  if (model.beyond.size() != n) return best;
  for (std::size_t k = 0; k < n; ++k) {
    double distance = 0;
    bool same = true;
    for (std::size_t i = 0; i < n && same; ++i) {
      same = truth.beyond[i] == model.beyond[(i + k) % n];
      // Where an open side ends there is no corner that planes would meet in.
      if (truth.beyond[i] != -1 && truth.beyond[(i + n - 1) % n] != -1)
        distance = std::max(distance, (truth.begins[i] - model.begins[(i + k) % n]).norm());
    }
    if (same && (!best.found || distance < best.distance)) best = {true, distance};
  }
  return best;
}

/// Do the loops of a face and its polygon correspond one to one? The distance is the largest.
Alignment align(const std::vector<SideLoop>& truth, const std::vector<SideLoop>& model) {
  Alignment all{truth.size() == model.size(), 0};
  std::vector<char> used(model.size());
  for (const SideLoop& loop : truth) {
    Alignment best;
    std::size_t which = 0;
    for (std::size_t j = 0; j < model.size(); ++j) {
      if (used[j]) continue;
      const Alignment a = align(loop, model[j]);
      if (a.found && (!best.found || a.distance < best.distance)) best = a, which = j;
    }
    if (!best.found) return {};
    used[which] = 1;
    all.distance = std::max(all.distance, best.distance);
  }
  return all;
}

std::string described(const SideLoop& loop) {
  std::string text = "(";
  for (const int beyond : loop.beyond) text += (text.size() > 1 ? " " : "") + std::to_string(beyond);
  return text + ")";
}

}  // namespace

std::vector<std::vector<SideLoop>> side_loops(const simulation::Mesh& mesh) {
  std::map<std::pair<int, int>, int> face_at;  // by directed edge
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      face_at[{mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]}] = mesh.face_of_triangle[t];
  std::vector<std::multimap<int, HalfEdge>> borders(mesh.face_count);
  for (const auto& [edge, face] : face_at) {
    const auto twin = face_at.find({edge.second, edge.first});
    const int beyond = twin == face_at.end() ? -1 : twin->second;
    if (beyond != face) borders[face].insert({edge.first, {edge.first, edge.second, beyond}});
  }
  std::vector<std::vector<SideLoop>> result(borders.size());
  for (std::size_t f = 0; f < borders.size(); ++f)
    for (const auto& loop : loops_of(borders[f])) result[f].push_back(without_flat_vertices(mesh, loop));
  return result;
}

std::vector<std::vector<SideLoop>> side_loops(const model::ModelRecord& record) {
  std::map<std::uint64_t, int> polygon_of;
  for (std::size_t s = 0; s < record.polygon_segments.size(); ++s)
    for (const auto& cycle : record.polygon_segments[s].cycles)
      for (const auto& v : cycle) polygon_of[v.edge] = static_cast<int>(s);
  const auto lifted = planar_faces(record);
  std::vector<std::vector<SideLoop>> result;
  for (std::size_t s = 0; s < record.polygon_segments.size(); ++s) {
    auto& loops = result.emplace_back();
    for (std::size_t c = 0; c < record.polygon_segments[s].cycles.size(); ++c) {
      SideLoop& loop = loops.emplace_back();
      loop.begins = lifted[s].cycles[c];
      for (const auto& v : record.polygon_segments[s].cycles[c])
        loop.beyond.push_back(v.partner == 0 ? -1 : polygon_of.at(v.partner));
    }
  }
  return result;
}

TopologyReport judge_topology(const model::ModelRecord& record, const simulation::Mesh& truth,
                              const FacesReport& faces) {
  TopologyReport report;
  auto of_truth = side_loops(truth);
  for (auto& loops : of_truth)
    for (SideLoop& loop : loops) loop = with_open_sides_joined(loop);
  auto of_model = side_loops(record);
  std::vector<int> face_of(of_model.size());  // of each polygon; one below −1, its own, if of none
  for (std::size_t p = 0; p < face_of.size(); ++p) face_of[p] = -2 - static_cast<int>(p);
  std::vector<int> part_of = face_of;  // the same, but fragments of a face are parts of it
  for (const auto& p : faces.polygons) {
    if (!p.extra) face_of[static_cast<std::size_t>(p.polygon)] = p.face;
    if (p.face >= 0) part_of[static_cast<std::size_t>(p.polygon)] = p.face;
  }
  std::set<std::pair<int, int>> shared;
  for (std::size_t p = 0; p < of_model.size(); ++p)
    for (const SideLoop& loop : of_model[p])
      for (const int beyond : loop.beyond)
        if (beyond >= 0) shared.insert(std::minmax(part_of[p], part_of[static_cast<std::size_t>(beyond)]));
  report.closed = !of_model.empty();
  for (auto& loops : of_model)
    for (SideLoop& loop : loops)
      for (int& beyond : loop.beyond) {
        report.closed &= beyond >= 0;
        if (beyond >= 0) beyond = face_of[static_cast<std::size_t>(beyond)];
      }
  for (auto& loops : of_model)
    for (SideLoop& loop : loops) loop = with_open_sides_joined(loop);
  std::vector<const std::vector<SideLoop>*> polygon_of(of_truth.size(), nullptr);
  for (std::size_t p = 0; p < of_model.size(); ++p)
    if (face_of[p] >= 0) polygon_of[static_cast<std::size_t>(face_of[p])] = &of_model[p];

  std::set<std::pair<int, int>> neighbours;
  for (std::size_t f = 0; f < of_truth.size(); ++f) {
    const int face = static_cast<int>(f);
    for (const SideLoop& loop : of_truth[f])
      for (const int beyond : loop.beyond)
        if (beyond > face) neighbours.insert({face, beyond});
    if (!polygon_of[f]) {
      report.faults.push_back("face " + std::to_string(f) + " has no polygon");
      continue;
    }
    const Alignment a = align(of_truth[f], *polygon_of[f]);
    report.faces += a.found;
    report.vertex_distance = std::max(report.vertex_distance, a.distance);
    if (a.found) continue;
    std::string fault = "face " + std::to_string(f) + " should have sides";
    for (const SideLoop& loop : of_truth[f]) fault += " " + described(loop);
    fault += ", has";
    for (const SideLoop& loop : *polygon_of[f]) fault += " " + described(loop);
    report.faults.push_back(std::move(fault));
  }
  report.true_shared = static_cast<int>(neighbours.size());
  for (const auto& pair : shared) (neighbours.count(pair) ? report.shared : report.false_shared) += 1;
  report.isomorphic = report.faces == static_cast<int>(of_truth.size()) && of_model.size() == of_truth.size();
  return report;
}

}  // namespace limpet::evaluation
