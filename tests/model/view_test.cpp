// Copyright the limpet authors. GPL-3.0-or-later.
//
// The window onto the model, question by question, on models that can be seen at a glance.
#include <gtest/gtest.h>

#include <limpet/model/view.hpp>

#include "streams.hpp"

namespace limpet::model {
namespace {

using namespace testing;
using Cycle = std::vector<Vector3d>;

constexpr double kEver = std::numeric_limits<double>::infinity();

Cycle turned_round(Cycle cycle) {
  std::reverse(cycle.begin(), cycle.end());
  return cycle;
}

Cycle square(double half, double z = 0, const Vector3d& about = {0, 0, 0}) {
  return {about + Vector3d(-half, -half, z), about + Vector3d(half, -half, z),
          about + Vector3d(half, half, z), about + Vector3d(-half, half, z)};
}

/// Faces known beforehand, at a resolution of 1/16, so that these squares are exact.
Model model_of(const std::vector<InitialFace>& faces) {
  Model model(of_resolution(0.0625));
  model.add_initial(faces);
  return model;
}

/// A plate of 4 × 4 in z = 0, seen from above, with a bore of 1 × 1.
Model bored_plate() { return model_of({{{square(2), turned_round(square(0.5))}}}); }

/// The cube |x|, |y|, |z| ≤ 1, seen from outside.
std::vector<InitialFace> cube() {
  std::vector<InitialFace> faces;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Cycle cycle;
      for (const Vector3d& p : square(1, 1)) {
        Vector3d v;
        v[axis] = side * p.z(), v[(axis + 1) % 3] = p.x(), v[(axis + 2) % 3] = p.y();
        cycle.push_back(v);
      }
      faces.push_back({{side > 0 ? cycle : turned_round(cycle)}});
    }
  return faces;
}

std::vector<SegmentId> segments_of(const View& view, const Which& which = {}) {
  std::vector<SegmentId> all;
  view.segments(all, which);
  return all;
}

TEST(View, NearestOfAPlateWithABore) {
  const Model model = bored_plate();
  const View view = model.view();
  const SegmentId plate = segments_of(view).at(0);
  const auto at = [&](const Vector3d& p) { return view.nearest(p, kEver).value(); };

  EXPECT_EQ(at({1, 1, 0.5}).at, Vector3d(1, 1, 0));  // over the inside
  EXPECT_EQ(at({1, 1, 0.5}).distance, 0.5);
  EXPECT_EQ(at({1, 1, 0.5}).segment, plate);
  EXPECT_FALSE(at({1, 1, 0.5}).edge);
  EXPECT_EQ(at({1, 1, -0.5}).distance, 0.5);       // from behind
  EXPECT_EQ(at({3, 1, 0}).at, Vector3d(2, 1, 0));  // beside it
  EXPECT_EQ(at({5, 1, 4}).distance, 5);
  EXPECT_EQ(at({0.25, 0, 0}).at, Vector3d(0.5, 0, 0));  // in the bore
  EXPECT_EQ(at({0.25, 0, 0}).distance, 0.25);

  const auto edge = view.edge(at({0.25, 0, 0}).edge).value();
  EXPECT_TRUE(edge.hole);
  EXPECT_EQ(edge.from.x(), 0.5);
  EXPECT_EQ(edge.to.x(), 0.5);
  EXPECT_FALSE(view.edge(at({3, 1, 0}).edge).value().hole);
}

TEST(View, OnVerticesAndEdgesTheEdgeOfLowestIdentityIsNamed) {
  const Model model = bored_plate();
  const View view = model.view();
  std::vector<View::Edge> edges;
  view.edges(segments_of(view).at(0), edges);
  ASSERT_EQ(edges.size(), 8u);
  for (const View::Edge& e : edges) {
    const auto vertex = view.nearest(e.from, 0);  // no reach, and still there
    ASSERT_TRUE(vertex);
    EXPECT_EQ(vertex->distance, 0);
    EXPECT_EQ(vertex->edge, std::min(e.id, e.previous));
    EXPECT_EQ(view.nearest((e.from + e.to) / 2, 0).value().edge, e.id);
    // Outside a corner of the plate its two edges are equally near; inside one of the bore, too.
    const Vector3d out = e.hole ? Vector3d(0.5 * e.from) : Vector3d(2 * e.from);
    EXPECT_EQ(view.nearest(out, kEver).value().edge,
              e.hole ? view.nearest(out, 1).value().edge : std::min(e.id, e.previous));
  }
  // In the middle of the bore all four of its edges are.
  geometry::EdgeId lowest;
  for (const View::Edge& e : edges)
    if (e.hole && (!lowest || e.id < lowest)) lowest = e.id;
  EXPECT_EQ(view.nearest(Vector3d(0, 0, 0), kEver).value().edge, lowest);
  EXPECT_EQ(view.nearest(Vector3d(0, 0, 0.25), kEver).value().edge, lowest);
}

TEST(View, WhatIsBeyondTheReachIsNotFound) {
  const Model model = bored_plate();
  const View view = model.view();
  EXPECT_TRUE(view.nearest(Vector3d(1, 1, 0.5), 0.5));
  EXPECT_FALSE(view.nearest(Vector3d(1, 1, 0.5), std::nextafter(0.5, 0)));
  EXPECT_TRUE(view.nearest(Vector3d(0, 0, 0), 0.5));
  EXPECT_FALSE(view.nearest(Vector3d(0, 0, 0), std::nextafter(0.5, 0)));
  EXPECT_NEAR(view.nearest(Vector3d(1e9, 0, 0), kEver).value().distance, 1e9 - 2, 1e-6);
  EXPECT_TRUE(view.nearest(Vector3d(1e60, 0, 0), kEver));
}

TEST(View, TiesBetweenSegmentsGoToTheLowestIdentityInWhateverOrderTheyCame) {
  std::vector<InitialFace> faces = cube();
  for (int turn = 0; turn < 6; ++turn) {
    std::rotate(faces.begin(), faces.begin() + 1, faces.end());
    const Model model = model_of(faces);
    const View view = model.view();
    const auto all = segments_of(view);
    ASSERT_EQ(all.size(), 6u);
    std::vector<View::Nearest> found;
    for (const Vector3d& p :
         {Vector3d(0, 0, 0), Vector3d(2, 2, 2), Vector3d(1, 1, 1), Vector3d(0.5, 0.5, 0)}) {
      view.nearest(p, kEver, found);
      ASSERT_EQ(found.size(), 6u);
      EXPECT_EQ(view.nearest(p, kEver).value().segment, found.front().segment);
      for (std::size_t i = 1; i < found.size(); ++i)
        EXPECT_TRUE(found[i - 1].distance < found[i].distance ||
                    (found[i - 1].distance == found[i].distance && found[i - 1].segment < found[i].segment));
    }
    EXPECT_EQ(view.nearest(Vector3d(0, 0, 0), kEver).value().segment, all.front());
    // 0.75 from top and bottom, 1 from the others.
    const auto link = view.nearest(Capsule{{0, 0, -0.25}, {0, 0, 0.25}, 0.125}, kEver).value();
    EXPECT_EQ(link.distance, 0.625);
    const auto top = view.nearest(Vector3d(0, 0, 0.875), 0.125).value().segment,
               bottom = view.nearest(Vector3d(0, 0, -0.875), 0.125).value().segment;
    EXPECT_EQ(link.segment, std::min(top, bottom));
    // Through the corner where three faces meet, and along an edge where two do.
    std::vector<SegmentId> met;
    for (const SegmentId id : all)
      if (view.first_hit({3, 3, 3}, {-1, -1, -1}, kEver, {.only = id})) met.push_back(id);
    ASSERT_EQ(met.size(), 6u);
    EXPECT_EQ(view.first_hit({3, 3, 3}, {-1, -1, -1}, kEver).value().segment,
              std::min({view.nearest(Vector3d(2, 0, 0), 1).value().segment,
                        view.nearest(Vector3d(0, 2, 0), 1).value().segment,
                        view.nearest(Vector3d(0, 0, 2), 1).value().segment}));
  }
}

/// Loose readings on a lattice wider than λ: point segments all of them.
TEST(View, TiesBetweenPointSegmentsOnALattice) {
  Model model(of_resolution(0.0625));
  Points points;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y)
      for (int z = 0; z < 5; ++z) points.push_back({{0.25 * x, 0.25 * y, 0.25 * z}, Vector3d(0, 0, -1)});
  Random random(1);
  shuffle(points, random);
  feed(model, points);
  const View view = model.view();
  ASSERT_EQ(segments_of(view).size(), 125u);
  std::vector<View::Nearest> found;
  for (int i = 0; i < 64; ++i) {
    const int row = i / 4 % 4, layer = i / 16;
    const Vector3d middle(0.25 * (i % 4) + 0.125, 0.25 * row + 0.125, 0.25 * layer + 0.125);
    const auto nearest = view.nearest(middle, kEver).value();
    view.nearest(middle, nearest.distance, found);
    ASSERT_EQ(found.size(), 8u);
    EXPECT_EQ(nearest.segment, found.front().segment);
    for (std::size_t k = 1; k < 8; ++k) EXPECT_LT(found[k - 1].segment, found[k].segment);
    EXPECT_NE(view.nearest(middle, kEver, {.but = nearest.segment}).value().segment, nearest.segment);
    EXPECT_FALSE(view.nearest(middle, kEver, {.points = false}));
    EXPECT_FALSE(view.first_hit({middle.x() + 0.125, middle.y() + 0.125, 9}, {0, 0, -1}, kEver));
  }
}

