// Copyright the limpet authors. GPL-3.0-or-later.
//
// `limpet follow` as scripts see it: keys, exit codes, what it refuses.
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace limpet::app {
namespace {

class Follow : public testing::ProgramTest {
 protected:
  testing::Result follow(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "follow");
    arguments.insert(arguments.end(), {"-q", "-o", path("m.limpet")});
    return run(arguments);
  }
};

/// The thesis's arm, its links kept off: of a cube that it can feel all round nothing is missed or touched.
TEST_F(Follow, AnArmModelsACubeAndTouchesNothing) {
  const auto result = follow({"cube", "--robot", "arm", "--record", path("arm.run"), "--json", "-"});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["ended"], "complete");
  EXPECT_EQ(json["closed"], true);
  EXPECT_EQ(json["polygons"], 6);
  EXPECT_EQ(json["collisions"], 0);
  EXPECT_GT(json["clearance_links"], 0);
  EXPECT_GT(json["clearance_of_itself"], 0);
  EXPECT_GE(json["clearance_links_model"].get<double>(), 0);
  const std::string model = read(path("m.limpet"));
  EXPECT_EQ(run({"follow", "--replay", path("arm.run"), "-q", "-o", path("again.limpet")}).code, 0);
  EXPECT_EQ(read(path("again.limpet")), model);
}

/// Of the underside of a cube on the ground: that a search finds no posture proves nothing.
TEST_F(Follow, WhatCannotBeToldIsNotCountedAsOutOfReach) {
  const auto shares = [&](const std::string& scene) {
    const auto result = follow({scene, "--max-sets", "30", "--json", "-"});
    EXPECT_LE(result.code, 1) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    return std::pair(json["reachable"].get<double>(), json["doubtful"].get<double>());
  };
  EXPECT_EQ(shares("cube"), std::pair(1.0, 0.0));
  const std::string scene = "[world]\nshape = \"cube\"\n[robot]\nkind = \"arm\"\nobject = \"on_ground\"\n";
  const auto [reachable, doubtful] = shares(write("ground.toml", scene));
  EXPECT_GT(doubtful, 0.05);
  EXPECT_GT(reachable, 0.5);
  EXPECT_NEAR(reachable + doubtful, 1, 1e-9) << "none is out of reach by the links' lengths";
}

/// A run with proximity switches on the links ends, however, and is the same each time.
TEST_F(Follow, AnArmWithSwitchesEndsAndDoesTheSameAgain) {
  for (const std::string scene : {"cube", "octahedron"})
    for (const std::string avoidance : {"programme", "thesis"}) {
      SCOPED_TRACE(scene);
      SCOPED_TRACE(avoidance);
      const auto once = [&](const std::string& name) {
        const auto result = follow({scene, "--robot", "arm", "--link-sensors", "switches", "--avoidance",
                                    avoidance, "--max-sets", "1500", "--record", path(name), "--json", "-"});
        EXPECT_LE(result.code, 1) << result.err;
        return nlohmann::json::parse(result.out);
      };
      const auto json = once("one.run");
      const std::string ended = json["ended"], model = read(path("m.limpet"));
      EXPECT_TRUE(ended == "complete" || ended == "stopped" || ended == "max-sets") << ended;
      EXPECT_EQ(json["link_sensors"], "switches");
      if (avoidance == "programme") {
        EXPECT_EQ(json["collisions"], 0);
      }
      once("two.run");
      EXPECT_EQ(read(path("two.run")), read(path("one.run")));
      EXPECT_EQ(read(path("m.limpet")), model);
    }
}

TEST_F(Follow, AnArmRefusesWhatMakesNoSense) {
  expect_refused(follow({"cube", "--robot", "leg"}), "leg");
  expect_refused(follow({"cube", "--robot", "arm", "--avoidance", "none"}), "--avoidance 'none'");
  expect_refused(follow({"cube", "--robot", "arm", "--link-sensors", "x"}), "--link-sensors 'x'");
  expect_refused(follow({"cube", "--link-sensors", "switches"}), "robots with links");
}

