// Copyright the limpet authors. GPL-3.0-or-later.
//
// What is chosen by a scan, and that the scan is all there to be read afterwards.
#include <limpet/io/error.hpp>
#include <limpet/io/scan_writer.hpp>
#include <limpet/io/text.hpp>
#include <limpet/simulation/shapes.hpp>
#include <limpet/survey/choose.hpp>

#include "../temporary_folder.hpp"
#include "copies.hpp"
#include "simulated.hpp"

namespace limpet::survey {
namespace {

using Order = simulation::ScanOptions::Order;

class Choose : public limpet::testing::TemporaryFolder {
 protected:
  std::string scan(const std::string& name, bool axes = true, double noise = 0.002) const {
    io::ScanWriterOptions options;
    options.axes = axes;
    const auto writer = io::create_scan(path(name), options);
    for (const auto& p : testing::SimulatedScan{"cube", 10'000, Order::sampled, noise, 0}.make())
      writer->write({p.point, axes, -1});
    writer->close();
    return path(name);
  }
};

TEST_F(Choose, FourDigitsThatCanBeGivenAgain) {
  PointStream points(scan("cube.ply"));
  const Choice choice = choose(points);
  EXPECT_NEAR(choice.parameters.noise, 0.002, 0.0006);
  EXPECT_GT(choice.parameters.resolution, 0.03);
  EXPECT_LT(choice.parameters.resolution, 0.1);
  for (const double chosen :
       {choice.parameters.resolution, choice.parameters.noise, choice.parameters.tolerance})
    EXPECT_EQ(chosen, io::short_number(chosen));
  EXPECT_EQ(choice.voxel_edge, 0) << "the scan says its axes";
  EXPECT_EQ(choice.points, 10'000);
}

TEST_F(Choose, WhatIsKnownStaysAsItIs) {
  PointStream points(scan("cube.ply"));
  Known known{0.0712345, NoiseLaw{0.00123456, 0, 0}, 0.0198765, {}};
  known.others.angle_rad = 0.3;
  known.others.outlier_patience = 77;
  const Choice choice = choose(points, known);
  EXPECT_EQ(choice.parameters.resolution, 0.0712345);
  EXPECT_EQ(choice.parameters.noise, 0.00123456);
  EXPECT_EQ(choice.parameters.tolerance, 0.0198765);
  EXPECT_EQ(choice.parameters.angle_rad, 0.3);
  EXPECT_EQ(choice.parameters.outlier_patience, 77);
  EXPECT_FALSE(choice.estimate) << "nothing had to be asked of the scan";
  EXPECT_EQ(explanation(choice),
            "resolution 0.07123: given\nnoise 0.001235: given\ntolerance 0.01988: given\n");
}

TEST_F(Choose, OneMayBeKnownAlone) {
  const std::string file = scan("cube.ply");
  PointStream points(file), others(file);
  const Choice choice = choose(points, {.resolution = 0.2}), free = choose(others);
  EXPECT_EQ(choice.parameters.resolution, 0.2);
  EXPECT_EQ(choice.parameters.noise, free.parameters.noise);
  EXPECT_EQ(choice.parameters.tolerance, 0.04) << "a fifth of the resolution that is known";
}

TEST_F(Choose, ALambdaThatGrowsWithTheRangeWhereTheSpaceBetweenPointsDoes) {
  simulation::ScanOptions options;
  options.order = Order::turning;
  options.points = 50'000;
  options.noise = 0.001;
  options.viewpoints = {{2.1, 1.7, 1.5}};
  const simulation::Mesh room = simulation::make_shape("room:1:3:2");
  const auto write = [&](const std::string& name, bool ranges) {
    io::ScanWriterOptions format;
    format.ranges = ranges;
    const auto writer = io::create_scan(path(name), format);
    simulation::scan(room, options, [&](const simulation::LabelledPoint& p) {
      writer->write({p.point, true, -1});
    });
    writer->close();
    return path(name);
  };
  PointStream points(write("room.ply", true));
  const Choice choice = choose(points);
  const model::Parameters& chosen = choice.parameters;
  EXPECT_GT(chosen.resolution_per_range, 0.03);
  EXPECT_LT(chosen.resolution_per_range, 0.15);
  ASSERT_EQ(chosen.sensors.size(), 1u);
  EXPECT_LT((chosen.sensors[0] - options.viewpoints[0]).norm(), 0.02);
  EXPECT_EQ(choice.near_resolution,
            chosen.resolution + chosen.resolution_per_range * choice.estimate->near_range);
  EXPECT_NE(explanation(choice).find("which grows with the range"), std::string::npos);

  const std::string file = write("silent.ply", false);
  PointStream silent(file), given(path("room.ply")), asked(file);
  EXPECT_EQ(choose(silent).parameters.resolution_per_range, 0) << "the scan does not say its ranges";
  const model::Parameters known = choose(given, {.resolution = ResolutionLaw(0.03, 0.05)}).parameters;
  EXPECT_EQ(known.resolution, 0.03);
  EXPECT_EQ(known.resolution_per_range, 0.05);
  EXPECT_EQ(known.sensors, chosen.sensors);
  EXPECT_THROW(choose(asked, {.resolution = ResolutionLaw(0.03, 0.05)}), io::InputError);
}

TEST_F(Choose, SaysWhy) {
  PointStream exact(scan("exact.ply", true, 0));
  const std::string by_density = explanation(choose(exact));
  EXPECT_NE(by_density.find("per square of it"), std::string::npos) << by_density;
  EXPECT_NE(by_density.find("a fifth of the resolution"), std::string::npos) << by_density;
  PointStream noisy(scan("noisy.ply", true, 0.02));
  const std::string by_noise = explanation(choose(noisy));
  EXPECT_NE(by_noise.find("ten times the least noise"), std::string::npos) << by_noise;
  EXPECT_NE(by_noise.find("three times the noise"), std::string::npos) << by_noise;
}

TEST_F(Choose, AllPointsAreStillThereAndInOrder) {
  const std::string file = scan("cube.ply");
  PointStream plain(file), looked_at(file);
  choose(looked_at);
  std::vector<model::SensorPoint> a, b;
  std::size_t points = 0;
  while (plain.next_set(a)) {
    ASSERT_TRUE(looked_at.next_set(b));
    ASSERT_EQ(a.size(), b.size());
    EXPECT_LE(a.size(), kSetSize);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].position, b[i].position);
    points += a.size();
  }
  EXPECT_FALSE(looked_at.next_set(b));
  EXPECT_EQ(points, 10'000u);
}

TEST_F(Choose, AScanWithoutAxesIsTurnedByItsShape) {
  PointStream points(scan("bare.ply", false));
  const Choice choice = choose(points);
  ASSERT_FALSE(points.has_axes());
  ASSERT_GT(choice.voxel_edge, 0);
  points.orient(choice.voxel_edge);
  std::int64_t inward = 0;
  const Eigen::Vector3d middle(0.5, 0.5, 0.5);
  for (Reading reading; points.next(reading);)
    inward += reading.point.axis.dot(middle - reading.point.position) > 0;
  EXPECT_GT(inward, 9'500);
}

TEST_F(Choose, ByEachPlaceOnce) {
  for (const std::int64_t count : {5'000, 50'000}) {
    std::vector<model::SensorPoint> points;
    for (const auto& p : testing::SimulatedScan{"cube", count, Order::raster, 0.002, 0}.make())
      points.push_back(p.point);
    const auto chosen = [&](const std::vector<model::SensorPoint>& scan) {
      const auto writer = io::create_scan(path("scan.ply"), {});
      for (const auto& p : scan) writer->write({p, true, -1});
      writer->close();
      PointStream stream(path("scan.ply"));
      return choose(stream).parameters;
    };
    const model::Parameters single = chosen(points);
    for (const testing::Copies order : testing::kAllCopies) {
      SCOPED_TRACE(std::to_string(count) + ", order " + std::to_string(static_cast<int>(order)));
      const model::Parameters found = chosen(testing::thrice(points, order, 1));
      EXPECT_NEAR(found.resolution / single.resolution, 1, 0.03);
      EXPECT_NEAR(found.noise / single.noise, 1, 0.04);
      EXPECT_NEAR(found.tolerance / single.tolerance, 1, 0.04);
    }
  }
}

TEST_F(Choose, NothingToChooseBy) {
  PointStream few(write("few.xyz", "0 0 0 0 0 1\n1 0 0 0 0 1\n"));
  EXPECT_THROW(choose(few), TooFewPoints);
  PointStream none(write("none.xyz", "nan 0 0 0 0 1\n"));
  EXPECT_THROW(choose(none), io::InputError);
  PointStream damaged(write("damaged.xyz", "0 0 0 0 0 1\n1 0\n"));
  try {
    choose(damaged);
    FAIL();
  } catch (const TooFewPoints&) {
    FAIL() << "it has few points because of its damage";
  } catch (const io::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("line 2"), std::string::npos) << error.what();
  }
  PointStream rangeless(write("rangeless.xyz", "0 0 0 0 0 1\n1 0 0 0 0 1\n"));
  EXPECT_THROW(choose(rangeless, {0.05, NoiseLaw{0, 0.01, 0}, 0.01, {}}), io::InputError);
}

TEST_F(Choose, ALongLookCanBeStopped) {
  PointStream points(scan("cube.ply"), {}, [] { return true; });
  std::int64_t seen = 0;
  points.look_ahead(1000, [&](const model::SensorPoint&) { ++seen; });
  EXPECT_EQ(seen, 0);
}

}  // namespace
}  // namespace limpet::survey
