// Copyright the limpet authors. GPL-3.0-or-later.
//
// Rooms as a scanner on a tripod sees them: dense near, thin far away.
#include <algorithm>
#include <sstream>

#include "program.hpp"

namespace limpet::app {
namespace {

using Words = std::vector<std::string>;

class TurningScan : public testing::ProgramTest {
 protected:
  std::string room(int seed, const Words& more = {}) const {
    const std::string scan = path("room" + std::to_string(seed) + ".ply");
    Words words{"scan",         "room:" + std::to_string(seed) + ":3:2",
                "-o",           scan,
                "--points",     "60000",
                "--order",      "turning",
                "--noise",      "0.001",
                "--seed",       std::to_string(seed),
                "--faces",      "--viewpoint",
                "2.05,2.1,1.6", "--viewpoint",
                "4.1,1.9,1.6",  "-q"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run(words).code, 0);
    return scan;
  }
};

TEST_F(TurningScan, ItsFacesAreFoundAndNothingElse) {
  for (const int seed : {2, 3, 4}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::string scan = room(seed, {"--ranges"});
    const auto modelled = run({"model", scan, "-o", path("m.limpet"), "--labels", path("m.txt")});
    ASSERT_EQ(modelled.code, 0);
    const auto compared = run({"compare", path("m.txt"), scan, "--labels", "--polygons", path("m.limpet"),
                               "--min-true", "20", "--min-correct", "0.92"});
    EXPECT_EQ(compared.code, 0) << compared.out;
    const auto checked = run({"check", path("m.limpet"), "--scan", scan, "-q"});
    EXPECT_EQ(checked.code, 0) << checked.out << checked.err;
    // What was chosen is typed again: the same bytes.
    const std::string chosen = "chosen from the scan:";
    const std::size_t at = modelled.out.find(chosen);
    ASSERT_NE(at, std::string::npos);
    std::istringstream line(
        modelled.out.substr(at + chosen.size(), modelled.out.find('\n', at) - at - chosen.size()));
    Words again{"model", scan, "-o", path("again.limpet"), "-q"};
    for (std::string word; line >> word;) again.push_back(word);
    EXPECT_NE(again[6].find(','), std::string::npos) << "a resolution that grows";
    ASSERT_EQ(run(again).code, 0);
    EXPECT_EQ(read(path("again.limpet")), read(path("m.limpet")));
  }
}

/// An edge that is near a line at one end, and at the other within what the strip along the line would be if
/// it were as wide there, was once cut 4e10 away; the oracle found it (exit code 1).
TEST_F(TurningScan, EdgesAreCutWhereTheyLeaveTheStripAlongALine) {
  EXPECT_EQ(run({"model", room(1, {"--ranges"}), "-o", path("m.limpet"), "-q"}).code, 0);
}

TEST_F(TurningScan, AResolutionThatGrowsTooLittleIsToldWithOneThatWouldDo) {
  const std::string scan = room(2, {"--ranges"});
  const auto warning_of = [&](const std::string& resolution) {
    return run({"model", scan, "-o", path("m.limpet"), "-q", "--resolution", resolution}).err;
  };
  const std::string warning = warning_of("0.001,0.001");
  const std::string before = "--resolution ", after = " would do";
  const std::size_t from = warning.find(before), to = warning.find(after);
  ASSERT_NE(from, std::string::npos) << warning;
  ASSERT_NE(to, std::string::npos) << warning;
  EXPECT_EQ(warning_of(warning.substr(from + before.size(), to - from - before.size())), "");
}

TEST_F(TurningScan, AResolutionThatGrowsNeedsRangesAndBounds) {
  const std::string silent = room(1);
  const auto refused = [&](const std::string& resolution) {
    const auto result = run({"model", silent, "-o", path("m.limpet"), "--resolution", resolution});
    EXPECT_EQ(result.code, 2) << resolution;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    return result.err;
  };
  EXPECT_NE(refused("0.01,0.05").find("does not say from how far"), std::string::npos);
  EXPECT_NE(refused("0.01,0.3").find("0 to 0.25"), std::string::npos);
  EXPECT_NE(refused("0.01,-0.1").find("0 to 0.25"), std::string::npos);
  EXPECT_NE(refused("0,0.1").find("greater than 0"), std::string::npos);
  EXPECT_NE(refused("0.1,0.1,0.1").find("give a"), std::string::npos);
  EXPECT_EQ(run({"model", silent, "-o", path("m.limpet"), "--resolution", "0.1,0", "-q"}).code, 0);
}

}  // namespace
}  // namespace limpet::app
