// Copyright the limpet authors. GPL-3.0-or-later.
//
// `limpet compare --labels`: what the model found against true labels, point by point.
#include <limpet/survey/random.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "program.hpp"

namespace limpet::app {
namespace {

class CompareLabels : public testing::ProgramTest {
 protected:
  nlohmann::json score(const std::vector<std::string>& arguments, int code = 0) const {
    std::vector<std::string> all{"compare", "--labels", "--json", "-"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const auto result = run(all);
    EXPECT_EQ(result.code, code) << result.err;
    return nlohmann::json::parse(result.out);
  }
};

TEST_F(CompareLabels, FacesOfACubeAreFound) {
  const auto cube = scan("c.ply", "cube", 20000, {"--noise", "0.001", "--outliers", "0.01", "--faces"});
  ASSERT_EQ(run({"model", cube, "-o", path("m.limpet"), "--labels", path("l.txt")}).code, 0);
  const auto json = score({path("l.txt"), cube, "--polygons", path("m.limpet"), "--min-correct", "1"});
  EXPECT_EQ(json["true_regions"], 6);
  EXPECT_EQ(json["correct"], 6);
  EXPECT_EQ(json["missed"], 0);
  EXPECT_GT(json["purity"], 0.95);
  EXPECT_GT(json["covered"], 0.99);
  EXPECT_EQ(json["truth"].size(), 6u);
  for (const auto& region : json["truth"]) {
    EXPECT_EQ(region["fate"], "correct");
    EXPECT_EQ(region["found"][0], region["main_found"]);
    EXPECT_GT(region["covered_by_main"], 0.98);
  }
  for (const std::string key :
       {"records", "points", "points_left_out", "overlap", "found_regions", "noise", "over_segmented",
        "under_segmented", "merged", "pieces", "correct_share", "within_bounds", "found"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
}

/// An organised cloud of two planes, left and right, with pixels that returned nothing: a line of --labels is
/// a pixel.
TEST_F(CompareLabels, LabelsStayWithTheirPixels) {
  constexpr int kWidth = 60, kHeight = 40;
  const std::uint64_t seed = 7;
  RecordProperty("seed", std::to_string(seed));
  survey::Random random(seed);
  std::string scan_text =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z region\nSIZE 4 4 4 4\nTYPE F F F I\n"
      "COUNT 1 1 1 1\nWIDTH 60\nHEIGHT 40\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2400\nDATA ascii\n";
  std::vector<int> truth;
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const bool left = column < kWidth / 2, gone = random.below(5) == 0;
      truth.push_back(gone ? 0 : left ? 1 : 2);
      scan_text += gone ? "nan nan nan 0\n"
                        : std::to_string(0.01 * column) + " " + std::to_string(0.01 * row) +
                              (left ? " 1 1\n" : " 1.3 2\n");
    }
  }
  const std::string cloud = write("o.pcd", scan_text);
  const auto result = run({"model", cloud, "-o", path("m.limpet"), "--labels", path("l.txt"), "--resolution",
                           "0.03", "--noise", "0.0005"});
  ASSERT_EQ(result.code, 0) << result.err;
  std::istringstream lines(read(path("l.txt")));
  std::vector<long> labels;
  for (long label = 0; lines >> label;) labels.push_back(label);
  ASSERT_EQ(labels.size(), truth.size());
  std::set<long> of_left, of_right;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] == 0) {
      EXPECT_EQ(labels[i], 0) << "pixel " << i;
    } else {
      (truth[i] == 1 ? of_left : of_right).insert(labels[i]);
    }
  }
  EXPECT_EQ(of_left.size(), 1u);
  EXPECT_EQ(of_right.size(), 1u);
  EXPECT_NE(of_left, of_right);
  const auto json = score({path("l.txt"), cloud});
  EXPECT_EQ(json["records"], 2400);
  EXPECT_EQ(json["correct"], 2);
  EXPECT_EQ(json["purity"], 1.0);
  // The same from a list, and by the name of the column.
  std::string list;
  for (const int label : truth) list += std::to_string(label) + "\n";
  EXPECT_EQ(score({path("l.txt"), write("truth.txt", list)})["correct"], 2);
  EXPECT_EQ(score({path("l.txt"), cloud, "--column", "region", "--none", "2"})["true_regions"], 1);
}

TEST_F(CompareLabels, Bounds) {
  const auto found = write("found.txt", "1\n1\n1\n2\n2\n0\n"),
             truth = write("truth.txt", "5\n5\n5\n6\n7\n7\n");
  auto json = score({found, truth});
  EXPECT_EQ(json["true_regions"], 3);
  EXPECT_EQ(json["correct"], 1);
  EXPECT_EQ(json["missed"], 2);
  EXPECT_EQ(json["noise"], 1);
  json = score({found, truth, "--min-correct", "0.5"}, 1);
  EXPECT_EQ(json["within_bounds"], false);
  score({found, truth, "--min-correct", "0.33"});
  json = score({found, truth, "--min-true", "2", "--none", "6..9,-5"});
  EXPECT_EQ(json["true_regions"], 1);
}

TEST_F(CompareLabels, BadInput) {
  const auto found = write("found.txt", "1\n1\n1\n"), truth = write("truth.txt", "5\n5\n5\n5\n");
  expect_refused(run({"compare", "--labels", found, truth}), "found.txt: has only 3 labels");
  expect_refused(run({"compare", "--labels", truth, found}), "found.txt: has only 3 labels");
  expect_refused(run({"compare", "--labels", found, path("none.txt")}), "none.txt");
  expect_refused(run({"compare", "--labels", found, path("")}), "folder");
  expect_refused(run({"compare", "--labels", write("e.txt", ""), write("f.txt", "")}), "no label");
  expect_refused(run({"compare", "--labels", found, write("zeros.txt", "0\n0\n0\n")}), "no region");
  expect_refused(run({"compare", "--labels", found, found, "--none", "1.."}), "--none");
  expect_refused(run({"compare", "--labels", found, found, "--none", "5..3"}), "--none");
  expect_refused(run({"compare", "--labels", found, found, "--overlap", "0.5"}), "--overlap");
  expect_refused(run({"compare", "--labels", found, found, "--overlap", "2"}), "--overlap");
  expect_refused(run({"compare", "--labels", found, found, "--faces", "exact"}), "--labels");
  expect_refused(run({"compare", "--labels", found, found, "--polygons", found}), "found.txt");
  expect_refused(run({"compare", found, found, "--overlap", "0.9"}), "--labels");
  expect_refused(run({"compare", "--labels", "-", "-"}), "only once");
}

}  // namespace
}  // namespace limpet::app
