// Copyright the limpet authors. GPL-3.0-or-later.
//
// `limpet check MODEL --scan SCAN`: what readings support passes, what is invented does not.
#include <limpet/io/native.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "program.hpp"

namespace limpet::app {
namespace {

class CheckByScan : public testing::ProgramTest {
 protected:
  /// A plate with three holes, its scan and its model, all with defaults.
  void SetUp() override {
    scan_ = scan("plate.ply", "plate3", 30'000, {"--noise", "0.001"});
    ASSERT_EQ(run({"model", scan_, "-o", path("m.limpet"), "-o", path("m.off"), "-q"}).code, 0);
  }
  std::string with_holes_filled() const {
    model::ModelRecord record = io::load_native(path("m.limpet"));
    for (auto& polygon : record.polygon_segments) polygon.cycles.resize(1);
    io::save_native(path("filled.limpet"), record);
    return path("filled.limpet");
  }
  std::string scan_;
};

TEST_F(CheckByScan, AModelOfItsScanIsSupported) {
  const auto result = run({"check", path("m.limpet"), "--scan", scan_, "--json", path("s.json")});
  EXPECT_EQ(result.code, 0) << result.out << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("nothing is broken"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("support: 0 of"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("transparent: not judged"), std::string::npos) << result.out;
  const auto json = nlohmann::json::parse(read(path("s.json")));
  EXPECT_EQ(json["violations"], 0);
  const auto& evidence = json["evidence"];
  EXPECT_EQ(evidence["within_bounds"], true);
  EXPECT_GT(evidence["explained_share"], 0.98);
  EXPECT_EQ(evidence["polygons"].size(), json["polygons"]);
  for (const std::string key : {"readings", "explained", "chance", "bound", "beyond_chance", "unsupported",
                                "empty_area", "emptiest", "rays", "transparent"})
    EXPECT_TRUE(evidence[key].is_number()) << key;
  for (const std::string key : {"id", "area", "readings", "density", "given", "empty_centre", "empty_radius",
                                "empty_expected", "empty_excused", "empty_area", "rays_on", "rays_through",
                                "beyond_chance", "unsupported", "transparent"})
    EXPECT_TRUE(evidence["polygons"][0].contains(key)) << key;
  const auto quiet = run({"check", path("m.limpet"), "--scan", scan_, "-q"});
  EXPECT_EQ(quiet.out + quiet.err, "");
  EXPECT_FALSE(
      nlohmann::json::parse(run({"check", path("m.limpet"), "--json", "-"}).out).contains("evidence"));
}

TEST_F(CheckByScan, WhatIsInventedIsNamed) {
  const auto result = run({"check", with_holes_filled(), "--scan", scan_, "-q"});
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_NE(result.out.find("unsupported: polygon "), std::string::npos) << result.out;
  const auto json =
      nlohmann::json::parse(run({"check", path("filled.limpet"), "--scan", scan_, "--json", "-"}).out);
  EXPECT_EQ(json["evidence"]["unsupported"], 2) << "the plate's two sides";
  EXPECT_EQ(json["evidence"]["within_bounds"], false);
}

TEST_F(CheckByScan, RaysNeedToKnowWhereTheSensorStood) {
  // Without normals, from one viewpoint: the ranges are known.
  const std::string bare = scan("bare.xyz", "plate3", 20'000, {"--viewpoint", "1.5,0.5,4"});
  std::string text;
  std::istringstream lines(read(bare));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::size_t end = 0;
    for (int k = 0; k < 3; ++k) end = line.find(' ', end + 1);
    text += line.substr(0, end) + "\n";
  }
  write("bare.xyz", text);
  ASSERT_EQ(run({"model", bare, "-o", path("b.limpet"), "--viewpoint", "1.5,0.5,4", "-q"}).code, 0);
  const auto result =
      run({"check", path("b.limpet"), "--scan", bare, "--viewpoint", "1.5,0.5,4", "--json", "-"});
  EXPECT_EQ(result.code, 0) << result.out << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["evidence"]["rays"], json["evidence"]["readings"]);
  EXPECT_EQ(json["evidence"]["transparent"], 0);
}

TEST_F(CheckByScan, AModelFromStandardInput) {
  testing::Surroundings piped;
  piped.input = path("m.limpet");
  EXPECT_EQ(run({"check", "-", "--scan", scan_}, piped).code, 0);
  expect_refused(run({"check", "-", "--scan", "-"}, piped), "only once");
}

TEST_F(CheckByScan, WhatCannotBeJudgedIsRefused) {
  expect_refused(run({"check", path("m.off"), "--scan", scan_}), "m.off");
  expect_refused(run({"check", path("m.limpet"), "--scan", path("none.ply")}), "none.ply");
  expect_refused(run({"check", path("m.limpet"), "--scan", path("m.off")}), "m.off");
  expect_refused(run({"check", path("m.limpet"), "--scan", path("")}), "");
  expect_refused(run({"check", path("m.limpet"), "--orient"}), "--scan");
  expect_refused(run({"check", path("m.limpet"), "--scan", write("empty.xyz", "")}), "empty.xyz");
  const std::string whole = read(scan_);
  expect_refused(
      run({"check", path("m.limpet"), "--scan", write("cut.ply", whole.substr(0, whole.size() / 2))}),
      "cut.ply");
  ASSERT_EQ(run({"model", scan_, "-o", path("far.limpet"), "--noise", "0.001", "-q"}).code, 0);
  model::ModelRecord record = io::load_native(path("far.limpet"));
  record.parameters.noise_per_range = 0.001;
  io::save_native(path("far.limpet"), record);
  expect_refused(run({"check", path("far.limpet"), "--scan", scan_}), "--viewpoint");
}

}  // namespace
}  // namespace limpet::app
