// Copyright the limpet authors. GPL-3.0-or-later.
//
// `limpet draw` of recorded runs, as scripts see it.
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace limpet::app {
namespace {

class DrawRun : public testing::ProgramTest {
 protected:
  /// A run; its name.
  std::string record(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "follow");
    arguments.insert(arguments.end(), {"-q", "-o", path("m.limpet"), "--record", path("r.run")});
    arguments.insert(arguments.end(), {"--json", path("m.json")});
    const auto result = run(arguments);
    EXPECT_LE(result.code, 1) << result.err;
    return path("r.run");
  }
  /// The picture of it.
  std::string svg(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"draw", path("r.run"), "-q", "-o", path("p.svg")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto result = run(arguments);
    EXPECT_EQ(result.code, 0) << result.err;
    return read(path("p.svg"));
  }
  static bool has(const std::string& picture, const std::string& label) {
    return picture.find(">" + label + "<") != std::string::npos;
  }
};

TEST_F(DrawRun, ShowsStages) {
  record({"octahedron"});
  const auto sets = nlohmann::json::parse(read(path("m.json")))["sets"].get<int>();
  const std::string four = svg({});
  for (int i = 1; i <= 3; ++i) EXPECT_TRUE(has(four, std::to_string(sets * i / 4) + " sets")) << i;
  EXPECT_TRUE(has(four, "r: complete, " + std::to_string(sets) + " sets"));
  EXPECT_NE(four.find("path where it ends"), std::string::npos);
  const std::string one = svg({"--stages", "1"});
  EXPECT_EQ(one.find(" sets</text>"), one.rfind(" sets</text>"));
  EXPECT_EQ(run({"draw", path("r.run"), "-q", "-o", path("p.png")}).code, 0);
  EXPECT_EQ(read(path("p.png")).substr(1, 3), "PNG");
}

TEST_F(DrawRun, ShowsTheModelAfterAnySet) {
  const std::string file = record({"cube", "--max-sets", "40"});
  const std::string at = svg({"--at", "20"});
  EXPECT_TRUE(has(at, "r: after 20 sets"));
  EXPECT_FALSE(has(at, "10 sets"));
  EXPECT_FALSE(has(at, "robot")) << "the point robot has no links";
  EXPECT_TRUE(has(svg({"--at", "40"}), "r: after 40 sets"));
  expect_refused(run({"draw", file, "--at", "41", "-o", path("p.svg")}), "--at 41");
  expect_refused(run({"draw", file, "--at", "0", "-o", path("p.svg")}), "--at");
  expect_refused(run({"draw", file, "--at", "4", "--stages", "2", "-o", path("p.svg")}), "--stages");
}

TEST_F(DrawRun, ShowsAnArmWithItsRaysAndSwitches) {
  // As in the thesis links come nearer, so that their switches see something.
  record({"L", "--robot", "arm", "--link-sensors", "switches", "--avoidance", "thesis", "--max-sets", "150"});
  const std::string end = svg({"--stages", "1"});
  for (const std::string label : {"robot", "reading", "sensor that met nothing", "switch that does not"})
    EXPECT_TRUE(has(end, label)) << label;
  bool any_sees = false;  // at some set on the way
  for (int set = 10; set <= 150 && !any_sees; set += 10)
    any_sees = has(svg({"--at", std::to_string(set)}), "switch that sees something");
  EXPECT_TRUE(any_sees);
  const std::string bare = svg({"--stages", "1", "--no-robot"});
  EXPECT_FALSE(has(bare, "robot"));
  EXPECT_FALSE(has(bare, "reading"));
  EXPECT_NE(svg({"--at", "75"}), svg({"--at", "76"})) << "it stands elsewhere then";
}

TEST_F(DrawRun, RefusesWhatIsDamagedAndWarnsOfWhatWasCutShort) {
  const std::string text = read(record({"cube", "--max-sets", "3"}));
  expect_refused(run({"draw", write("d.run", text.substr(0, 300)), "-o", path("p.png")}), "d.run: line ");
  const auto result =
      run({"draw", write("short.run", text.substr(0, text.size() - 20)), "-o", path("p.png")});
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.err.find("cut short"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace limpet::app