TEST(View, LinksBesideThroughAndAlongAPlate) {
  const Model model = bored_plate();
  const View view = model.view();
  const auto at = [&](const Vector3d& a, const Vector3d& b, double r) {
    return view.nearest(Capsule{a, b, r}, kEver).value();
  };
  const auto above = at({1, 1, 1}, {1, 1, 3}, 0.25);
  EXPECT_EQ(above.distance, 0.75);
  EXPECT_EQ(above.at, Vector3d(1, 1, 0));
  EXPECT_EQ(above.on_axis, Vector3d(1, 1, 1));
  EXPECT_EQ(above.on_surface(0.25), Vector3d(1, 1, 0.75));
  EXPECT_EQ(above.away, Vector3d(0, 0, 1));

  const auto below = at({1, 1, -0.125}, {1, 1, -3}, 0.25);  // reaches in by half its radius
  EXPECT_EQ(below.distance, -0.125);
  EXPECT_EQ(below.away, Vector3d(0, 0, -1));

  const auto through = at({1, 1, 1}, {1, 1, -1}, 0.25);
  EXPECT_EQ(through.distance, -0.25);
  EXPECT_EQ(through.fraction, 0.5);
  EXPECT_EQ(through.away, Vector3d(0, 0, 1));

  const auto through_bore = at({0.25, 0, 1}, {0.25, 0, -1}, 0.125);
  EXPECT_EQ(through_bore.distance, 0.125);
  EXPECT_TRUE(through_bore.edge);

  const auto along = at({-5, 1, 1}, {5, 1, 1}, 0.5);
  EXPECT_EQ(along.distance, 0.5);
  const auto across = at({3, -5, 1}, {3, 5, 1}, 0.5);
  EXPECT_NEAR(across.distance, std::sqrt(2) - 0.5, 1e-15);
  const auto ball = at({1, 1, 1}, {1, 1, 1}, 0.25);  // of no length
  EXPECT_EQ(ball.distance, 0.75);
  EXPECT_EQ(ball.away, Vector3d(0, 0, 1));
  EXPECT_FALSE(view.nearest(Capsule{{1, 1, 1}, {1, 1, 3}, 0.25}, 0.5));
}

