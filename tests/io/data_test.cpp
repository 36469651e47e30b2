// Copyright the limpet authors. GPL-3.0-or-later.
//
// Clouds nobody here wrote, from the folder named by LIMPET_DATA; skipped where it is absent. What each holds
// is known from its header or its number of lines.
#include <algorithm>
#include <cstdlib>
#include <limpet/io/label_source.hpp>
#include <set>

#include "../data_folder.hpp"
#include "files.hpp"

namespace limpet::io::testing {
namespace {

using limpet::testing::data_folder;

struct DataScan {
  std::string path;
  long records;
  bool has_axis;
  bool has_gaps = false;  ///< pixels without a point, or normals that are none
};

// NOLINTNEXTLINE(readability-identifier-naming): a name of GoogleTest
void PrintTo(const DataScan& scan, std::ostream* out) { *out << scan.path; }

class DataScans : public ::testing::TestWithParam<DataScan> {};

TEST_P(DataScans, AreReadToTheirEnd) {
  const std::filesystem::path path = data_folder() / GetParam().path;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  const ScanResult scan = read_scan(path.string());
  EXPECT_EQ(scan.error, "");
  const long points = static_cast<long>(scan.records.size());
  EXPECT_EQ(points + scan.skipped, GetParam().records);
  EXPECT_GT(points, GetParam().records / 3);
  if (!GetParam().has_gaps) {
    EXPECT_EQ(scan.skipped, 0);
  }
  for (const ScanRecord& record : scan.records) {
    ASSERT_EQ(record.has_axis, GetParam().has_axis);
    ASSERT_TRUE(record.point.position.allFinite());
    ASSERT_NEAR(record.point.axis.norm(), record.has_axis ? 1 : 0, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Clouds, DataScans,
    ::testing::Values(
        DataScan{"cgal_points/cube.pwn", 50'000, true}, DataScan{"cgal_points/oni.pwn", 1435, true},
        DataScan{"cgal_points/building.xyz", 8075, true},
        DataScan{"cgal_points/fin90_with_PCA_normals.xyz", 757, true},
        DataScan{"cgal_points/sphere_20k_normal.xyz", 21'000, true},
        DataScan{"cgal_points/poste_france.xyz", 9031, false},
        DataScan{"cgal_points/radar.xyz", 20'950, false}, DataScan{"cgal_points/ball.ply", 31'374, true},
        DataScan{"cgal_points/cylinder_no_noise.ply", 1523, true},
        DataScan{"cgal_points/cylinders.ply", 1813, true}, DataScan{"cgal_points/spheres.ply", 5969, true},
        DataScan{"cgal_points/hippo1.ply", 6104, true}, DataScan{"cgal_points/b9.ply", 22'300, false},
        DataScan{"cgal_points/b9_training.ply", 22'300, false}, DataScan{"pcl_test/bun0.pcd", 397, true},
        DataScan{"pcl_test/lamppost.pcd", 1771, true}, DataScan{"pcl_test/milk.pcd", 13'704, true},
        DataScan{"pcl_test/noisy_slice_displaced.pcd", 3782, true},
        DataScan{"pcl_test/sac_plane_test.pcd", 3283, true, true},
        DataScan{"pcl_test/milk_cartoon_all_small_clorox.pcd", 307'200, true, true},
        DataScan{"pcl_test/office1.pcd", 307'200, true, true},
        DataScan{"synpeb_sample/test_100.pcd", 10'000, true}),
    [](const auto& tested) {
      std::string name = tested.param.path.substr(tested.param.path.find('/') + 1);
      std::replace_if(
          name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
      return name;
    });

/// Organised clouds with labels: by their authors a pixel has the label 0 just where it has no point.
TEST(DataLabels, StayWithThePixelsOfEveryKinectImage) {
  int images = 0;
  const std::filesystem::path folder = data_folder() / "pcl_mOSD";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".pcd") continue;
    LabelSource source(entry.path().string(), "label");
    long records = 0, none = 0, zero = 0;
    for (std::int64_t label = 0; source.next(label); ++records) {
      none += label == -1;
      zero += label == 0;
    }
    EXPECT_EQ(records, 640 * 480) << entry.path();
    EXPECT_GT(none, 0) << entry.path();
    EXPECT_EQ(zero, 0) << entry.path();
    ++images;
  }
  EXPECT_GT(images, 0);
}

TEST(DataLabels, PlanesOfASimulatedRoom) {
  const std::filesystem::path path = data_folder() / "synpeb_sample/test_100.pcd";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  LabelSource source(path.string(), "intensity");
  std::set<std::int64_t> planes;
  for (std::int64_t label = 0; source.next(label);) {
    if (label >= 10) planes.insert(label);
  }
  EXPECT_EQ(planes.size(), 12u);
}

}  // namespace
}  // namespace limpet::io::testing
