// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>
#include <limpet/drawing/depth_order.hpp>
#include <limpet/drawing/drawing.hpp>
#include <limpet/drawing/font.hpp>
#include <limpet/drawing/open_edge_color.hpp>
#include <limpet/drawing/projection.hpp>
#include <limpet/drawing/raster.hpp>
#include <set>

#include "../io/files.hpp"
#include "../io/models.hpp"

namespace limpet::drawing::testing {
namespace {

using io::testing::cube;
using io::testing::l_block;
using io::testing::ModelMaker;
using io::testing::open_cube;
using io::testing::plate;
using io::testing::rectangle;

class DrawingTest : public limpet::testing::TemporaryFolder {};

const io::Color kOpen = open_edge_color(model::Refusal::alone);

/// One panel of 200 × 200 pixels, two units across, looking along `toward`.
Sheet sheet_of(const Figure& figure, const Eigen::Vector3d& toward, const Eigen::Vector3d& up) {
  Sheet sheet;
  sheet.width = sheet.height = 200;
  Panel& panel = sheet.panels.emplace_back();
  panel.width = panel.height = 200;
  const Scene scene = make_scene(figure, true);
  project(scene, {toward, up, ""}, scene.box, 100, panel);
  return sheet;
}

int count(const Image& image, const io::Color& color) {
  int found = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) found += image.at(x, y) == color;
  }
  return found;
}

TEST_F(DrawingTest, AFaceFillsWhatItCovers) {
  const Sheet sheet = sheet_of({cube(), ""}, -Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY());
  const Image image = paint(sheet);
  const io::Color top = sheet.panels[0].patches.back().fill;
  EXPECT_EQ(image.at(100, 100), top);
  EXPECT_EQ(image.at(20, 100), kPaper);
  EXPECT_EQ(image.at(100, 180), kPaper);
  // 100 × 100 pixels less the lines and dots on its rim.
  EXPECT_GT(count(image, top), 95 * 95);
  EXPECT_LT(count(image, top), 100 * 100);
}

TEST_F(DrawingTest, NearFacesHideFarOnesWhateverTheirOrder) {
  ModelMaker maker;
  maker.face({rectangle(0, 0, 1, 1, 0.5)}).face({rectangle(0, 0, 1, 1, 0)});
  const Sheet above = sheet_of({maker.make(), ""}, -Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY());
  EXPECT_EQ(paint(above).at(100, 100), above.panels[0].patches[0].fill);
  const Sheet below = sheet_of({maker.make(), ""}, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY());
  EXPECT_EQ(paint(below).at(100, 100), below.panels[0].patches[1].fill);
  EXPECT_NE(above.panels[0].patches[1].fill, below.panels[0].patches[1].fill)
      << "a back side looks otherwise";
}

TEST_F(DrawingTest, HolesShowWhatLiesBehind) {
  const Image image = paint(sheet_of({plate(), ""}, -Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY()));
  // The plate is 4 × 2 about (2, 1); the large bore has its middle at (1, 1): 100 pixels left of the centre.
  EXPECT_EQ(image.at(5, 100), kPaper);
  EXPECT_NE(image.at(100, 100), kPaper);
}

TEST_F(DrawingTest, OpenEdgesHaveTheirOwnColour) {
  const auto z = Eigen::Vector3d::UnitZ();
  EXPECT_EQ(count(paint(sheet_of({cube(), ""}, {-0.5, 0.7, -0.5}, z)), kOpen), 0);
  EXPECT_GT(count(paint(sheet_of({open_cube(), ""}, {-0.5, 0.7, -0.5}, z)), kOpen), 200);
}

TEST_F(DrawingTest, OpenEdgesTellWhatRefusedThem) {
  Figure figure{open_cube(), "told"};
  std::vector<model::Refusal> all;
  for (std::size_t i = 0; i < model::kRefusals; ++i) all.push_back(static_cast<model::Refusal>(i));
  std::size_t next = 0;
  for (const auto& polygon : figure.model.polygon_segments)
    for (const auto& vertex : polygon.cycles[0])
      if (vertex.partner == 0)
        figure.open_edges.push_back({{polygon.id}, {vertex.edge}, all[next++ % all.size()], {}});
  const Image image = paint(sheet_of(figure, {-0.5, 0.7, -0.5}, Eigen::Vector3d::UnitZ()));
  for (std::size_t i = 0; i < next; ++i)
    EXPECT_GT(count(image, open_edge_color(all[i % all.size()])), 20) << name(all[i % all.size()]);
  draw({figure}, path("told.svg"), {});
  const std::string svg = read(path("told.svg"));
  for (std::size_t i = 0; i < next; ++i)
    EXPECT_NE(svg.find(words(all[i % all.size()])), std::string::npos) << "in the legend";
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(open_edge_color(all[i]), open_edge_color(all[j]));
}