/// Beside an edge, and hardly at an angle to it: the places that are nearest are hard to find.
TEST(View, LinksNearlyAlongAnEdge) {
  const Model model = bored_plate();
  const View view = model.view();
  const double gap = 0x1p-20;
  for (double climb = 0.1; climb > 1e-9; climb *= 0.37) {
    const Capsule link{{2 + gap, -1.3, -0.7 * climb}, {2 + gap, 1.7, 1.1 * climb}, 0};
    EXPECT_NEAR(view.nearest(link, kEver).value().distance, gap, 1e-13) << climb;
  }
}

TEST(View, RaysHitFromBothSidesAndGoThroughTheBore) {
  const Model model = bored_plate();
  const View view = model.view();
  const auto down = view.first_hit({1, 1, 3}, {0, 0, -2}, 3).value();  // of any length
  EXPECT_EQ(down.at, Vector3d(1, 1, 0));
  EXPECT_EQ(down.range, 3);
  EXPECT_TRUE(down.from_outside);
  EXPECT_FALSE(view.first_hit({1, 1, -3}, {0, 0, 1}, kEver).value().from_outside);
  EXPECT_FALSE(view.first_hit({1, 1, 3}, {0, 0, -1}, 2.5));
  EXPECT_FALSE(view.first_hit({1, 1, 3}, {0, 0, 1}, kEver));            // the other way
  EXPECT_FALSE(view.first_hit({0, 0, 3}, {0, 0, -1}, kEver));           // through the bore
  EXPECT_TRUE(view.first_hit({0.5, 0, 3}, {0, 0, -1}, kEver));          // its edge belongs to the plate
  EXPECT_FALSE(view.first_hit({-9, 1, 0}, {1, 0, 0}, kEver));           // in the plane
  EXPECT_EQ(view.first_hit({1, 1, 0}, {0, 0, 1}, 0).value().range, 0);  // begins on it
  EXPECT_FALSE(view.first_hit({1, 1, 3}, {0, 0, -1}, kEver, {.initial = false}));
  EXPECT_NEAR(view.first_hit({1, 1, 1e9}, {0, 0, -1}, kEver).value().range, 1e9, 1e-6);
}

