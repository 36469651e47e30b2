// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limpet/drawing/drawing.hpp>
#include <limpet/drawing/facets.hpp>
#include <limpet/drawing/projection.hpp>
#include <limpet/drawing/raster.hpp>
#include <limpet/drawing/robot_figure.hpp>
#include <numbers>

#include "../io/files.hpp"
#include "../io/models.hpp"

namespace limpet::drawing::testing {
namespace {

using Eigen::Vector3d;
using io::testing::cube;
using kinematics::Joint;

class RobotPicture : public limpet::testing::TemporaryFolder {};

const Vector3d kZero = Vector3d::Zero(), kX = Vector3d::UnitX(), kY = Vector3d::UnitY(),
               kZ = Vector3d::UnitZ();

double distance_from_axis(const model::Capsule& capsule, const Vector3d& p) {
  const Vector3d along = capsule.b - capsule.a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - capsule.a).dot(along) / length2, 0.0, 1.0) : 0;
  return (p - capsule.a - t * along).norm();
}

TEST(Facets, AreAClosedConvexSurfaceOnTheCapsule) {
  const std::vector<model::Capsule> capsules = {
      {{1, 2, 3}, {1, 2, 3}, 0.5}, {{1, 2, 3}, {4, 1, 5}, 0.5}, {{0, 0, 0}, {0, 0, -0.01}, 2}};
  for (const model::Capsule& capsule : capsules) {
    const double r = capsule.radius, length = (capsule.b - capsule.a).norm();
    const double true_volume = std::numbers::pi * r * r * (length + 4.0 / 3 * r);
    const std::vector<Facet> facets = facets_of(capsule);
    Vector3d sum = kZero;
    double volume = 0;
    for (const Facet& facet : facets) {
      Vector3d area = kZero;
      for (std::size_t k = 2; k < facet.corners.size(); ++k)
        area += (facet.corners[k - 1] - facet.corners[0]).cross(facet.corners[k] - facet.corners[0]) / 2;
      EXPECT_NEAR(area.normalized().dot(facet.normal), 1, 1e-9);
      sum += area;
      volume += area.dot(facet.corners[0]) / 3;
      for (const Vector3d& corner : facet.corners) {
        EXPECT_NEAR(distance_from_axis(capsule, corner), r, 1e-12);
        for (const Facet& other : facets)
          EXPECT_LT(other.normal.dot(corner - other.corners[0]), 1e-9) << "no corner is before a facet";
      }
      const Vector3d middle = (facet.corners[0] + facet.corners[1] + facet.corners[2]) / 3;
      EXPECT_GT(distance_from_axis(capsule, middle), 0.98 * r);
    }
    EXPECT_LT(sum.norm(), 1e-9);
    EXPECT_NEAR(volume / true_volume, 1, 0.03);
  }
}

/// A post without extent, on it an arm of one link that turns about z, with two sensors and two switches at
/// its end, and on that a slider without extent.
kinematics::Robot small_robot() {
  kinematics::Robot robot;
  robot.links.resize(3);
  robot.links[1].parent = 0;
  robot.links[1].mounting.translation() = kZ;
  robot.links[1].joint = {Joint::Kind::revolute, kZ};
  robot.links[1].body = {{kZero, 2 * kX, 0.25}, {kX, kX + kY, 0}};
  robot.links[2].parent = 1;
  robot.links[2].mounting.translation() = 2 * kX;
  robot.links[2].joint = {Joint::Kind::prismatic, kX};
  robot.sensors = {
      {1, 2 * kX, kX, 0.5}, {1, 2 * kX, kY, 0.5}, {1, 2 * kX, -kY, std::numeric_limits<double>::infinity()}};
  robot.switches = {{1, kX, kZ, 0.5}, {1, kX, -kZ, 0.5}};
  return robot;
}

void expect_line(const RobotFigure::Line& line, const Vector3d& from, const Vector3d& to) {
  EXPECT_LT((line.from - from).norm(), 1e-12) << line.from.transpose();
  EXPECT_LT((line.to - to).norm(), 1e-12) << line.to.transpose();
}

