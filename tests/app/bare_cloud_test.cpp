// Copyright the limpet authors. GPL-3.0-or-later.
//
// `limpet model` of clouds without axes, normals or viewpoint.
#include <limpet/simulation/mesh.hpp>
#include <sstream>

#include "program.hpp"

namespace limpet::app {
namespace {

class BareCloud : public testing::ProgramTest {
 protected:
  /// The same scan without its axes, with a record that is no point before every hundredth one.
  std::string bare(const std::string& name, const std::string& shape, long points) const {
    std::istringstream lines(read(scan("whole.xyz", shape, points, {"--noise", "0.001"})));
    std::string text, line;
    for (long i = 0; std::getline(lines, line);) {
      if (line.starts_with('#')) continue;
      if (i++ % 100 == 0) text += "nan 0 0\n";
      std::size_t end = 0;
      for (int k = 0; k < 3; ++k) end = line.find(' ', end + 1);
      text += line.substr(0, end) + "\n";
    }
    return write(name, text);
  }
  std::vector<std::string> model(const std::string& from, const std::string& name) const {
    return {"model",        from,
            "-o",           path(name + ".limpet"),
            "-o",           path(name + ".off"),
            "--noise",      "0.001",
            "--resolution", "0.05",
            "--labels",     path(name + ".txt"),
            "--json",       path(name + ".json")};
  }
};

TEST_F(BareCloud, IsOrientedByItsNeighboursWithAWarning) {
  const std::string cloud = bare("bare.xyz", "cube", 20'000);
  const auto result = run(model(cloud, "a"));
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.error_lines(), 1) << result.err;
  EXPECT_NE(result.err.find("limpet: warning: "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("--viewpoint"), std::string::npos) << result.err;
  EXPECT_NE(read(path("a.json")).find("\"axes_guessed\": true"), std::string::npos);
  EXPECT_EQ(run({"compare", path("a.limpet"), "cube", "--faces", "exact", "--max-distance", "0.06"}).code, 0);
  // Kept as it stands, the mesh has the cube's volume, and not minus that: its faces look outward.
  EXPECT_NEAR(simulation::signed_volume(simulation::load_mesh(path("a.off"), simulation::kPlanarity, true)),
              1, 0.1);
  const std::string labels = read(path("a.txt"));
  const std::string records = read(cloud);
  EXPECT_EQ(std::count(labels.begin(), labels.end(), '\n'), std::count(records.begin(), records.end(), '\n'));
  EXPECT_EQ(labels.substr(0, 2), "0\n");
}

/// Coordinates to the millimetre, and faces along the axes: few different ones, which says nothing of the
/// noise.
TEST_F(BareCloud, RoundedCoordinatesAreNoNoise) {
  std::string text;
  for (int i = 0; i < 10'000; ++i) {
    const int column = i % 100, row = i / 100;
    char line[64];
    std::snprintf(line, sizeof line, "0.1 %.3f %.3f\n", 0.013 * column, 0.013 * row);
    text += line;
  }
  const auto result = run({"model", write("wall.xyz", text), "-o", path("m.limpet"), "--json", "-"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("\"polygons\": 1,"), std::string::npos) << result.out;
}

TEST_F(BareCloud, FromStandardInputToo) {
  const std::string cloud = bare("bare.xyz", "step_hole", 20'000);
  ASSERT_EQ(run(model(cloud, "file")).code, 0);
  const auto result = run(model("-", "pipe"), {"", {}, cloud});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("standard input says neither"), std::string::npos) << result.err;
  EXPECT_EQ(read(path("file.limpet")), read(path("pipe.limpet")));
  EXPECT_EQ(read(path("file.txt")), read(path("pipe.txt")));
}

TEST_F(BareCloud, DamageIsReportedAfterWhatWasRead) {
  const std::string cloud = bare("bare.xyz", "cube", 20'000);
  const std::string damaged = write("damaged.xyz", read(cloud) + "1 2\n");
  for (const bool stream : {false, true}) {
    const auto result = run(model(stream ? "-" : damaged, "m"), {"", {}, damaged});
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find("what was read before it is modelled"), std::string::npos) << result.err;
    EXPECT_EQ(run({"compare", path("m.limpet"), "cube", "--faces", "exact"}).code, 0);
  }
}

/// Normals of either sign, as estimated and never oriented.
TEST_F(BareCloud, NormalsThatAreNotOrientedCanBePassedOver) {
  std::istringstream lines(read(bare("bare.xyz", "cube", 20'000)));
  std::string text, line;
  for (long i = 0; std::getline(lines, line); ++i)
    text += line + (i % 2 == 0 ? " 0 0.6 0.8\n" : " 0 -0.6 -0.8\n");
  auto arguments = model(write("turned.xyz", text), "m");
  arguments.emplace_back("--orient");
  const auto result = run(arguments);
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "") << "asked for, so no warning";
  EXPECT_EQ(run({"compare", path("m.limpet"), "cube", "--faces", "exact", "--max-distance", "0.06"}).code, 0);
  arguments.insert(arguments.end(), {"--viewpoint", "0,0,9"});
  expect_refused(run(arguments), "--viewpoint");
}

/// A hundred thousand points are held in memory.
TEST_F(BareCloud, NowhereToSpool) {
  const std::string cloud = bare("bare.xyz", "cube", 120'000);
  expect_refused(run(model("-", "m"), {"", {{"TMPDIR", "/nonexistent"}}, cloud}), "TMPDIR");
}

}  // namespace
}  // namespace limpet::app