TEST(View, AnEmptyModelHasNothing) {
  const Model model(of_resolution(1));
  const View view = model.view();
  EXPECT_FALSE(view.nearest(Vector3d(0, 0, 0), kEver));
  EXPECT_FALSE(view.nearest(Capsule{{0, 0, 0}, {1, 0, 0}, 1}, kEver));
  EXPECT_FALSE(view.first_hit({0, 0, 0}, {1, 0, 0}, kEver));
  EXPECT_FALSE(view.edge({1}));
  EXPECT_FALSE(view.edge({}));
  EXPECT_FALSE(view.segment({1}));
  EXPECT_FALSE(view.surface_of({1}));
  std::vector<SegmentId> ids{{7}};
  view.segments(ids);
  EXPECT_TRUE(ids.empty());
  std::vector<View::Edge> edges(1);
  view.open_edges(edges);
  EXPECT_TRUE(edges.empty());
}

TEST(View, WhatCannotBeAskedIsRefused) {
  const Model model = bored_plate();
  const View view = model.view();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(view.nearest(Vector3d(nan, 0, 0), 1), std::invalid_argument);
  EXPECT_THROW(view.nearest(Vector3d(0, kEver, 0), 1), std::invalid_argument);
  EXPECT_THROW(view.nearest(Vector3d(0, 0, 1e300), 1), std::invalid_argument);
  EXPECT_THROW(view.nearest(Vector3d(0, 0, 0), -1), std::invalid_argument);
  EXPECT_THROW(view.nearest(Vector3d(0, 0, 0), nan), std::invalid_argument);
  EXPECT_THROW(view.nearest(Capsule{{0, 0, 0}, {nan, 0, 0}, 1}, 1), std::invalid_argument);
  EXPECT_THROW(view.nearest(Capsule{{0, 0, 0}, {1, 0, 0}, -1}, 1), std::invalid_argument);
  EXPECT_THROW(view.nearest(Capsule{{0, 0, 0}, {1, 0, 0}, kEver}, 1), std::invalid_argument);
  EXPECT_THROW(view.first_hit({0, 0, 0}, {0, 0, 0}, 1), std::invalid_argument);
  EXPECT_THROW(view.first_hit({0, 0, 0}, {nan, 0, 0}, 1), std::invalid_argument);
  EXPECT_THROW(view.first_hit({0, 0, 0}, {1, 0, 0}, -1), std::invalid_argument);
}