/// Turned by a right angle: what was along x is along y.
TEST(RobotFigure, IsWhatTheSetWasSensedWith) {
  const kinematics::Robot robot = small_robot();
  const Eigen::Vector2d at(std::numbers::pi / 2, 0.5);
  simulation::Sensed sensed;
  sensed.measured = at;
  sensed.points = {{{0, 2.3, 1}, kY, 0.3}};
  sensed.sensors = {0};
  sensed.seeing = {1};
  const RobotFigure figure = robot_figure(kinematics::Posture(robot, at), sensed, 0.2);

  ASSERT_EQ(figure.body.size(), 1u);
  expect_line({figure.body[0].a, figure.body[0].b}, {0, 0, 1}, {0, 2, 1});
  EXPECT_EQ(figure.body[0].radius, 0.25);
  ASSERT_EQ(figure.bones.size(), 2u) << "the slider is none";
  expect_line(figure.bones[0], {0, 1, 1}, {-1, 1, 1});
  expect_line(figure.bones[1], kZero, kZ);
  ASSERT_EQ(figure.rays.size(), 1u);
  expect_line(figure.rays[0], {0, 2, 1}, {0, 2.3, 1});
  ASSERT_EQ(figure.misses.size(), 2u);
  expect_line(figure.misses[0], {0, 2, 1}, {-0.25, 2, 1});
  expect_line(figure.misses[1], {0, 2, 1}, {0.1, 2, 1});
  ASSERT_EQ(figure.quiet.size(), 1u);
  EXPECT_LT((figure.quiet[0] - Vector3d(0, 1, 1)).norm(), 1e-12);
  ASSERT_EQ(figure.fields.size(), 1u);
  expect_line(figure.fields[0], {0, 1, 1}, {0, 1, 0.5});
}

TEST(RobotFigure, OfThePointRobotHasNoBody) {
  const kinematics::Robot point = kinematics::point_robot({.heading = Eigen::Quaterniond(0.8, 0.6, 0, 0)});
  const RobotFigure figure = robot_figure(kinematics::Posture(point, Vector3d(1, 2, 3)), {}, 1);
  EXPECT_FALSE(figure.has_body());
  EXPECT_EQ(figure.misses.size(), 26u);
}

/// One panel of 200 × 200 pixels, 100 to a unit, seen from above with the origin in its middle.
Image picture_of(const Figure& figure, const Vector3d& toward = -kZ) {
  Sheet sheet;
  sheet.width = sheet.height = 200;
  Panel& panel = sheet.panels.emplace_back();
  panel.width = panel.height = 200;
  panel.way_width = 3;
  const Eigen::AlignedBox3d box(Vector3d(-1, -1, -1), Vector3d(1, 1, 1));
  project(make_scene(figure, false), {toward, kY, ""}, box, 100, panel);
  return paint(sheet);
}

/// Without a model.
Image picture_of(const RobotFigure& robot) { return picture_of(Figure{{}, "", {}, {}, robot}); }

/// At a place of the world.
io::Color color_at(const Image& image, double x, double y) {
  return image.at(static_cast<int>(100 + 100 * x), static_cast<int>(100 - 100 * y));
}

template <class Condition>
int pixels_where(const Image& image, Condition condition) {
  int found = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) found += condition(image.at(x, y));
  return found;
}

int pixels_of(const Image& image, const io::Color& color) {
  return pixels_where(image, [&](const io::Color& c) { return c == color; });
}

int brightness(const io::Color& color) { return color[0] + color[1] + color[2]; }

TEST_F(RobotPicture, ALinkCoversItsShadow) {
  RobotFigure robot;
  robot.body = {{{-0.5, 0, 0}, {0.5, 0, 0}, 0.25}};
  const Image image = picture_of(robot);
  const int covered = pixels_where(image, [](const io::Color& c) { return c != kPaper; });
  EXPECT_NEAR(covered, 1e4 * (0.5 + std::numbers::pi * 0.0625), 0.02 * covered + 200) << "200: its rim";
  EXPECT_NE(color_at(image, -0.7, 0), kPaper);
  EXPECT_EQ(color_at(image, -0.7, 0.2), kPaper) << "its end is round";
  EXPECT_EQ(pixels_of(image, kInk), 0) << "facets have no edges";
}

TEST_F(RobotPicture, ItIsLitFromTheUpperLeft) {
  RobotFigure robot;
  robot.body = {{kZero, kZero, 0.9}};
  const Image image = picture_of(robot);
  EXPECT_GT(brightness(color_at(image, -0.4, 0.4)), brightness(color_at(image, 0, 0)));
  EXPECT_GT(brightness(color_at(image, 0, 0)), brightness(color_at(image, 0.5, -0.5)));
}

TEST_F(RobotPicture, NearerThingsHideFartherOnes) {
  RobotFigure robot;
  robot.rays = {{{0.2, 0.5, 0.5}, {0.8, 0.5, 0.5}}};  // within the cube, whose top is at 1
  EXPECT_EQ(pixels_of(picture_of(Figure{cube(), "", {}, {}, robot}), kRay), 0);
  EXPECT_GT(pixels_of(picture_of(robot), kRay), 30);

  robot.body = {{{0.5, 0.5, 1.5}, {0.5, 0.5, 1.5}, 0.2}};
  const Image before = picture_of(Figure{cube(), "", {}, {}, robot});
  robot.body = {{{0.5, 0.5, -1.5}, {0.5, 0.5, -1.5}, 0.2}};
  const Image behind = picture_of(Figure{cube(), "", {}, {}, robot});
  EXPECT_NE(color_at(before, 0.5, 0.5), color_at(before, 0.8, 0.8));
  EXPECT_EQ(color_at(behind, 0.5, 0.5), color_at(behind, 0.8, 0.8));
}

