// Copyright the limpet authors. GPL-3.0-or-later.
//
// A scan in which readings occur several times is modelled as the scan without their copies.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "program.hpp"

namespace limpet::app {
namespace {

class CopiesTest : public testing::ProgramTest {
 protected:
  /// The rows of a scan of a cube, and the comments before them.
  void make(long points) {
    std::istringstream text(read(scan("cube.xyz", "cube", points, {"--noise", "0.002"})));
    comments_.clear();
    rows_.clear();
    for (std::string line; std::getline(text, line);) {
      if (line.starts_with('#')) {
        comments_ += line + "\n";
      } else {
        rows_.push_back(line + "\n");
      }
    }
  }

  /// The names of three scans: copies in a row, one scan after the other, and shuffled.
  std::vector<std::string> tripled() const {
    constexpr std::uint64_t kSeed = 20260713;
    RecordProperty("seed", std::to_string(kSeed));
    std::vector<std::string> in_a_row, after;
    for (const std::string& row : rows_) in_a_row.insert(in_a_row.end(), 3, row);
    for (int i = 0; i < 3; ++i) after.insert(after.end(), rows_.begin(), rows_.end());
    std::vector<std::string> shuffled = after;
    std::mt19937_64 random(kSeed);
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    return {written("row.xyz", in_a_row), written("after.xyz", after), written("shuffled.xyz", shuffled)};
  }

 private:
  std::string written(const std::string& name, const std::vector<std::string>& rows) const {
    std::string text = comments_;
    for (const std::string& row : rows) text += row;
    return write(name, text);
  }

  std::string comments_;
  std::vector<std::string> rows_;
};

TEST_F(CopiesTest, ATripledCubeIsACube) {
  for (const long points : {5'000, 50'000}) {
    make(points);
    for (const std::string& scan : tripled()) {
      const auto result = run({"model", scan, "-o", path("m.limpet"), "--json", path("s.json")});
      ASSERT_EQ(result.code, 0) << scan << ": " << result.err;
      EXPECT_EQ(result.err, "") << scan;
      const auto summary = nlohmann::json::parse(read(path("s.json")));
      EXPECT_EQ(summary["polygons"], 6) << scan;
      EXPECT_EQ(summary["holes"], 0) << scan;
      EXPECT_EQ(summary["open_edges"], 0) << scan;
    }
  }
}

/// Two points per square of the resolution are too few, also where each is there three times.
TEST_F(CopiesTest, CopiesDoNotMakeAScanDenser) {
  make(5'000);
  for (const std::string& scan : tripled()) {
    const auto result = run({"model", scan, "-o", path("m.limpet"), "--resolution", "0.05"});
    EXPECT_NE(result.err.find("warning: 2.0 points per square"), std::string::npos) << scan << result.err;
  }
}

}  // namespace
}  // namespace limpet::app