TEST(View, SegmentsByIdentityAndByBox) {
  const Model model = bored_plate();
  const View view = model.view();
  const SegmentId plate = segments_of(view).at(0);
  const auto segment = view.segment(plate).value();
  EXPECT_EQ(segment.kind, View::Kind::initial);
  EXPECT_EQ(segment.plane.normal, Vector3d(0, 0, 1));
  EXPECT_EQ(segment.points, 0);
  EXPECT_EQ(segment.edges, 8u);
  EXPECT_EQ(segment.holes, 1u);
  EXPECT_EQ(segment.box.min(), Vector3d(-2, -2, 0));
  EXPECT_EQ(segment.box.max(), Vector3d(2, 2, 0));
  std::vector<SegmentId> near;
  const auto meets = [&](const Eigen::AlignedBox3d& box) {
    view.near(box, near);
    return !near.empty();
  };
  EXPECT_TRUE(meets({Vector3d(2, 2, 0), Vector3d(3, 3, 3)}));
  EXPECT_FALSE(meets({Vector3d(2.001, 2, 0), Vector3d(3, 3, 3)}));
  EXPECT_TRUE(meets({Vector3d::Constant(-kEver), Vector3d::Constant(kEver)}));
  EXPECT_FALSE(meets({}));
  EXPECT_FALSE(view.segment({plate.value + 1}));
  EXPECT_FALSE(view.nearest(Vector3d(0, 0, 0), kEver, {.only = {plate.value + 1}}));
}

/// Identities on a scanned solid: all as the record, the changes and the list of surfaces have them.
class ViewOfAScan : public ::testing::Test {
 protected:
  ViewOfAScan()
      : scan(scanned("step_hole", 20'000, 0.001, simulation::ScanOptions::Order::shuffled)),
        model(modelled(scan.parameters, scan.points)) {}

  Scan scan;
  Model model;
};

TEST_F(ViewOfAScan, EdgesAreThoseOfTheRecord) {
  const View view = model.view();
  const ModelRecord record = model.record();
  std::vector<View::Edge> edges, open, all_open;
  std::vector<geometry::EdgeId> open_ids;
  for (const auto& s : record.polygon_segments) {
    const auto cycles = world_cycles(s, record.grid_step);
    view.edges({s.id}, edges);
    std::size_t i = 0;
    for (std::size_t c = 0; c < cycles.size(); ++c)
      for (std::size_t k = 0; k < cycles[c].size(); ++k, ++i) {
        const auto& vertices = s.cycles[c];
        const std::size_t n = vertices.size();
        ASSERT_LT(i, edges.size());
        const View::Edge& e = edges[i];
        EXPECT_EQ(e.id.value, vertices[k].edge);
        EXPECT_EQ(e.next.value, vertices[(k + 1) % n].edge);
        EXPECT_EQ(e.previous.value, vertices[(k + n - 1) % n].edge);
        EXPECT_EQ(e.partner.value, vertices[k].partner);
        EXPECT_EQ(e.hole, c > 0);
        EXPECT_EQ(e.cycle == edges[0].cycle, c == 0);
        EXPECT_EQ(e.segment.value, s.id);
        EXPECT_LT((e.from - cycles[c][k]).norm(), 1e-12);
        EXPECT_LT((e.to - cycles[c][(k + 1) % n]).norm(), 1e-12);
        const auto by_id = view.edge(e.id);
        ASSERT_TRUE(by_id);
        EXPECT_EQ(by_id->partner, e.partner);
        EXPECT_EQ(by_id->from, e.from);
        if (!e.partner) open_ids.push_back(e.id);
        if (e.partner) {
          EXPECT_EQ(view.edge(e.partner).value().partner, e.id);
        }
      }
    EXPECT_EQ(i, edges.size());
    view.open_edges({s.id}, open);
    EXPECT_EQ(open.size(), static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(),
                                                                  [](const auto& e) { return !e.partner; })));
  }
  view.open_edges(all_open);
  std::sort(open_ids.begin(), open_ids.end());
  ASSERT_EQ(all_open.size(), open_ids.size());
  for (std::size_t i = 0; i < open_ids.size(); ++i) EXPECT_EQ(all_open[i].id, open_ids[i]);
}