TEST_F(DrawingTest, HiddenEdgesAreHidden) {
  // Seen from below, the open rim of a cube lies behind its bottom.
  const Image image = paint(sheet_of({open_cube(), ""}, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY()));
  int inside = 0;
  for (int y = 55; y < 145; ++y) {
    for (int x = 55; x < 145; ++x) inside += image.at(x, y) == kOpen;
  }
  EXPECT_EQ(inside, 0);
}

TEST_F(DrawingTest, LoosePointsAreDots) {
  ModelMaker maker;
  maker.face({rectangle(0, 0, 1, 1, 0)}).loose({0.5, 0.5, 0.25}).loose({0.5, 0.25, -0.25});
  const Sheet sheet = sheet_of({maker.make(), ""}, -Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY());
  EXPECT_EQ(sheet.panels[0].loose.size(), 2u);
  const Image image = paint(sheet);
  EXPECT_EQ(image.at(100, 100), kLoosePoint);
  EXPECT_EQ(image.at(100, 125), sheet.panels[0].patches[0].fill) << "hidden behind the face";
}

/// Painting whole faces in depth order gives the picture the depth buffer gives.
TEST_F(DrawingTest, DepthOrderAgreesWithTheDepthBuffer) {
  const std::vector<model::ModelRecord> models = {cube(), open_cube(), l_block(), plate()};
  const std::vector<Eigen::Vector3d> directions = {
      {-0.5, 0.72, -0.48}, {0.5, -0.72, 0.48}, {0.9, 0.3, -0.2}, {-0.2, -0.8, 0.6}};
  for (std::size_t m = 0; m < models.size(); ++m) {
    for (std::size_t d = 0; d < directions.size(); ++d) {
      SCOPED_TRACE("model " + std::to_string(m) + ", direction " + std::to_string(d));
      Sheet sheet = sheet_of({models[m], ""}, directions[d], Eigen::Vector3d::UnitZ());
      Panel& panel = sheet.panels[0];
      panel.shared_width = panel.open_width = 0.01;
      panel.vertex_radius = 0;
      const Image truth = paint(sheet);
      const std::vector<int> order = depth_order(panel.patches);
      ASSERT_EQ(order.size(), panel.patches.size());
      Image painted = truth;
      std::fill(painted.pixels.begin(), painted.pixels.end(), std::uint8_t{255});
      std::set<io::Color> fills = {kPaper};
      for (const int face : order) {
        const io::Color fill = panel.patches[face].fill;
        fills.insert(fill);
        Sheet single = sheet;
        single.panels[0].patches = {panel.patches[face]};
        const Image layer = paint(single);
        for (int i = 0; i < 200 * 200; ++i) {
          if (layer.at(i % 200, i / 200) == kPaper) continue;
          for (int k = 0; k < 3; ++k) painted.pixels[i * 3 + k] = fill[k];
        }
      }
      // Where the depth buffer shows one face alone, the face painted last must be that one.
      int compared = 0, wrong = 0;
      for (int i = 0; i < 200 * 200; ++i) {
        const io::Color color = truth.at(i % 200, i / 200);
        if (fills.count(color) == 0) continue;
        ++compared;
        wrong += painted.at(i % 200, i / 200) != color;
      }
      EXPECT_GT(compared, 30000);
      EXPECT_LE(wrong, 20);
    }
  }
}

