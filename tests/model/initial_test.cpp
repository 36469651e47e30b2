// Copyright the limpet authors. GPL-3.0-or-later.
//
// Initial model segments (thesis §4.3): what was known beforehand closes what a scan from one side leaves
// open.
#include <gtest/gtest.h>

#include "judged_scan.hpp"

namespace limpet::model {
namespace {

using namespace testing;

/// A unit cube seen from one corner: three faces.
JudgedScan one_sided(Order order) {
  simulation::ScanOptions options;
  options.points = 20'000;
  options.order = order;
  options.viewpoints = {Vector3d(3, 2.5, 2.2)};
  return judged_scan(simulation::make_scene("cube").mesh, 0.05, 0.002, options);
}

/// Faces of the truth that no point was scanned on.
std::vector<InitialFace> unseen_faces(const JudgedScan& scan) {
  std::vector<char> seen(static_cast<std::size_t>(scan.truth.face_count));
  for (const auto& p : scan.labelled)
    if (p.face >= 0) seen[static_cast<std::size_t>(p.face)] = 1;
  std::vector<InitialFace> faces;
  const auto all = simulation::faces_of(scan.truth);
  for (std::size_t f = 0; f < all.size(); ++f)
    if (!seen[f]) faces.push_back({all[f].loops});
  return faces;
}

Model modelled_with(const JudgedScan& scan, const std::vector<InitialFace>& faces) {
  Model model(scan.parameters);
  model.add_initial(faces);
  feed(model, scan.points);
  model.finish();
  return model;
}

bool represents_points(const PolygonSegmentRecord& s) { return s.moments.count > 0; }

class InitialSegments : public ::testing::TestWithParam<Order> {};

TEST_P(InitialSegments, CloseWhatIsSeenFromOneSide) {
  const JudgedScan scan = one_sided(GetParam());
  const auto unseen = unseen_faces(scan);
  ASSERT_EQ(unseen.size(), 3u);

  const ModelRecord open = watched(scan.parameters, scan.points, 50).record();
  EXPECT_EQ(open.polygon_segments.size(), 3u);
  EXPECT_FALSE(scan.topology(open).closed) << "what was not seen may not be closed";
  EXPECT_EQ(scan.topology(open).false_shared, 0);

  const ModelRecord closed = modelled_with(scan, unseen).record();
  EXPECT_EQ(broken_laws(closed), "");
  ASSERT_EQ(closed.polygon_segments.size(), 6u);
  EXPECT_EQ(partners_of(closed).size(), 24u) << "twelve edges, each shared, and no open one";
}

TEST_P(InitialSegments, ArePlanesThatStayAndRepresentNothing) {
  const JudgedScan scan = one_sided(GetParam());
  const auto unseen = unseen_faces(scan);
  Model alone(scan.parameters);
  alone.add_initial(unseen);
  const ModelRecord before = alone.record(), after = modelled_with(scan, unseen).record();
  EXPECT_EQ(broken_laws(before), "");
  ASSERT_EQ(before.polygon_segments.size(), unseen.size());
  for (const auto& s : before.polygon_segments) {
    EXPECT_FALSE(represents_points(s));
    const auto same = std::find_if(after.polygon_segments.begin(), after.polygon_segments.end(),
                                   [&](const auto& other) { return other.id == s.id; });
    ASSERT_NE(same, after.polygon_segments.end());
    EXPECT_FALSE(represents_points(*same));
    EXPECT_EQ(same->chart_origin, s.chart_origin);
    EXPECT_EQ(same->chart_normal, s.chart_normal);
    EXPECT_EQ(same->height, s.height);
  }
  EXPECT_EQ(bytes(Model(after).record()), bytes(after)) << "and are read again as what they are";
}

TEST_P(InitialSegments, AreConfirmedByWhatIsFeltOnThem) {
  const JudgedScan scan = one_sided(GetParam());
  std::vector<InitialFace> all;
  for (const auto& face : simulation::faces_of(scan.truth)) all.push_back({face.loops});
  const ModelRecord record = modelled_with(scan, all).record();
  EXPECT_EQ(broken_laws(record), "");
  EXPECT_EQ(std::count_if(record.polygon_segments.begin(), record.polygon_segments.end(), represents_points),
            0);
  EXPECT_EQ(record.polygon_segments.size(), 6u);
  std::int64_t confirmed = 0;
  for (const auto& s : record.polygon_segments) confirmed += s.confirmed;
  EXPECT_GT(confirmed, record.points * 98 / 100)
      << "the noise puts some beyond an edge, or three of its deviations off";
}

INSTANTIATE_TEST_SUITE_P(Orders, InitialSegments, ::testing::Values(Order::raster, Order::shuffled),
                         [](const auto& test) { return test.index == 0 ? "raster" : "shuffled"; });

std::vector<InitialFace> initial_faces_of(const simulation::Mesh& mesh) {
  std::vector<InitialFace> faces;
  for (const auto& face : simulation::faces_of(mesh)) faces.push_back({face.loops});
  return faces;
}

Parameters coarse() {
  Parameters parameters;
  parameters.resolution = 0.05;
  parameters.tolerance = 0.01;
  return parameters;
}

std::size_t edges_in(const std::vector<InitialFace>& faces) {
  std::size_t count = 0;
  for (const InitialFace& face : faces)
    for (const auto& cycle : face.cycles) count += cycle.size();
  return count;
}

TEST(InitialFaces, ShareTheirCommonEdgesAtOnce) {
  // drum:64 has faces that meet at less than μ; notch one with a hole.
  for (const char* shape : {"cube", "L", "notch", "icosahedron", "octahedron", "drum:64"}) {
    SCOPED_TRACE(shape);
    auto faces = initial_faces_of(simulation::make_scene(shape).mesh);
    Model whole(coarse());
    whole.add_initial(faces);
    EXPECT_EQ(broken_laws(whole.record()), "");
    EXPECT_EQ(partners_of(whole.record()).size(), edges_in(faces)) << "all edges";

    // Without one face, its edges are open.
    const std::size_t of_last = faces.back().cycles.front().size();
    ASSERT_EQ(faces.back().cycles.size(), 1U);
    faces.pop_back();
    Model open(coarse());
    open.add_initial(faces);
    EXPECT_EQ(broken_laws(open.record()), "");
    EXPECT_EQ(partners_of(open.record()).size(), edges_in(faces) - of_last);
  }
}

TEST(InitialFaces, ShareOnlyWhatTwoOfThemHaveInCommon) {
  using Cycle = std::vector<Vector3d>;
  const Cycle floor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Cycle wall{{1, 0, 0}, {0, 0, 0}, {0, 0, 1}, {1, 0, 1}};
  const Cycle against{{0, 0, 0}, {1, 0, 0}, {1, 0, -1}, {0, 0, -1}};
  const Cycle beside{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};
  const Cycle shorter{{0.9, 0, 0}, {0, 0, 0}, {0, 0, 1}, {0.9, 0, 1}};
  const auto shared_of = [](const std::vector<Cycle>& cycles) {
    std::vector<InitialFace> faces;
    for (const Cycle& cycle : cycles) faces.push_back({{cycle}});
    Model model(coarse());
    model.add_initial(faces);
    EXPECT_EQ(broken_laws(model.record()), "");
    return partners_of(model.record()).size();
  };
  EXPECT_EQ(shared_of({floor, wall}), 2U);
  EXPECT_EQ(shared_of({floor, beside}), 0U) << "in one plane";
  EXPECT_EQ(shared_of({floor, shorter}), 0U) << "other vertices";
  EXPECT_EQ(shared_of({floor, against}), 0U) << "both run the same way";
  EXPECT_EQ(shared_of({floor, wall, against}), 0U) << "three faces at one edge";

  Parameters open = coarse();
  open.neighbours = false;
  Model model(open);
  model.add_initial(std::vector<InitialFace>{{{floor}}, {{wall}}});
  EXPECT_EQ(partners_of(model.record()).size(), 0U) << "sharing is turned off";
}

TEST(InitialFaces, ThatAreNoneAreRefused) {
  Model model(of_resolution(0.1));
  const auto refused = [&](const std::vector<Vector3d>& cycle) {
    const InitialFace face{{cycle}};
    EXPECT_THROW(model.add_initial(std::span(&face, 1)), std::invalid_argument);
  };
  refused({});
  refused({{0, 0, 0}, {1, 0, 0}});
  refused({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  refused({{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {3, 2, 0}});  // crosses itself
  refused({{0, 0, 0}, {1, 0, 0}, {1, std::nan(""), 0}});
  EXPECT_EQ(model.record().polygon_segments.size(), 0u);
}

/// Beyond what the grid holds (the law `grid`): a face would be in the model and break it.
TEST(InitialFaces, TooLargeOrTooFarForTheGridAreRefused) {
  Model model(of_resolution(0.1));
  const double step = model.record().grid_step, wide = 0x1p39 * step, far = 0x1p48 * step;
  const auto square = [](const Vector3d& middle, double half) {
    const Vector3d x(half, 0, 0), y(0, half, 0);
    return InitialFace{{{middle - x - y, middle + x - y, middle + x + y, middle - x + y}}};
  };
  const auto refusal_of = [&](const InitialFace& face) {
    const InitialFace faces[] = {square({0, 0, 1}, 1), face, square({0, 0, 3}, 1)};
    try {
      model.add_initial(faces);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal_of(square({0, 0, 2}, wide)), "");
  EXPECT_EQ(refusal_of(square({far - 2, 0, 0}, 1)), "");
  const auto before = model.counts().polygons;
  EXPECT_NE(refusal_of(square({0, 0, 4}, 2.1 * wide)).find("face 1 is wider than 2^40"), std::string::npos);
  EXPECT_NE(refusal_of(square({0, 0, 1.1 * far}, 1)).find("face 1 has a vertex beyond 2^48"),
            std::string::npos);
  EXPECT_NE(refusal_of(square({0, 0, 1e300}, 1)).find("face 1 has a vertex beyond 2^48"), std::string::npos);
  InitialFace holed = square({0, 0, 5}, 1);
  holed.cycles.push_back({{0, 0, 5}, {0, 0.5, 5}, {std::nan(""), 0, 5}});
  EXPECT_NE(refusal_of(holed).find("face 1 has a vertex that is not finite"), std::string::npos);
  EXPECT_EQ(model.counts().polygons, before + 4) << "the face before each refused one stays";
  model.update(std::vector<SensorPoint>{{{0.5, 0.5, 9}, {0, 0, -1}, 0}});
  EXPECT_EQ(broken_laws(model.record()), "");
}

}  // namespace
}  // namespace limpet::model
