// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/io/lifted.hpp>
#include <limpet/io/polygon_mesh.hpp>
#include <limpet/io/welded.hpp>
#include <optional>
#include <set>

#include "files.hpp"
#include "models.hpp"

namespace limpet::io::testing {
namespace {

using Eigen::Vector3d;

constexpr double kReach = 0.0625;  // λ of ModelMaker's models

/// Plate 6 × 2 × 0.25 with three square bores: 18 polygons, 48 shared edges, 32 corners.
model::ModelRecord bored_plate() {
  ModelMaker maker;
  std::vector<Loop> outlines{rectangle(0, 0, 6, 2, 0)};
  for (const double x : {0.5, 2.5, 4.5}) outlines.push_back(reversed(rectangle(x, 0.5, x + 1, 1.5, 0)));
  std::vector<Loop> under, above;
  for (const Loop& loop : outlines) {
    under.push_back(reversed(loop));
    above.push_back(raised(loop, 0.25));
    add_sides(maker, loop, 0.25);
  }
  maker.face(under).face(above);
  return maker.make();
}

/// Vertices less edges plus faces of a mesh in which every edge has two faces, in opposite directions, and
/// every vertex one fan of them; nothing of any other.
std::optional<int> characteristic(const PolygonMesh& mesh) {
  std::map<std::pair<int, int>, int> face_at;  // by directed edge
  std::map<int, std::set<int>> faces_at;       // by vertex
  for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f) {
    const auto& loop = mesh.faces[f].vertices;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      faces_at[loop[i]].insert(f);
      if (!face_at.insert({{loop[i], loop[(i + 1) % loop.size()]}, f}).second) return std::nullopt;
    }
  }
  std::map<int, std::map<int, int>> next_at;  // around a vertex: the face across the edge that leaves it
  for (const auto& [edge, face] : face_at) {
    const auto twin = face_at.find({edge.second, edge.first});
    if (twin == face_at.end()) return std::nullopt;
    next_at[edge.first][face] = twin->second;
  }
  for (const auto& [vertex, faces] : faces_at) {
    std::set<int> fan;
    for (int f = *faces.begin(); fan.insert(f).second;) f = next_at[vertex].at(f);
    if (fan != faces) return std::nullopt;
  }
  return static_cast<int>(faces_at.size()) - static_cast<int>(face_at.size() / 2) +
         static_cast<int>(mesh.faces.size());
}

std::set<std::array<double, 3>> places(const std::vector<Vector3d>& vertices) {
  std::set<std::array<double, 3>> result;
  for (const auto& v : vertices) result.insert({v.x(), v.y(), v.z()});
  return result;
}

struct Known {
  model::ModelRecord record;
  std::size_t corners;
  int characteristic;
};

TEST(Welded, ClosedModelsAreClosedManifolds) {
  for (const auto& [record, corners, expected] :
       {Known{cube(), 8, 2}, Known{l_block(), 12, 2}, Known{plate(), 24, -2}, Known{bored_plate(), 32, -4}}) {
    const auto lifted = lift(record);
    for (const bool triangles_only : {false, true}) {
      const PolygonMesh mesh = make_mesh(lifted, kReach, triangles_only);
      EXPECT_EQ(characteristic(mesh), expected) << corners << " corners";
      EXPECT_EQ(mesh.vertices.size(), corners);
      EXPECT_EQ(places(mesh.vertices).size(), corners) << "no vertex twice";
    }
    const WeldedVertices welded = weld(lifted, kReach);
    EXPECT_EQ(welded.at.size(), corners);
    EXPECT_EQ(welded.corners, static_cast<std::int64_t>(corners));
    EXPECT_LT(welded.corner_distance, 1e-12);
  }
}

TEST(Welded, EveryLiftedVertexIsWhereItsWeldedOneIs) {
  for (const auto& record : {cube({5, -3, 1}), l_block(), bored_plate()}) {
    const auto lifted = lift(record);
    const WeldedVertices welded = weld(lifted, kReach);
    std::size_t v = 0;
    for (const auto& polygon : lifted)
      for (const auto& cycle : polygon.cycles)
        for (const auto& vertex : cycle) {
          ASSERT_LT(v, welded.welded.size());
          const auto at = static_cast<std::size_t>(welded.welded[v++]);
          ASSERT_LT(at, welded.at.size());
          EXPECT_LT((welded.at[at] - vertex.at).norm(), 1e-12);
        }
    EXPECT_EQ(v, welded.welded.size());
  }
}

TEST(Welded, VerticesAreOneWhereEdgesAreShared) {
  // Without its top a cube has four vertices of two polygons each at its rim, which are no corners.
  const WeldedVertices open = weld(lift(open_cube()), kReach);
  EXPECT_EQ(open.at.size(), 8u);
  EXPECT_EQ(open.corners, 4);
  // Polygons that share nothing have no vertex in common, wherever they are.
  model::ModelRecord loose = cube();
  for (auto& s : loose.polygon_segments)
    for (auto& v : s.cycles[0]) v.partner = 0;
  const WeldedVertices apart = weld(lift(loose), kReach);
  EXPECT_EQ(apart.at.size(), 24u);
  EXPECT_EQ(apart.corners, 0);
  for (std::size_t v = 0; v < 24; ++v) EXPECT_EQ(apart.welded[v], static_cast<int>(v));
}