TEST_F(DrawingTest, PngHasTheWidthAskedForAndTheSameBytesTwice) {
  DrawOptions options;
  options.width = 640;
  draw({{cube(), "one"}}, path("a.png"), options);
  draw({{cube(), "one"}}, path("b.png"), options);
  const std::string bytes = read(path("a.png"));
  EXPECT_EQ(bytes, read(path("b.png")));
  ASSERT_GT(bytes.size(), 1000u);
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(static_cast<unsigned char>(bytes[18]) * 256 + static_cast<unsigned char>(bytes[19]), 640);
  EXPECT_EQ(names(), (std::vector<std::string>{"a.png", "b.png"}));
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST_F(DrawingTest, SvgShowsEveryFigureInEveryView) {
  draw({{open_cube(), "half <done>"}, {cube(), "done"}}, path("a.svg"), {});
  const std::string text = read(path("a.svg"));
  EXPECT_NE(text.find(">half &lt;done&gt;</text>"), std::string::npos);
  EXPECT_NE(text.find(">600 points: 6 polygons, 12 shared edges, 0 open</text>"), std::string::npos);
  EXPECT_NE(text.find(">500 points: 5 polygons, 8 shared edges, 4 open</text>"), std::string::npos);
  EXPECT_EQ(occurrences(text, "fill-rule"), 2u * (5 + 6)) << "two views of each figure";
  EXPECT_EQ(occurrences(text, "<clipPath"), 4u);
  EXPECT_EQ(occurrences(text, "<g "), occurrences(text, "</g>"));
  EXPECT_EQ(text.substr(text.size() - 7), "</svg>\n");
}

TEST_F(DrawingTest, AViewFromADirectionHasSomeUp) {
  const View oblique = view_from({1, -0.8, 0.6});
  EXPECT_EQ(oblique.toward, Eigen::Vector3d(-1, 0.8, -0.6));
  EXPECT_EQ(oblique.up, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(oblique.name, "from 1, -0.8, 0.6");
  EXPECT_EQ(view_from({0, 0, 2}).up, Eigen::Vector3d::UnitY());
  EXPECT_EQ(view_from({0, 0, 2}, Eigen::Vector3d::UnitX()).up, Eigen::Vector3d::UnitX());
  EXPECT_THROW(view_from({0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(view_from({0, 0, 2}, Eigen::Vector3d(0, 0, -1)), std::invalid_argument);
}

TEST_F(DrawingTest, DefaultViewsLookAtWhatWasSeen) {
  EXPECT_EQ(default_views({{cube(), ""}}).size(), 3u);
  ModelMaker maker;  // a wall seen by a sensor that looks along +y
  maker.face({{{0, 5, 0}, {2, 5, 0}, {2, 5, 1}, {0, 5, 1}}});
  const std::vector<View> views = default_views({{maker.make(), ""}});
  ASSERT_EQ(views.size(), 3u);
  for (const View& view : views) EXPECT_GT(view.toward.dot(Eigen::Vector3d::UnitY()), 0.5);
  EXPECT_EQ(views[0].up, Eigen::Vector3d::UnitZ());
}

TEST_F(DrawingTest, OddModelsAreDrawnToo) {
  model::ModelRecord broken = cube();
  broken.polygon_segments[0].chart_origin.x() = std::nan("");
  broken.polygon_segments[1].cycles.clear();
  EXPECT_EQ(make_scene({broken, ""}, true).polygons.size(), 4u);
  ModelMaker points;
  points.loose({1, 2, 3}).loose({4, 5, 7});
  for (const model::ModelRecord& model : {broken, points.make(), ModelMaker().make()}) {
    draw({{model, ""}}, path("odd.png"), {});
    EXPECT_GT(std::filesystem::file_size(path("odd.png")), 500u);
  }
}

TEST_F(DrawingTest, OptionsOutOfBoundsAreRefused) {
  DrawOptions options;
  EXPECT_THROW(draw({}, path("a.png"), options), std::invalid_argument);
  EXPECT_THROW(draw({{cube(), ""}}, path("a.bmp"), options), io::OutputError);
  options.views = {{Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ(), ""}};
  EXPECT_THROW(draw({{cube(), ""}}, path("a.png"), options), std::invalid_argument);
  options.views.clear();
  options.width = 100000;
  EXPECT_THROW(draw({{cube(), ""}}, path("a.png"), options), std::invalid_argument);
  EXPECT_EQ(names(), std::vector<std::string>{});
}

TEST_F(DrawingTest, TextIsAsWideAsItsStrokes) {
  for (const char* text : {"limpet", "12,345 points", "WAVE_{}~"}) {
    const Label label{10, 50, 12, kInk, text};
    double left = 1e9, right = -1e9;
    for (const Mark& mark : strokes(label)) {
      left = std::min({left, mark.from.x(), mark.to.x()});
      right = std::max({right, mark.from.x(), mark.to.x()});
    }
    EXPECT_NEAR(left, 10, 1e-9) << text;
    EXPECT_NEAR(right - left, text_width(text, 12), 1e-9) << text;
  }
  EXPECT_FALSE(strokes({0, 0, 12, kInk, "?"}).empty());
  EXPECT_EQ(strokes({0, 0, 12, kInk, "\xc2\xb5"}).size(), strokes({0, 0, 12, kInk, "?"}).size());
}

}  // namespace
}  // namespace limpet::drawing::testing
