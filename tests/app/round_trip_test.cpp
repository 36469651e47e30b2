// Copyright the limpet authors. GPL-3.0-or-later.
//
// scan → model → check → compare → draw, with answers that are known.
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "program.hpp"

namespace limpet::app {
namespace {

using RoundTrip = testing::ProgramTest;

TEST_F(RoundTrip, CubeHasSixFaces) {
  const auto scan_file = scan("c.ply", "cube", 20000, {"--noise", "0.001"});
  const auto modelled = run({"model",   scan_file,      "-o",           path("m.limpet"),
                             "-o",      path("m.off"),  "-o",           path("m.ply"),
                             "-o",      path("m.obj"),  "-o",           path("m.stl"),
                             "--noise", "0.001",        "--resolution", "0.05",
                             "--json",  path("s.json"), "--stages",     "3"});
  ASSERT_EQ(modelled.code, 0) << modelled.err;
  const auto summary = nlohmann::json::parse(read(path("s.json")));
  EXPECT_EQ(summary["polygons"], 6);
  EXPECT_EQ(summary["holes"], 0);
  EXPECT_EQ(summary["violations"], 0);
  EXPECT_EQ(run({"check", path("m.limpet")}).code, 0);

  const auto compared =
      run({"compare", path("m.limpet"), "cube", "--faces", "exact", "--max-distance", "0.06", "--json", "-"});
  EXPECT_EQ(compared.code, 0) << compared.err;
  const auto distances = nlohmann::json::parse(compared.out);
  EXPECT_EQ(distances["true_faces"], 6);
  EXPECT_EQ(distances["polygons"], 6);
  EXPECT_LT(distances["model_to_truth"]["max"], 0.02);

  for (const std::string mesh : {"m.off", "m.ply", "m.obj", "m.stl"}) {
    EXPECT_EQ(run({"compare", path(mesh), "cube", "--max-distance", "0.06"}).code, 0) << mesh;
  }
  for (const std::string picture : {"p.png", "p.svg"}) {
    EXPECT_EQ(run({"draw", path("m.limpet"), "-o", path(picture), "--width", "400"}).code, 0);
    EXPECT_GT(read(path(picture)).size(), 1000u);
  }
  EXPECT_EQ(run({"draw", path("m.stage1.limpet"), path("m.stage2.limpet"), path("m.stage3.limpet"), "-o",
                 path("growth.png"), "--view", "1,-1,0.5", "--up", "0,0,1"})
                .code,
            0);
  EXPECT_EQ(read(path("m.stage3.limpet")), read(path("m.limpet")));
  // The truth beside the model: a shape, and a mesh file.
  for (const std::string& truth : {std::string("cube"), path("m.off")}) {
    EXPECT_EQ(run({"draw", truth, path("m.limpet"), "-o", path("both.svg")}).code, 0);
    EXPECT_NE(read(path("both.svg")).find("0 points: 6 polygons, 12 shared edges, 0 open"),
              std::string::npos);
  }
  EXPECT_EQ(run({"draw", path("none.off"), "-o", path("none.svg")}).code, 2);
  // A mesh without area, and one with a sliver, are drawn as they are.
  for (const char* last : {"2 0 0", "2 1e-9 0"}) {
    const auto mesh = write("thin.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n" + std::string(last) + "\n3 0 1 2\n");
    EXPECT_EQ(run({"draw", mesh, "-o", path("thin.svg")}).code, 0) << last;
  }
}

TEST_F(RoundTrip, TheSummaryTellsWhyEdgesAreOpen) {
  const auto result = run({"model", scan("c.ply", "open_box", 6000), "-o", path("m.limpet"), "--resolution",
                           "0.1", "--noise", "0", "--json", path("m.json")});
  EXPECT_EQ(result.code, 0);
  const auto summary = nlohmann::json::parse(read(path("m.json")));
  std::int64_t told = 0;
  for (const auto& [refusal, count] : summary["open_because"].items()) told += count.get<std::int64_t>();
  EXPECT_EQ(told, summary["open_edges"]);
  EXPECT_GT(summary["open_because"]["alone"], 0);
  EXPECT_NE(result.out.find("no other polygon near"), std::string::npos) << result.out;
}

/// A box with a low ridge along its top.
std::string box_with_ridge(double bend_deg) {
  const std::string ridge = std::to_string(2 + 2 * std::tan(bend_deg * std::numbers::pi / 360));
  return "OFF\n10 7 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n0 0 2\n4 0 2\n4 4 2\n0 4 2\n2 0 " + ridge + "\n2 4 " +
         ridge + "\n4 3 2 1 0\n5 0 1 5 8 4\n4 1 2 6 5\n5 2 3 7 9 6\n4 3 0 4 7\n4 4 8 9 7\n4 8 5 6 9\n";
}

/// From half of the angular resolution on, two planes that noise tells apart share their edge at the end.
TEST_F(RoundTrip, ABendBelowHalfOfTheAngularResolutionIsToldWithTheAngleThatWouldDo) {
  for (const double bend : {3.0, 4.0, 6.0, 9.0}) {
    SCOPED_TRACE(bend);
    const auto mesh = write("ridge.off", box_with_ridge(bend));
    const auto points = scan("ridge.ply", mesh, 30000, {"--noise", "0.0005"});
    const auto model = [&](const std::vector<std::string>& more) {
      std::vector<std::string> all{"model", points, "-o", path("m.limpet"), "--json", path("m.json")};
      all.insert(all.end(), more.begin(), more.end());
      EXPECT_EQ(run(all).code, 0);
      return nlohmann::json::parse(read(path("m.json")));
    };
    const auto expect_closed = [](const nlohmann::json& summary) {
      EXPECT_TRUE(summary["closed"]);
      EXPECT_EQ(summary["polygons"], 7);
      EXPECT_TRUE(summary["suggested_angle_deg"].is_null());
    };
    const auto before = model({});
    if (bend > 5) {
      expect_closed(before);
      continue;
    }
    EXPECT_FALSE(before["closed"]);
    ASSERT_TRUE(before["suggested_angle_deg"].is_number());
    const double angle = before["suggested_angle_deg"];
    EXPECT_LT(angle, bend);
    EXPECT_GT(angle, bend / 2);
    expect_closed(model({"--angle", std::to_string(angle)}));
  }
}

TEST_F(RoundTrip, WhatIsNotGivenIsChosenAndSaid) {
  const auto result =
      run({"model", scan("c.ply", "cube", 20000, {"--noise", "0.001"}), "-o", path("m.limpet")});
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.out.find("chosen from the scan: --resolution 0.0"), std::string::npos) << result.out;
  EXPECT_EQ(run({"compare", path("m.limpet"), "cube", "--faces", "exact"}).code, 0);
}

}  // namespace
}  // namespace limpet::app
