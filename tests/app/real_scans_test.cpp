// Copyright the limpet authors. GPL-3.0-or-later.
//
// Real scans, modelled without any option, and judged by the labels that came with them. The files are in the
// folder named by LIMPET_DATA; skipped where they are absent.
#include <limpet/io/native.hpp>
#include <limpet/io/scan_reader.hpp>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "../data_folder.hpp"
#include "program.hpp"

namespace limpet::app {
namespace {

using testing::ProgramTest;

std::string data(const std::string& name) { return (limpet::testing::data_folder() / name).string(); }

/// Points of a scan by polygon and by true label; label 0 of the scan is none.
struct Regions {
  std::int64_t points = 0;
  std::map<std::int64_t, std::int64_t> of_label;
  std::map<std::uint64_t, std::map<std::int64_t, std::int64_t>> of_polygon;
};

class RealScans : public ProgramTest {
 protected:
  Regions regions(const std::string& scan) {
    const auto result = run({"model", scan, "-o", path("m.limpet"), "--labels", path("labels"), "-q"});
    EXPECT_EQ(result.code, 0) << result.err;
    std::set<std::uint64_t> polygons;
    model_ = io::load_native(path("m.limpet"));
    for (const auto& s : model_.polygon_segments) polygons.insert(s.id);
    std::ifstream labels(path("labels"));
    const auto reader = io::open_scan(scan, {});
    Regions regions;
    io::ScanRecord record;
    std::int64_t skipped = 0;
    std::uint64_t segment = 0;
    while (reader->next(record)) {
      for (; skipped < reader->skipped(); ++skipped) labels >> segment;
      labels >> segment;
      ++regions.points;
      if (record.label <= 0) continue;
      ++regions.of_label[record.label];
      if (polygons.contains(segment)) ++regions.of_polygon[segment][record.label];
    }
    EXPECT_TRUE(labels);
    return regions;
  }