TEST_F(ViewOfAScan, SegmentsNeighboursAndSurfacesAreThoseOfTheModel) {
  const View view = model.view();
  const ModelRecord record = model.record();
  EXPECT_EQ(segments_of(view).size(), record.polygon_segments.size() + record.point_segments.size());
  EXPECT_EQ(segments_of(view, {.points = false}).size(), record.polygon_segments.size());
  std::vector<SegmentId> found;
  std::vector<View::Edge> edges;
  for (const auto& s : record.polygon_segments) {
    const auto segment = view.segment({s.id}).value();
    EXPECT_EQ(segment.kind, View::Kind::polygon);
    EXPECT_EQ(segment.points, s.moments.count);
    EXPECT_LT((segment.plane.normal - normal_of(s)).norm(), 1e-12);
    std::vector<SegmentId> across;
    view.edges({s.id}, edges);
    for (const auto& e : edges)
      if (e.partner) across.push_back(view.edge(e.partner).value().segment);
    std::sort(across.begin(), across.end());
    across.erase(std::unique(across.begin(), across.end()), across.end());
    view.neighbours({s.id}, found);
    EXPECT_EQ(found, across);
  }
  for (const auto& surface : model.surfaces())
    for (const SegmentId id : surface) {
      EXPECT_EQ(view.surface_of(id), surface.front());
      view.surface(id, found);
      EXPECT_EQ(found, surface);
    }
}

TEST_F(ViewOfAScan, WhatIsGoneIsNotFound) {
  Model growing(scan.parameters);
  for (std::size_t i = 0; i + 26 <= scan.points.size(); i += 26) {
    const auto changes = growing.update(std::span(scan.points).subspan(i, 26));
    const View view = growing.view();
    for (const Change& c : changes) {
      if (c.kind == Change::Kind::edges_removed)
        for (const auto edge : c.edges) {
          EXPECT_FALSE(view.edge(edge));
        }
      if (c.kind == Change::Kind::deleted) {
        EXPECT_FALSE(view.segment(c.first));
      }
      if (c.kind != Change::Kind::merged) continue;
      if (c.first != c.result) {
        EXPECT_FALSE(view.segment(c.first));
      }
      if (c.second != c.result) {
        EXPECT_FALSE(view.segment(c.second));
      }
    }
    if (i > 26 * 200) break;
  }
}

TEST_F(ViewOfAScan, AViewOutlivesAMove) {
  const View view = model.view();
  const auto before = view.nearest(Vector3d(0, 0, 0), kEver).value();
  const Model elsewhere = std::move(model);
  EXPECT_EQ(view.nearest(Vector3d(0, 0, 0), kEver).value().at, before.at);
}

}  // namespace
}  // namespace limpet::model