TEST_F(Follow, ACubeIsClosed) {
  const auto result = follow({"cube", "-o", path("cube.off"), "--json", "-"});
  ASSERT_EQ(result.code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  for (const std::string key : {"sets",
                                "readings",
                                "points_confirmed",
                                "ended",
                                "closed",
                                "polygons",
                                "open_edges",
                                "coverage",
                                "coverage_total",
                                "path_length",
                                "collisions",
                                "clearance_control_point",
                                "clearance_links",
                                "unreachable",
                                "unclosable",
                                "false_unreachable",
                                "step_us_median",
                                "step_us_p99",
                                "model_us_median",
                                "model_us_p99",
                                "modes",
                                "violations",
                                "seconds",
                                "peak_memory_bytes"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["ended"], "complete");
  EXPECT_EQ(json["closed"], true);
  EXPECT_EQ(json["polygons"], 6);
  EXPECT_EQ(json["open_edges"], 0);
  EXPECT_EQ(json["collisions"], 0);
  EXPECT_EQ(json["violations"], 0);
  EXPECT_GT(json["coverage"], 0.99);
  EXPECT_GT(json["path_length"], 10);
  int steps = 0;
  for (const auto& [mode, count] : json["modes"].items()) steps += count.get<int>();
  EXPECT_EQ(steps + 1, json["sets"].get<int>()) << "there is no motion after the last set";
  EXPECT_TRUE(exists("cube.off"));
  EXPECT_EQ(run({"check", path("m.limpet")}).code, 0);
  EXPECT_EQ(run({"compare", path("m.limpet"), "cube", "--max-distance", "0.01", "--faces", "exact"}).code, 0);
}

/// As in thesis §4.3, and from before a known face.
TEST_F(Follow, ACubeThreeFacesOfWhichAreKnownIsClosedByTheOthers) {
  write("known.toml", "[world]\nshape = \"cube\"\n[initial]\nfaces = [0, 1, 2]\n");
  for (const std::string strategy : {"frontier", "thesis"})
    for (const std::string seed : {"2", "4"}) {
      const auto result = follow({path("known.toml"), "--strategy", strategy, "--seed", seed, "--json", "-",
                                  "--record", path("a.run")});
      ASSERT_EQ(result.code, 0) << result.err;
      const auto json = nlohmann::json::parse(result.out);
      EXPECT_EQ(json["closed"], true);
      EXPECT_EQ(json["polygons"], 6);
      EXPECT_EQ(json["isomorphic"], true);
      EXPECT_GT(json["points_confirmed"], 0);
      EXPECT_EQ(run({"check", path("m.limpet")}).code, 0);
      EXPECT_EQ(run({"follow", "--replay", path("a.run"), "-q", "-o", path("again.limpet")}).code, 0);
      EXPECT_EQ(read(path("again.limpet")), read(path("m.limpet")));
    }
}

TEST_F(Follow, TheStrategiesHaveModesOfTheirOwn) {
  const auto modes_of = [&](const std::string& strategy) {
    const auto result =
        follow({"cube", "--strategy", strategy, "--max-sets", "60", "--json", "-", "--check-every", "20"});
    EXPECT_EQ(result.code, 1) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["sets"], 60);
    EXPECT_EQ(json["ended"], "max-sets");
    EXPECT_EQ(json["violations"], 0);
    return json["modes"];
  };
  EXPECT_TRUE(modes_of("frontier").contains("extend"));
  EXPECT_TRUE(modes_of("thesis").contains("current edge"));
}

TEST_F(Follow, TheSameSeedGivesTheSameBytes) {
  const auto outcome = [&](const std::string& seed) {
    EXPECT_EQ(
        follow({"L", "--max-sets", "50", "--noise", "0.002", "--seed", seed, "--record", path("r.run")}).code,
        1);
    return std::pair(read(path("m.limpet")), read(path("r.run")));
  };
  const auto first = outcome("5");
  EXPECT_EQ(outcome("5"), first);
  EXPECT_NE(outcome("6").first, first.first);
}

TEST_F(Follow, RefusesWhatMakesNoSense) {
  expect_refused(follow({"cube", "--robot", "snake"}), "snake");
  expect_refused(follow({"cube", "--strategy", "luck"}), "luck");
  expect_refused(follow({"cube", "--start", "1,2"}), "--start");
  expect_refused(follow({"cube", "--start", "9,9,9"}), "--start");
  expect_refused(follow({"cube", "--resolution", "0"}), "--resolution");
  expect_refused(follow({"cube", "--max-sets", "0"}), "--max-sets");
  expect_refused(follow({"cuboid"}), "cuboid");
  expect_refused(follow({path("none.off")}), "none.off");
  expect_refused(follow({}), "SCENE");
  const std::string stuck =
      "[world]\nshape = \"cube\"\n[errors]\nstuck = [{ sensor = 99, distance = 0.1 }]\n";
  expect_refused(follow({write("s.toml", stuck)}), "no sensor 99");
  EXPECT_FALSE(exists("m.limpet"));
}

TEST_F(Follow, ARunThatFeelsNothingLeavesTheOldRecord) {
  const auto old = write("r.run", "old");
  expect_refused(follow({"cube", "--start", "9,9,9", "--record", old}), "--start");
  EXPECT_EQ(read(old), "old");
}

TEST_F(Follow, RefusesLengthsThatDoNotFitEachOther) {
  const auto with = [&](const std::string& parameters) {
    return follow({write("s.toml", "[world]\nshape = \"cube\"\n[parameters]\n" + parameters)});
  };
  expect_refused(with("resolution = 0.1\nfollow_distance = 0.1\n"), "δ");
  expect_refused(with("resolution = 0.05\nfollow_distance = 0.3\n"), "δ");
  expect_refused(with("resolution = 0.05\nstep = 0.3\n"), "σ_max");
  expect_refused(follow({write("s.toml", "[world]\nshape = \"cube\"\n[robot]\nceiling = 1\n")}), "γ");
}

TEST_F(Follow, RefusesOutputsThatCannotBeWritten) {
  const std::string nowhere = path("nowhere/x");
  expect_refused(run({"follow", "cube", "-o", nowhere + ".limpet"}), "nowhere");
  expect_refused(run({"follow", "cube", "-o", path("m.txt")}), "m.txt");
  expect_refused(follow({"cube", "--json", nowhere}), "nowhere");
  expect_refused(follow({"cube", "--record", nowhere}), "nowhere");
  EXPECT_FALSE(exists("m.limpet"));
}

}  // namespace
}  // namespace limpet::app