TEST(Welded, TwoCubesThatTouchStayTwo) {
  ModelMaker maker;
  add_prism(maker, rectangle(0, 0, 1, 1, 0), 1);
  model::ModelRecord both = maker.make();
  const model::ModelRecord other = cube({1, 1, 0});
  const std::uint64_t shift = both.next_edge;
  for (auto s : other.polygon_segments) {
    s.id += both.next_segment;
    for (auto& v : s.cycles[0]) v.edge += shift, v.partner += shift;
    both.polygon_segments.push_back(s);
  }
  const WeldedVertices welded = weld(lift(both), kReach);
  EXPECT_EQ(welded.at.size(), 16u) << "by identity, not by nearness";
  EXPECT_EQ(welded.corners, 16);
}

TEST(Welded, APairTooFarApartStaysTwo) {
  model::ModelRecord record = cube();
  record.polygon_segments[0].chart_origin += Vector3d(0, 0, -0.5);
  const WeldedVertices welded = weld(lift(record), kReach);
  EXPECT_EQ(welded.at.size(), 12u);
  EXPECT_EQ(welded.corners, 4);
}

// --- Corners whose planes do not meet -----------------------------------------------------------------

/// Four triangles around an apex near (0, 0, 1) that share their sloping edges; each plane is off by its
/// own amount.
std::vector<LiftedPolygon> roof(const std::array<double, 4>& off) {
  const Vector3d apex{0, 0, 1};
  const std::array<Vector3d, 4> base{Vector3d{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
  std::vector<LiftedPolygon> polygons;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3d &a = base[i], &b = base[(i + 1) % 4];
    LiftedPolygon& p = polygons.emplace_back();
    p.id = i + 1;
    p.normal = (b - a).cross(apex - a).normalized();
    const Vector3d up = off[i] * p.normal;
    // Edges 10i: a to b (open), 10i + 1: b to the apex, 10i + 2: the apex to a.
    const std::uint64_t first = 10 * (i + 1), before = 10 * ((i + 3) % 4 + 1), after = 10 * ((i + 1) % 4 + 1);
    p.cycles = {
        {{a + up, {}, first, 0}, {b + up, {}, first + 1, after + 2}, {apex + up, {}, first + 2, before + 1}}};
  }
  return polygons;
}

/// The sum of the squared distances from the planes of the roof.
double spread(const std::vector<LiftedPolygon>& polygons, const Vector3d& p) {
  double sum = 0;
  for (const auto& polygon : polygons) {
    const double d = polygon.normal.dot(p - polygon.cycles[0][0].at);
    sum += d * d;
  }
  return sum;
}

TEST(WeldedCorner, LiesNearestToAllItsPlanes) {
  for (const std::array<double, 4> off : {std::array<double, 4>{0, 0, 0, 0},
                                          {0.01, 0, 0, 0},
                                          {0.01, -0.01, 0.01, -0.01},
                                          {0.004, 0.001, -0.01, 0.007}}) {
    const auto polygons = roof(off);
    const WeldedVertices welded = weld(polygons, kReach);
    ASSERT_EQ(welded.corners, 1);
    ASSERT_EQ(welded.at.size(), 5u);
    const auto apex = static_cast<std::size_t>(welded.welded[2]);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(welded.welded[3 * i + 2], static_cast<int>(apex));
    const Vector3d at = welded.at[apex];
    // Normal equations, solved apart.
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Vector3d b = Vector3d::Zero();
    for (const auto& p : polygons) {
      a += p.normal * p.normal.transpose();
      b += p.normal * p.normal.dot(p.cycles[0][0].at);
    }
    EXPECT_LT((at - a.inverse() * b).norm(), 1e-12);
    double farthest = 0;
    for (const auto& p : polygons)
      farthest = std::max(farthest, std::abs(p.normal.dot(at - p.cycles[0][0].at)));
    EXPECT_NEAR(welded.corner_distance, farthest, 1e-12);
    // No place about it is nearer.
    const double here = spread(polygons, at);
    for (int k = 0; k < 3; ++k)
      for (const double d : {-1e-3, 1e-3}) EXPECT_GT(spread(polygons, at + d * Vector3d::Unit(k)), here);
  }
}

TEST(WeldedCorner, OfTwoPlanesIsOnBoth) {
  // The ends of an open cube's upright edges, one wall pushed out.
  model::ModelRecord record = open_cube();
  record.polygon_segments[1].chart_origin += Vector3d(0, -1.0 / 64, 0);
  const auto lifted = lift(record);
  const WeldedVertices welded = weld(lifted, kReach);
  std::size_t v = 0;
  for (const auto& polygon : lifted)
    for (const auto& vertex : polygon.cycles[0]) {
      const Vector3d& at = welded.at[static_cast<std::size_t>(welded.welded[v++])];
      EXPECT_NEAR(polygon.normal.dot(at - vertex.at), 0, 1e-12);
    }
}

}  // namespace
}  // namespace limpet::io::testing
