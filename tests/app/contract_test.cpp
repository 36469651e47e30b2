// Copyright the limpet authors. GPL-3.0-or-later.
//
// What scripts rely on: keys, exit codes, the same bytes.
#include <limpet/model/rules.hpp>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace limpet::app {
namespace {

using Contract = testing::ProgramTest;

TEST_F(Contract, VersionSaysTheArithmetic) {
  const auto result = run({"--version"});
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.out.find("exact"), std::string::npos) << result.out;
}

TEST_F(Contract, HelpOfEveryCommand) {
  for (const std::string command : {"model", "follow", "scan", "check", "compare", "draw"}) {
    const auto result = run({command, "--help"});
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.out.find("--seed"), std::string::npos) << result.out;
  }
}

TEST_F(Contract, SummaryHasItsKeys) {
  const auto result = run({"model", scan("c.ply", "cube", 5000), "-o", path("m.limpet"), "--json", "-",
                           "--check-every", "40", "--seed", "3"});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  for (const std::string key : {"points",
                                "points_loose",
                                "points_refused",
                                "points_expired",
                                "points_confirmed",
                                "sets",
                                "segments",
                                "polygons",
                                "holes",
                                "shared_edges",
                                "open_edges",
                                "open_because",
                                "suggested_angle_deg",
                                "corner_vertices",
                                "closed",
                                "seconds",
                                "points_per_second",
                                "peak_memory_bytes",
                                "violations",
                                "resolution",
                                "noise",
                                "order",
                                "order_disk_bytes"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["violations"], 0);
  EXPECT_EQ(json["polygons"], 6);
  EXPECT_EQ(json["sets"], (json["points"].get<int>() + 25) / 26);
  EXPECT_GT(json["peak_memory_bytes"], 1'000'000);
}

TEST_F(Contract, SameInputSameBytes) {
  const auto scan_file = scan("s.ply", "step_hole", 20000, {"--noise", "0.003", "--outliers", "0.01"});
  const auto outputs = [&](const std::string& name) {
    return std::vector<std::string>{"-o", path(name + ".limpet"), "-o",       path(name + ".off"),
                                    "-o", path(name + ".ply"),    "-o",       path(name + ".stl"),
                                    "-o", path(name + ".obj"),    "--labels", path(name + ".txt")};
  };
  const auto model = [&](const std::string& name, const testing::Surroundings& around, bool stream) {
    std::vector<std::string> arguments{"model", stream ? "-" : scan_file, "--noise",
                                       "0.003", "--resolution",           "0.05"};
    for (const auto& more : outputs(name)) arguments.push_back(more);
    EXPECT_EQ(run(arguments, around).code, 0);
  };
  model("a", {}, false);
  model("b", {"/", {{"LC_ALL", "de_DE.UTF-8"}, {"LANG", "tr_TR.UTF-8"}, {"TZ", "UTC-5"}}, ""}, false);
  model("c", {path(""), {{"LC_ALL", "C"}}, scan_file}, true);
  for (const std::string kind : {".limpet", ".off", ".ply", ".stl", ".txt"}) {
    const std::string a = read(path("a" + kind));
    EXPECT_FALSE(a.empty()) << kind;
    EXPECT_EQ(a, read(path("b" + kind))) << kind;
    EXPECT_EQ(a, read(path("c" + kind))) << kind;
  }
}

TEST_F(Contract, ScanIsTheSameForTheSameSeed) {
  EXPECT_EQ(read(scan("a.ply", "L", 3000, {"--noise", "0.01", "--seed", "5"})),
            read(scan("b.ply", "L", 3000, {"--noise", "0.01", "--seed", "5"})));
  EXPECT_NE(read(path("a.ply")), read(scan("c.ply", "L", 3000, {"--noise", "0.01", "--seed", "6"})));
}

TEST_F(Contract, TooFewPointsAreSaid) {
  const auto result = run(
      {"model", scan("c.ply", "cube", 2000), "-o", path("m.limpet"), "--resolution", "0.02", "--noise", "0"});
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.err.find("too few"), std::string::npos) << result.err;
  EXPECT_EQ(result.error_lines(), 1);
}

TEST_F(Contract, QuietSaysNothing) {
  const auto result = run({"model", scan("c.ply", "cube", 5000), "-o", path("m.limpet"), "--quiet"});
  EXPECT_EQ(result.out + result.err, "");
}

TEST_F(Contract, CheckNamesTheBrokenLaw) {
  ASSERT_EQ(run({"model", scan("c.ply", "cube", 5000), "-o", path("m.limpet")}).code, 0);
  std::string text = read(path("m.limpet"));
  const auto at = text.find("\ncycle ");
  const auto first = text.find('\n', at + 1) + 1;
  const auto second = text.find('\n', first) + 1;
  const auto third = text.find('\n', second) + 1;
  // The second vertex comes to lie on the first.
  const std::string a = text.substr(first, second - first), b = text.substr(second, third - second);
  const auto place = [](const std::string& line) { return line.find(' ', line.find(' ') + 1); };
  text.replace(second, place(b), a.substr(0, place(a)));
  const auto result = run({"check", write("broken.limpet", text)});
  EXPECT_EQ(result.code, 1);
  EXPECT_NE(result.out.find("segment"), std::string::npos) << result.out;
}

TEST_F(Contract, CompareOutsideItsBounds) {
  ASSERT_EQ(run({"model", scan("c.ply", "cube", 5000), "-o", path("m.limpet")}).code, 0);
  EXPECT_EQ(run({"compare", path("m.limpet"), "cube", "--max-distance", "0.1", "--faces", "exact"}).code, 0);
  EXPECT_EQ(run({"compare", path("m.limpet"), "cube", "--max-distance", "1e-9"}).code, 1);
  EXPECT_EQ(run({"compare", path("m.limpet"), "L", "--faces", "exact"}).code, 1);
}

TEST_F(Contract, EveryRuleIsDocumented) {
  const std::string page = read(LIMPET_SOURCE_DIR "/docs/rules.md");
  for (const auto& rule : model::Rules::names()) {
    EXPECT_NE(page.find("| `" + rule + "` |"), std::string::npos) << rule;
  }
}

}  // namespace
}  // namespace limpet::app