  model::ModelRecord model_;
};

/// Boxes on a table, seen by a depth camera: labels 1 to 9 are the table, others one object each.
TEST_F(RealScans, BoxesOnATable) {
  for (const std::string name :
       {"learn0", "learn4", "learn9", "learn13", "learn17", "learn20", "learn24", "learn28", "learn33"}) {
    const std::string scan = data("pcl_mOSD/" + name + ".pcd");
    if (!std::filesystem::exists(scan)) GTEST_SKIP() << scan << " is not there";
    SCOPED_TRACE(name);
    const Regions found = regions(scan);
    std::set<std::int64_t> with_polygon;
    std::int64_t wrong = 0, all = 0, table = 0, largest_of_table = 0, pure = 0;
    for (const auto& [polygon, labels] : found.of_polygon) {
      std::int64_t sum = 0, most = 0, of = 0;
      for (const auto& [label, count] : labels) {
        sum += count;
        if (count > most) most = count, of = label;
      }
      with_polygon.insert(of);
      if (of < 10) largest_of_table = std::max(largest_of_table, most);
      wrong += sum - most, all += sum;
      pure += 100 * most >= 95 * sum;
    }
    for (const auto& [label, count] : found.of_label) {
      if (label < 10) table += count;
      if (100 * count < found.points) continue;
      EXPECT_TRUE(with_polygon.contains(label)) << "object " << label;
    }
    // The table is one polygon, whatever it bends, and next to nothing is in the wrong one.
    EXPECT_GT(100 * largest_of_table, 97 * table);
    EXPECT_LT(1000 * wrong, 6 * all);
    EXPECT_GE(10 * pure, 7 * static_cast<std::int64_t>(found.of_polygon.size()));
  }
}

/// A desk at two metres before a wall at five, in depths rounded to steps of up to seven centimetres.
TEST_F(RealScans, RoundedDepths) {
  const std::string scan = data("pcl_test/office1.pcd");
  if (!std::filesystem::exists(scan)) GTEST_SKIP() << scan << " is not there";
  // In the scan's own order: along a curve, whose cells are hardly thicker than a step, the wall is two.
  const auto result = run({"model", scan, "-o", path("m.limpet"), "--order", "arrival"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("--noise 0,0,0.00"), std::string::npos) << result.out;
  model_ = io::load_native(path("m.limpet"));
  std::int64_t in_polygons = 0, largest = 0;
  for (const auto& s : model_.polygon_segments) {
    in_polygons += s.moments.count;
    largest = std::max(largest, s.moments.count);
  }
  EXPECT_LT(model_.polygon_segments.size(), 100u);
  EXPECT_GT(100 * in_polygons, 93 * model_.points);
  EXPECT_GT(100 * largest, 30 * model_.points);  // the wall
}

struct JudgedScan {
  const char* name;       ///< in the folder of data
  int beyond_bounds = 0;  ///< polygons
};

class RealScan : public ProgramTest, public ::testing::WithParamInterface<JudgedScan> {};

/// What a model says was felt was felt (docs/evidence.md). In one scan one polygon covers a place
/// where more readings are missing than chance explains.
TEST_P(RealScan, IsWhatSupportsItsModel) {
  const auto& [name, beyond_bounds] = GetParam();
  const std::string scan = data(name);
  if (!std::filesystem::exists(scan)) GTEST_SKIP() << scan << " is not there";
  ASSERT_EQ(run({"model", scan, "-o", path("m.limpet"), "-q"}).code, 0);
  const auto check = run({"check", path("m.limpet"), "--scan", scan, "-q", "--json", path("c.json")});
  EXPECT_EQ(check.code, beyond_bounds > 0 ? 1 : 0) << check.err;
  const auto evidence = nlohmann::json::parse(read(path("c.json")))["evidence"];
  const auto& polygons = evidence["polygons"];
  EXPECT_EQ(std::count_if(polygons.begin(), polygons.end(),
                          [](const auto& p) { return p["unsupported"] || p["transparent"]; }),
            beyond_bounds);
  EXPECT_GT(evidence["explained_share"], 0.7);
}

INSTANTIATE_TEST_SUITE_P(
    Judged, RealScan,
    ::testing::Values(JudgedScan{"cgal_points/building.xyz"}, JudgedScan{"cgal_points/ball.ply"},
                      JudgedScan{"cgal_points/cylinders.ply"}, JudgedScan{"cgal_points/spheres.ply"},
                      JudgedScan{"cgal_points/oni.pwn"}, JudgedScan{"cgal_points/radar.xyz"},
                      JudgedScan{"cgal_points/cube.pwn"}, JudgedScan{"cgal_points/b9.ply"},
                      JudgedScan{"pcl_test/lamppost.pcd"},

                      JudgedScan{"pcl_test/office1.pcd"}, JudgedScan{"pcl_mOSD/learn0.pcd"},
                      JudgedScan{"pcl_mOSD/learn4.pcd", 1}, JudgedScan{"pcl_mOSD/learn17.pcd"},
                      JudgedScan{"pcl_mOSD/learn33.pcd"}, JudgedScan{"synpeb_sample/test_100.pcd"},
                      JudgedScan{"pcl_test/milk_cartoon_all_small_clorox.pcd"}),
    [](const auto& scan) {
      std::string name = std::filesystem::path(scan.param.name).stem();
      std::erase(name, '_');
      return name;
    });

class Density : public ProgramTest {};

/// The warning names a resolution, and with that one there is no warning and a model.
TEST_F(Density, TheResolutionOfTheWarningWouldDo) {
  const std::string file = scan("c.ply", "cube", 3000, {"--order", "sampled", "--noise", "0.001"});
  const auto thin = run({"model", file, "-o", path("m.limpet"), "--resolution", "0.03", "--noise", "0.001"});
  ASSERT_EQ(thin.code, 0);
  const std::string before = "--resolution ", after = " would do";
  const auto to = thin.err.find(after), from = thin.err.rfind(before, to);
  ASSERT_NE(to, std::string::npos) << thin.err;
  ASSERT_NE(from, std::string::npos) << thin.err;
  EXPECT_NE(thin.err.find("points per square of the resolution"), std::string::npos) << thin.err;
  const std::string named = thin.err.substr(from + before.size(), to - from - before.size());
  EXPECT_LT(std::stod(named), 0.2);
  const auto enough = run({"model", file, "-o", path("n.limpet"), "--resolution", named, "--noise", "0.001"});
  EXPECT_EQ(enough.err.find("warning"), std::string::npos) << enough.err;
  EXPECT_EQ(io::load_native(path("n.limpet")).polygon_segments.size(), 6u);
}

}  // namespace
}  // namespace limpet::app