TEST_F(RobotPicture, AReadingIsSeenFromItsSideOfTheFace) {
  Figure figure;
  figure.model = io::testing::ModelMaker().face({io::testing::rectangle(-0.5, -0.5, 0.5, 0.5, 0)}).make();
  figure.robot.emplace().rays = {{{0, 0, 0.4}, {0, 0, 0}}};
  EXPECT_GT(pixels_of(picture_of(figure, -kZ), kRay), 30);
  EXPECT_EQ(pixels_of(picture_of(figure, kZ), kRay), 0);
}

TEST_F(RobotPicture, SwitchesThatSeeSomethingStandOut) {
  RobotFigure robot;
  robot.body = {{{-0.5, 0, 0}, {0.5, 0, 0}, 0.25}};
  robot.quiet = {{-0.3, 0, 0.25}, {0.3, 0, 0.25}};
  EXPECT_EQ(pixels_of(picture_of(robot), kSeeing), 0);
  robot.quiet.pop_back();
  robot.fields = {{{0.3, 0, 0.25}, {0.3, 0.6, 0.25}}};
  const Image image = picture_of(robot);
  EXPECT_EQ(color_at(image, 0.3, 0), kSeeing);
  EXPECT_EQ(color_at(image, 0.3, 0.5), kSeeing) << "and the way through its field";
  EXPECT_EQ(color_at(image, -0.3, 0), kMiss);
}

TEST_F(RobotPicture, ThePictureHoldsAllOfIt) {
  RobotFigure robot;
  robot.body = {{{3, 0, 0}, {5, 0, 0}, 0.5}};
  robot.bones = {{{0, -2, 0}, {0, 0, 0}}};
  robot.misses = {{{5, 0, 0}, {9, 0, 0}}};
  const Scene scene = make_scene({cube(), "", {}, {}, robot}, false);
  EXPECT_EQ(scene.box.max(), Vector3d(5.5, 1, 1)) << "rays may be cut off";
  EXPECT_EQ(scene.box.min(), Vector3d(0, -2, -0.5));
}

TEST_F(RobotPicture, RaysMayBeLongerThanAnyPicture) {
  RobotFigure robot;
  robot.rays = {{{0, 0, 0}, {1e200, 0, 0}}, {{-1e9, 0.5, 0}, {1e9, 0.5, 0}}};
  robot.misses = {{{5, 5, 0}, {1e300, 1e300, 1e308}}, {{0, -0.5, 0}, {0.5, -0.5, std::nan("")}}};
  const Image image = picture_of(robot);
  EXPECT_EQ(color_at(image, 0.9, 0), kRay);
  EXPECT_EQ(color_at(image, -0.1, 0), kPaper);
  EXPECT_EQ(color_at(image, 0.9, 0.5), kRay);
  EXPECT_EQ(color_at(image, -0.9, 0.5), kRay);
  EXPECT_EQ(pixels_of(image, kMiss), 0);
}

TEST_F(RobotPicture, OddRobotsDoNoHarm) {
  for (const double odd : {1e-250, 1e150, 1e250, std::numeric_limits<double>::infinity(), std::nan("")}) {
    RobotFigure robot;
    robot.body = {{{odd, 0, 0}, {0, odd, 0}, odd}, {{0, 0, 0}, {0, odd, 0}, 1e-3}};
    robot.bones = {{{odd, 0, 0}, {0, 0, 0}}};
    draw({{cube(), "odd", {}, {}, robot}}, path("odd.png"), {});
    draw({{cube(), "odd", {}, {}, robot}}, path("odd.svg"), {});
  }
}

TEST_F(RobotPicture, TheLegendTellsWhatThereIs) {
  RobotFigure robot;
  robot.body = {{{2, 0, 0}, {3, 0, 0}, 0.5}};
  robot.fields = {{{3, 0, 0}, {3.5, 0, 0}}};
  draw({{cube(), "model"}}, path("model.svg"), {});
  draw({{cube(), "arm", {}, {}, robot}}, path("arm.svg"), {});
  const std::string model = read(path("model.svg")), arm = read(path("arm.svg"));
  EXPECT_EQ(model.find(">robot<"), std::string::npos);
  EXPECT_NE(arm.find(">robot<"), std::string::npos);
  EXPECT_NE(arm.find(">switch that sees something<"), std::string::npos);
  EXPECT_EQ(arm.find(">sensor that met nothing<"), std::string::npos);
  EXPECT_EQ(arm.find(">reading<"), std::string::npos);
}

}  // namespace
}  // namespace limpet::drawing::testing
