// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <limpet/evaluation/topology.hpp>
#include <limpet/simulation/box_world.hpp>
#include <limpet/simulation/shapes.hpp>

#include "../io/models.hpp"

namespace limpet::evaluation {
namespace {

using Eigen::Vector3d;
using model::ModelRecord;
using model::VertexRecord;

/// A truth and its perfect model: polygon f is face f.
struct Pair {
  simulation::Mesh truth;
  ModelRecord model;
  FacesReport faces;

  explicit Pair(simulation::Mesh mesh) : truth(std::move(mesh)) {
    io::testing::ModelMaker maker;
    for (const simulation::Face& face : simulation::faces_of(truth)) maker.face(face.loops);
    model = maker.make();
    for (int f = 0; f < truth.face_count; ++f) add_polygon(f);
  }

  void add_polygon(int face, bool extra = false) {
    PolygonJudgement& p = faces.polygons.emplace_back();
    p.polygon = static_cast<int>(faces.polygons.size()) - 1;
    p.face = face;
    p.extra = extra;
  }

  TopologyReport judged() const { return judge_topology(model, truth, faces); }

  std::vector<VertexRecord>& cycle(int polygon, std::size_t c = 0) {
    return model.polygon_segments[static_cast<std::size_t>(polygon)].cycles[c];
  }
  VertexRecord& edge(std::uint64_t id) {
    for (auto& s : model.polygon_segments)
      for (auto& loop : s.cycles)
        for (auto& v : loop)
          if (v.edge == id) return v;
    throw std::logic_error("no such edge");
  }
  void unshare(VertexRecord& v) {
    edge(v.partner).partner = 0;
    v.partner = 0;
  }
  void share(VertexRecord& a, VertexRecord& b) { a.partner = b.edge, b.partner = a.edge; }
  int facing(const Vector3d& normal) const {
    const auto all = simulation::faces_of(truth);
    for (std::size_t f = 0; f < all.size(); ++f)
      if (all[f].normal.dot(normal) > 0.99) return static_cast<int>(f);
    return -1;
  }
};

/// A cube with a notch in the middle of one of its edges: its top and its front meet in two sides.
simulation::Mesh notched() {
  simulation::BoxWorld world;
  world.add({0, 0, 0}, {1, 1, 1});
  world.carve({0.375, 0, 0.5}, {0.625, 0.5, 1});
  return world.surface();
}

TEST(SideLoops, OfAMeshAreItsFacesSides) {
  const auto cube = side_loops(simulation::make_shape("cube"));
  ASSERT_EQ(cube.size(), 6u);
  for (std::size_t f = 0; f < 6; ++f) {
    ASSERT_EQ(cube[f].size(), 1u);
    EXPECT_EQ(cube[f][0].begins.size(), 4u);
    EXPECT_EQ(cube[f][0].beyond.size(), 4u);
    for (const int beyond : cube[f][0].beyond) EXPECT_TRUE(beyond >= 0 && beyond != static_cast<int>(f));
  }
  std::size_t loops = 0, sides = 0, open = 0;
  for (const auto& of_face : side_loops(simulation::make_shape("plate3"))) {
    loops += of_face.size();
    for (const auto& loop : of_face) sides += loop.beyond.size();
  }
  EXPECT_EQ(loops, 18u + 2 * 3);
  EXPECT_EQ(sides, 2u * 48);
  for (const auto& of_face : side_loops(simulation::make_shape("open_box")))
    for (const auto& loop : of_face)
      for (const int beyond : loop.beyond) open += beyond == -1;
  EXPECT_EQ(open, 4u);
}

TEST(SideLoops, RunWithTheInteriorOnTheLeft) {
  const simulation::Mesh mesh = simulation::make_shape("plate3");
  const auto faces = simulation::faces_of(mesh);
  const auto loops = side_loops(mesh);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    double area = 0;
    for (const auto& loop : loops[f])
      for (std::size_t i = 0; i < loop.begins.size(); ++i)
        area += faces[f].normal.dot(loop.begins[i].cross(loop.begins[(i + 1) % loop.begins.size()])) / 2;
    EXPECT_NEAR(area, faces[f].area, 1e-12);
  }
}

TEST(SideLoops, OfAModelAreItsEdges) {
  const auto loops = side_loops(io::testing::open_cube());
  ASSERT_EQ(loops.size(), 5u);
  int open = 0;
  for (const auto& of_polygon : loops) {
    ASSERT_EQ(of_polygon.size(), 1u);
    EXPECT_EQ(of_polygon[0].begins.size(), 4u);
    for (const int beyond : of_polygon[0].beyond) open += beyond == -1;
  }
  EXPECT_EQ(open, 4);
  for (const int beyond : loops[0][0].beyond) EXPECT_GT(beyond, 0) << "the base has all the walls";
}

TEST(JudgeTopology, TheTruthIsFaultless) {
  const std::vector<std::pair<std::string, int>> shapes{
      {"cube", 12}, {"L", 18}, {"step_hole", 30}, {"plate3", 48}, {"open_box", 8}};
  for (const auto& [name, sides] : shapes) {
    const Pair pair(simulation::make_shape(name));
    const auto report = pair.judged();
    EXPECT_EQ(report.faults, std::vector<std::string>{}) << name;
    EXPECT_TRUE(report.isomorphic) << name;
    EXPECT_EQ(report.closed, name != "open_box") << name;
    EXPECT_EQ(report.faces, pair.truth.face_count) << name;
    EXPECT_EQ(report.true_shared, sides) << name;
    EXPECT_EQ(report.shared, sides) << name;
    EXPECT_EQ(report.false_shared, 0) << name;
    EXPECT_LT(report.vertex_distance, 1e-12) << name;
  }
}

TEST(JudgeTopology, WherePolygonsBeginMeansNothing) {
  Pair pair(simulation::make_shape("step_hole"));
  std::ptrdiff_t turn = 0;
  for (auto& s : pair.model.polygon_segments)
    for (auto& cycle : s.cycles) std::rotate(cycle.begin(), cycle.begin() + ++turn % 4, cycle.end());
  // Nor in what order the polygons are.
  std::reverse(pair.model.polygon_segments.begin(), pair.model.polygon_segments.end());
  for (auto& p : pair.faces.polygons) p.face = pair.truth.face_count - 1 - p.face;
  const auto report = pair.judged();
  EXPECT_TRUE(report.isomorphic);
  EXPECT_EQ(report.shared, 30);
  EXPECT_LT(report.vertex_distance, 1e-12);
}

TEST(JudgeTopology, AMissingSideIsMissed) {
  Pair pair(simulation::make_shape("cube"));
  pair.unshare(pair.cycle(0)[1]);
  const auto report = pair.judged();
  EXPECT_FALSE(report.closed);
  EXPECT_FALSE(report.isomorphic);
  EXPECT_EQ(report.faces, 4);
  EXPECT_EQ(report.true_shared, 12);
  EXPECT_EQ(report.shared, 11);
  EXPECT_EQ(report.false_shared, 0);
  EXPECT_EQ(report.faults.size(), 2u);
}

TEST(JudgeTopology, AFalseNeighbourIsToldApart) {
  Pair pair(simulation::make_shape("cube"));
  VertexRecord &top = pair.cycle(pair.facing(Vector3d::UnitZ()))[0],
               &under = pair.cycle(pair.facing(-Vector3d::UnitZ()))[0];
  pair.unshare(top);
  pair.unshare(under);
  pair.share(top, under);
  const auto report = pair.judged();
  EXPECT_FALSE(report.isomorphic);
  EXPECT_EQ(report.shared, 10);
  EXPECT_EQ(report.false_shared, 1);
}

TEST(JudgeTopology, TrueNeighboursAtTheWrongSidesAreNotTheSameTopology) {
  Pair pair(simulation::make_shape("cube"));
  auto& top = pair.cycle(pair.facing(Vector3d::UnitZ()));
  const std::uint64_t a = top[0].partner, b = top[1].partner;
  pair.share(top[0], pair.edge(b));
  pair.share(top[1], pair.edge(a));
  const auto report = pair.judged();
  EXPECT_TRUE(report.closed);
  EXPECT_FALSE(report.isomorphic);
  EXPECT_EQ(report.shared, 12);
  EXPECT_EQ(report.false_shared, 0);
}

TEST(JudgeTopology, ASideInTwoEdgesIsNotTheSameTopology) {
  Pair pair(simulation::make_shape("cube"));
  auto& top = pair.cycle(pair.facing(Vector3d::UnitZ()));
  VertexRecord middle = top[0];
  middle.x = (top[0].x + top[1].x) / 2, middle.y = (top[0].y + top[1].y) / 2;
  middle.edge = pair.model.next_edge++;
  middle.partner = 0;
  top.insert(top.begin() + 1, middle);
  const auto report = pair.judged();
  EXPECT_FALSE(report.isomorphic);
  EXPECT_EQ(report.faces, 5);
  EXPECT_EQ(report.shared, 12);
}

TEST(JudgeTopology, VerticesAreMeasuredWhereSharedSidesMeet) {
  Pair pair(simulation::make_shape("cube"));
  VertexRecord& v = pair.cycle(3)[2];
  const double step = pair.model.grid_step;
  v.x += 0.03125 / step;
  const auto report = pair.judged();
  EXPECT_TRUE(report.isomorphic) << "the neighbours are right all the same";
  EXPECT_NEAR(report.vertex_distance, 0.03125, 1e-12);
}

TEST(JudgeTopology, HolesAreLoopsOfTheirOwn) {
  const simulation::Mesh plate = simulation::make_shape("plate3");
  Pair filled(plate);
  const int top = filled.facing(Vector3d::UnitZ());
  for (auto& v : filled.cycle(top, 2)) filled.edge(v.partner).partner = 0;
  filled.model.polygon_segments[static_cast<std::size_t>(top)].cycles.erase(
      filled.model.polygon_segments[static_cast<std::size_t>(top)].cycles.begin() + 2);
  auto report = filled.judged();
  EXPECT_FALSE(report.closed || report.isomorphic);
  EXPECT_EQ(report.faces, 18 - 5) << "the top, and the four walls of its hole";
  EXPECT_EQ(report.shared, 44);

  // Two holes that have one wall of each other's.
  Pair crossed(plate);
  VertexRecord &a = crossed.cycle(top, 1)[0], &b = crossed.cycle(top, 2)[0];
  const std::uint64_t of_a = a.partner, of_b = b.partner;
  crossed.share(a, crossed.edge(of_b));
  crossed.share(b, crossed.edge(of_a));
  report = crossed.judged();
  EXPECT_TRUE(report.closed);
  EXPECT_FALSE(report.isomorphic);
  EXPECT_EQ(report.shared, 48);
  EXPECT_EQ(report.false_shared, 0);
}

TEST(JudgeTopology, OpenSidesMayHaveManyEdges) {
  Pair pair(simulation::make_shape("open_box"));
  for (int f = 0; f < pair.truth.face_count; ++f) {
    auto& cycle = pair.cycle(f);
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      if (cycle[i].partner != 0) continue;
      VertexRecord middle = cycle[i];
      middle.x = (2 * cycle[i].x + cycle[(i + 1) % cycle.size()].x) / 3 + 7;
      middle.y = (2 * cycle[i].y + cycle[(i + 1) % cycle.size()].y) / 3 - 5;
      middle.edge = pair.model.next_edge++;
      cycle.insert(cycle.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
      break;
    }
  }
  const auto report = pair.judged();
  EXPECT_TRUE(report.isomorphic);
  EXPECT_FALSE(report.closed);
  EXPECT_EQ(report.faces, 5);
  EXPECT_EQ(report.shared, 8);
  EXPECT_LT(report.vertex_distance, 1e-12);
}

TEST(JudgeTopology, AClosedModelOfAnOpenTruthIsNotTheSame) {
  // The lid of an open box, which nobody scanned.
  Pair box(simulation::make_shape("cube"));
  const simulation::Mesh open = simulation::make_shape("open_box");
  const int lid = box.facing(Vector3d::UnitZ());
  const auto cube_faces = simulation::faces_of(box.truth), open_faces = simulation::faces_of(open);
  for (std::size_t f = 0; f < cube_faces.size(); ++f)
    for (std::size_t g = 0; g < open_faces.size(); ++g)
      if (cube_faces[f].normal.dot(open_faces[g].normal) > 0.99)
        box.faces.polygons[f].face = static_cast<int>(g);
  box.faces.polygons[static_cast<std::size_t>(lid)].face = -1;
  box.faces.polygons[static_cast<std::size_t>(lid)].extra = true;
  box.truth = open;
  const auto report = box.judged();
  EXPECT_TRUE(report.closed);
  EXPECT_FALSE(report.isomorphic);
  EXPECT_EQ(report.shared, 8);
  EXPECT_EQ(report.false_shared, 4);
}

TEST(JudgeTopology, PolygonsOnNoFaceThatShareAreFalse) {
  Pair pair(simulation::make_shape("cube"));
  const ModelRecord other = io::testing::cube({5, 0, 0});
  for (std::size_t i = 0; i < 2; ++i) {
    auto s = other.polygon_segments[i];
    s.id += 100;
    for (auto& v : s.cycles[0]) v.edge += 1000, v.partner = 0;
    pair.model.polygon_segments.push_back(s);
    pair.add_polygon(-1, true);
  }
  EXPECT_FALSE(pair.judged().isomorphic) << "two polygons too many";
  EXPECT_EQ(pair.judged().false_shared, 0);
  pair.share(pair.cycle(6)[0], pair.cycle(7)[0]);
  EXPECT_EQ(pair.judged().false_shared, 1);
}

TEST(JudgeTopology, AFaceWithoutPolygonIsAFault) {
  Pair pair(simulation::make_shape("cube"));
  for (auto& v : pair.cycle(5)) pair.edge(v.partner).partner = 0;
  pair.model.polygon_segments.pop_back();
  pair.faces.polygons.pop_back();
  const auto report = pair.judged();
  EXPECT_FALSE(report.isomorphic || report.closed);
  EXPECT_EQ(report.faces, 1) << "the one beyond";
  EXPECT_EQ(report.shared, 8);
  EXPECT_EQ(report.faults.size(), 5u);
}

TEST(JudgeTopology, NoModelIsNotClosed) {
  const auto report = judge_topology(ModelRecord{}, simulation::make_shape("cube"), {});
  EXPECT_FALSE(report.closed || report.isomorphic);
  EXPECT_EQ(report.true_shared, 12);
  EXPECT_EQ(report.faults.size(), 6u);
}

TEST(JudgeTopology, FacesWithSeveralSidesInCommonArePairOnce) {
  Pair pair(notched());
  const int pairs = pair.judged().true_shared;
  // The twelve sides of a cube, one of them in two pieces, and eleven of the notch.
  EXPECT_EQ(pair.truth.face_count, 10);
  EXPECT_EQ(pairs, 23);
  EXPECT_TRUE(pair.judged().isomorphic);
  EXPECT_EQ(pair.judged().shared, pairs);
}

}  // namespace
}  // namespace limpet::evaluation
