// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>
#include <limpet/drawing/drawing.hpp>
#include <limpet/drawing/projection.hpp>
#include <limpet/drawing/raster.hpp>
#include <limpet/drawing/way.hpp>

#include "../io/files.hpp"
#include "../io/models.hpp"

namespace limpet::drawing::testing {
namespace {

using Eigen::Vector3d;
using io::testing::cube;
using io::testing::l_block;

class WayTest : public limpet::testing::TemporaryFolder {};

/// One panel of 200 × 200 pixels.
Sheet sheet_of(const Figure& figure, const View& view) {
  Sheet sheet;
  sheet.width = sheet.height = 200;
  Panel& panel = sheet.panels.emplace_back();
  panel.width = panel.height = 200;
  const Scene scene = make_scene(figure, false);
  const Eigen::Vector2d size = projected_size(scene.box, view);
  project(scene, view, scene.box, 180 / size.maxCoeff(), panel);
  return sheet;
}

/// Twice around a unit cube at this distance, rising.
std::vector<Vector3d> around(double distance) {
  std::vector<Vector3d> way;
  const double low = -distance, high = 1 + distance;
  const std::vector<Eigen::Vector2d> corners = {{low, low}, {high, low}, {high, high}, {low, high}};
  for (std::size_t i = 0; i < 9; ++i) {
    const Eigen::Vector2d& corner = corners[i % 4];
    way.emplace_back(corner.x(), corner.y(), 0.1 + 0.1 * static_cast<double>(i));
  }
  return way;
}

/// The depth buffer and the test by faces agree on what of a way is hidden.
TEST_F(WayTest, HidingAgreesWithTheDepthBuffer) {
  for (const auto& model : {cube(), l_block()}) {
    for (const Vector3d& toward : {Vector3d(-0.5, 0.72, -0.48), Vector3d(0.5, -0.72, 0.48)}) {
      Sheet sheet = sheet_of({model, "", {}, around(0.2)}, {toward, Vector3d::UnitZ(), ""});
      Panel& panel = sheet.panels[0];
      panel.shared_width = panel.open_width = 0.01;
      panel.vertex_radius = 0;
      for (LinePiece& piece : panel.lines) piece.color = {255, 0, 0}, piece.width = 3;
      const Image image = paint(sheet);
      const Hiding hiding(panel);
      int hidden = 0, seen = 0, wrong = 0;
      for (const LinePiece& piece : panel.lines) {
        const Vector3d middle = (piece.from + piece.to) / 2;
        const bool hides = hiding.hides(middle);
        ++(hides ? hidden : seen);
        const bool red =
            image.at(static_cast<int>(middle.x()), static_cast<int>(middle.y())) == io::Color{255, 0, 0};
        wrong += red == hides;
      }
      EXPECT_GT(hidden, 20);
      EXPECT_GT(seen, 20);
      EXPECT_LE(wrong, (hidden + seen) / 10) << "where one part of the way passes before another";
    }
  }
}

TEST_F(WayTest, BeginsInOneColourAndEndsInAnother) {
  const auto way = around(0.3);
  const Sheet sheet = sheet_of({cube(), "", {}, way}, {-Vector3d::UnitZ(), Vector3d::UnitY(), ""});
  const auto& pieces = sheet.panels[0].lines;
  ASSERT_GT(pieces.size(), way.size());
  EXPECT_EQ(pieces.front().color, kWayBegins);
  EXPECT_EQ(pieces.back().color, kWayEnds);
  std::size_t dots = 0;
  for (const auto& piece : pieces) {
    dots += piece.from == piece.to;
    EXPECT_LE((piece.to - piece.from).head<2>().norm(), 4 + 1e-9);
  }
  EXPECT_EQ(dots, way.size());
}

TEST_F(WayTest, StagesShowBeginningsOfOneWay) {
  const auto way = around(0.3);
  const std::vector<Vector3d> half(way.begin(), way.begin() + 5);
  draw({{cube(), "half", {}, half}, {cube(), "whole", {}, way}}, path("a.svg"), {});
  const std::string svg = read(path("a.svg"));
  const std::string begins = "stroke=\"#2882c8\"", ends = "stroke=\"#b00054\"";
  const auto cut = svg.find("panel1");
  EXPECT_NE(svg.substr(0, cut).find(begins), std::string::npos);
  EXPECT_EQ(svg.substr(0, cut).find(ends), std::string::npos) << "the half way is not at its end";
  EXPECT_NE(svg.find(ends), std::string::npos);
  EXPECT_NE(svg.find("path where it begins"), std::string::npos);
}

TEST_F(WayTest, PlacesThatAreNoneAreLeftOut) {
  const Figure figure{cube(), "", {}, {{2, 2, 2}, Vector3d::Constant(std::nan("")), {2, 2, 3}}};
  const Scene scene = make_scene(figure, true);
  EXPECT_EQ(scene.way.size(), 2u);
  EXPECT_TRUE(scene.box.contains(Vector3d(2, 2, 3)));
}

}  // namespace
}  // namespace limpet::drawing::testing
