// Copyright the limpet authors. GPL-3.0-or-later.
//
// A scan is put in order before it is modelled; nobody but the model notices.
#include <algorithm>
#include <map>
#include <sstream>

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace limpet::app {
namespace {

using Words = std::vector<std::string>;

class Order : public testing::ProgramTest {
 protected:
  Words model(const std::string& scan, const std::string& name, const Words& more = {}) const {
    Words words{"model",
                scan,
                "-q",
                "-o",
                path(name + ".limpet"),
                "--labels",
                path(name + ".txt"),
                "--json",
                path(name + ".json"),
                "--resolution",
                "0.05",
                "--noise",
                "0.001"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  nlohmann::json summary(const std::string& name) const {
    return nlohmann::json::parse(read(path(name + ".json")));
  }
};

TEST_F(Order, LabelsAreInTheOrderOfTheScan) {
  std::istringstream rows(read(scan("c.xyz", "cube", 20'000, {"--noise", "0.001"})));
  std::string text;
  std::vector<std::array<double, 3>> records;  // of those that are no point: not finite
  for (std::string row; std::getline(rows, row);) {
    text += row + "\n";
    if (row.starts_with('#')) continue;
    std::array<double, 3> at{};
    std::istringstream(row) >> at[0] >> at[1] >> at[2];
    records.push_back(at);
    if (records.size() % 7 != 0) continue;
    text += "nan nan nan 1 0 0\n";
    records.push_back({NAN, NAN, NAN});
  }
  for (const std::string order : {"curve", "arrival"}) {
    ASSERT_EQ(run(model(write("d.xyz", text), "m", {"--order", order})).code, 0);
    std::istringstream lines(read(path("m.txt")));
    std::map<int, std::array<std::pair<double, double>, 3>> extent;  // of each label's points
    std::size_t count = 0, in_polygons = 0;
    for (int label; lines >> label; ++count) {
      ASSERT_LT(count, records.size());
      const auto& at = records[count];
      ASSERT_TRUE(label == 0 || !std::isnan(at[0])) << "record " << count;
      if (label == 0) continue;
      ++in_polygons;
      auto& box = extent
                      .try_emplace(label, std::array{std::pair{at[0], at[0]}, std::pair{at[1], at[1]},
                                                     std::pair{at[2], at[2]}})
                      .first->second;
      for (std::size_t i = 0; i < 3; ++i)
        box[i] = {std::min(box[i].first, at[i]), std::max(box[i].second, at[i])};
    }
    EXPECT_EQ(count, records.size()) << order;
    EXPECT_GT(in_polygons, 19'000u) << order;
    for (const auto& [label, box] : extent) {  // the faces of a cube are thin along an axis
      const auto thickness = [&](std::size_t i) { return box[i].second - box[i].first; };
      EXPECT_LT(std::min({thickness(0), thickness(1), thickness(2)}), 0.02) << order << " " << label;
    }
  }
}

TEST_F(Order, IsTheSameThroughTemporaryFiles) {
  const std::string scan_file = scan("s.ply", "step_hole", 60'000, {"--noise", "0.002"});
  ASSERT_EQ(run(model(scan_file, "memory")).code, 0);
  ASSERT_EQ(run(model(scan_file, "disk", {"--order-memory", "1"})).code, 0);
  EXPECT_EQ(summary("memory")["order_disk_bytes"], 0);
  EXPECT_GT(summary("disk")["order_disk_bytes"], 3'000'000);
  EXPECT_EQ(summary("disk")["order"], "curve");
  for (const std::string end : {".limpet", ".txt"})
    EXPECT_TRUE(read(path("memory" + end)) == read(path("disk" + end))) << end;
}

TEST_F(Order, SaysWhenThereIsNoPlaceForTemporaryFiles) {
  const std::string scan_file = scan("s.ply", "cube", 20'000);
  expect_refused(run(model(scan_file, "m", {"--order-memory", "1"}), {"", {{"TMPDIR", "/nonexistent"}}, ""}),
                 "TMPDIR");
  EXPECT_FALSE(exists("m.limpet"));
  EXPECT_EQ(run(model(scan_file, "m"), {"", {{"TMPDIR", "/nonexistent"}}, ""}).code, 0)
      << "none are needed for so few points";
}

TEST_F(Order, OfRowsMakesNoDifferenceToADenseScan) {
  // In the order of its rows, a dense scan of this block is not closed (docs/order.md).
  const std::string scan_file = scan("s.ply", "step_hole", 100'000, {"--noise", "0.02", "--seed", "7"});
  Words words = model(scan_file, "m");
  std::replace(words.begin(), words.end(), std::string("0.05"), std::string("0.1"));
  std::replace(words.begin(), words.end(), std::string("0.001"), std::string("0.02"));
  ASSERT_EQ(run(words).code, 0);
  EXPECT_EQ(summary("m")["closed"], true);
  EXPECT_EQ(summary("m")["polygons"], 12);
}

}  // namespace
}  // namespace limpet::app
