// Copyright the limpet authors. GPL-3.0-or-later.
//
// Each update rule does what it says, shown on a small stream with the rule and without it.
#include <gtest/gtest.h>

#include "streams.hpp"

namespace limpet::model {
namespace {

using namespace testing;
using Order = simulation::ScanOptions::Order;

Parameters with(const std::string& rules, double resolution = 0.1) {
  Parameters p;
  p.resolution = resolution;
  p.rules = Rules::parse(rules);
  return p;
}

/// The finished model, which the oracle finds nothing in after any set.
ModelRecord judged(const Parameters& parameters, const Points& points, std::size_t set_size = 100) {
  Model model(parameters);
  for (std::size_t i = 0; i < points.size(); i += set_size) {
    model.update(std::span(points).subspan(i, std::min(set_size, points.size() - i)));
    EXPECT_EQ(broken_laws(model.record()), "");
  }
  model.finish();
  const ModelRecord record = model.record();
  EXPECT_EQ(broken_laws(record), "");
  return record;
}

/// A plate 1 × 1 about the origin with a bore of diameter 0.4.
Points plate_with_bore(std::uint64_t seed) {
  Random random(seed);
  return bored(plate(random, 6000, -0.5, -0.5, 0.5, 0.5), 0.2);
}

TEST(HolesRule, APlateKeepsItsBore) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const ModelRecord record = judged(with("limpet"), plate_with_bore(seed));
    ASSERT_EQ(record.polygon_segments.size(), 1u) << "seed " << seed;
    const auto cycles = world_cycles(record.polygon_segments[0], record.grid_step);
    ASSERT_EQ(cycles.size(), 2u) << "seed " << seed;
    // No part of the hole's boundary is far from the bore, and none in its middle.
    for (const auto& v : cycles[1]) {
      EXPECT_GT(v.head<2>().norm(), 0.2 - 0.05);
      EXPECT_LT(v.head<2>().norm(), 0.2 + 0.1);
    }
  }
}

TEST(HolesRule, WithoutItNoPolygonHasAHole) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const ModelRecord record = judged(with("-holes"), plate_with_bore(seed));
    EXPECT_GE(record.polygon_segments.size(), 1u);
    EXPECT_EQ(holes_of(record), 0u) << "seed " << seed;
  }
}

/// A plate and, once its polygon has grown, readings a little outside its border, each farther out.
TEST(NearRule, PointsNearThePerimeterUpdateTheMomentsOnly) {
  Random random(2);
  const Points points = plate(random, 2000, 0, 0, 1, 1);
  for (const bool near : {true, false}) {
    Model model(with(near ? "limpet" : "-near"));
    feed(model, points);
    const ModelRecord before = model.record();
    ASSERT_EQ(before.polygon_segments.size(), 1u);
    const double right = [&] {
      double x = 0;
      for (const auto& v : world_perimeter(before.polygon_segments[0], before.grid_step))
        x = std::max(x, v.x());
      return x;
    }();
    double y = 0;
    for (const auto& v : world_perimeter(before.polygon_segments[0], before.grid_step))
      if (v.x() == right) y = v.y();
    const Points outside = {{{right + 0.02, y, 0}, {0, 0, -1}}};  // λ/5
    model.update(outside);
    const ModelRecord after = model.record();
    ASSERT_EQ(after.polygon_segments.size(), 1u);
    EXPECT_EQ(after.polygon_segments[0].moments.count, before.polygon_segments[0].moments.count + 1);
    const auto edges = [](const ModelRecord& r) {
      std::vector<std::uint64_t> ids;
      for (const auto& v : r.polygon_segments[0].cycles[0]) ids.push_back(v.edge);
      return ids;
    };
    EXPECT_EQ(edges(before) == edges(after), near);
    model.update(Points{{{right + 0.05, y, 0}, {0, 0, -1}}});  // λ/2: beyond the rule
    EXPECT_NE(edges(model.record()), edges(after)) << near;
  }
}

/// A sparse plate, so that by chance some discs wider than λ hold no reading.
TEST(VoidsRule, HolesThatChanceExplainsAreDroppedWhenFinishing) {
  std::size_t with_rule = 0, without = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    const Points points = plate(random, 2000, 0, 0, 2, 2);  // five readings in λ²
    with_rule += holes_of(judged(with("limpet"), points));
    without += holes_of(judged(with("-voids"), points));
  }
  EXPECT_EQ(with_rule, 0u);
  EXPECT_GT(without, 0u);
}

TEST(VoidsRule, DoesNothingBeforeTheEnd) {
  std::size_t before = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    Model model(with("limpet"));
    feed(model, plate(random, 2000, 0, 0, 2, 2));
    before += holes_of(model.record());
    model.finish();
    EXPECT_EQ(holes_of(model.record()), 0u);
  }
  EXPECT_GT(before, 0u);
}

/// A plate at 2,000 readings in λ²: those that the noise has thrown more than three standard deviations off
/// fit it no more, and there are enough of them for planes of their own.
TEST(ArrivalRule, TheTailsOfTheNoiseAreNoSurface) {
  std::size_t with_rule = 0, without = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    const Points points = plate(random, 50000, 0, 0, 5, 5, 0.1);
    Parameters parameters = with("limpet");
    parameters.resolution = 1, parameters.noise = 0.1;
    parameters.rules = Rules::parse("-position");  // which deletes such planes, too, in the end
    with_rule += judged(parameters, points).polygon_segments.size();
    parameters.rules = Rules::parse("-position,-arrival");
    without += judged(parameters, points).polygon_segments.size();
  }
  EXPECT_EQ(with_rule, 4u);
  EXPECT_GT(without, 4u);
}

/// What is scanned late, and at a tenth of the density of the rest, is a surface all the same.
TEST(ArrivalRule, ASurfaceSeenLateAndThinlyIsOne) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    Points points = plate(random, 20000, 0, 0, 5, 5, 0.02), late = plate(random, 6000, 0, 0, 5, 5, 0.02);
    for (auto& p : late) p.position += Vector3d(20, 0, 0);
    Points other = plate(random, 60000, 0, 0, 5, 5, 0.02);
    late.insert(late.end(), other.begin(), other.end());
    shuffle(late, random);
    points.insert(points.end(), late.begin(), late.end());
    Parameters parameters = with("limpet");
    parameters.resolution = 1, parameters.noise = 0.02;
    EXPECT_EQ(judged(parameters, points).polygon_segments.size(), 2u) << "seed " << seed;
  }
}

/// One reading high above a plate, which then gets as many readings as are asked for.
Model with_outlier(Parameters parameters, std::int64_t patience, int readings) {
  parameters.outlier_patience = patience;
  Random random(3);
  Model model(parameters);
  model.keep_labels();
  model.update(Points{{{0.5, 0.5, 3}, {0, 0, -1}}});
  feed(model, plate(random, readings, 0, 0, 1, 1));
  return model;
}

TEST(ExpiryRule, AnOutlierExpiresAfterThePatienceAndIsCounted) {
  const Model waiting = with_outlier(with("limpet"), 500, 500);
  EXPECT_EQ(waiting.counts().expired, 0);
  EXPECT_TRUE(waiting.labels()[0]);
  const Model expired = with_outlier(with("limpet"), 500, 501);
  EXPECT_EQ(expired.counts().expired, 1);
  EXPECT_FALSE(expired.labels()[0]);
  EXPECT_EQ(expired.counts().point_segments, 0);
  EXPECT_EQ(expired.record().expired, 1);
  EXPECT_EQ(points_in_segments(expired.record()) + 1, 502);
  EXPECT_EQ(broken_laws(expired.record()), "");
}

TEST(ExpiryRule, ManyOutliersInOnePlaceExpireToo) {
  // Over a surface of 2λ by 2λ a reading comes to each λ² a hundred times as often as to the outliers' place,
  // which holds more than five of them long before the patience ends.
  Parameters parameters = with("limpet");
  parameters.outlier_patience = 2000;
  const double lambda = parameters.resolution;
  Model model(parameters);
  Random random(41);
  std::int64_t outliers = 0;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d anywhere(random.uniform(), random.uniform(), random.uniform());
    const bool outlier = i % 400 == 0;
    outliers += outlier;
    const Eigen::Vector3d on_surface(2 * lambda * anywhere.x(), 2 * lambda * anywhere.y(), 0);
    const Eigen::Vector3d p =
        outlier ? Eigen::Vector3d(20 * lambda * Eigen::Vector3d::Ones() + 0.8 * lambda * anywhere)
                : on_surface;
    model.update(Points{{p, {0, 0, -1}}});
  }
  EXPECT_EQ(model.counts().polygons, 1);
  EXPECT_GE(model.counts().expired, outliers - 20);
  EXPECT_LE(model.counts().expired, outliers);
  EXPECT_EQ(broken_laws(model.record()), "");
}

TEST(ExpiryRule, TellsOfTheDeletion) {
  Parameters parameters = with("limpet");
  parameters.outlier_patience = 3;
  Model model(parameters);
  const auto reading = [](double x) { return Points{{{x, 0, 0}, {0, 0, -1}}}; };
  const auto created = model.update(reading(0));
  ASSERT_EQ(created.size(), 1u);
  for (const double x : {10.0, 20.0, 30.0}) EXPECT_EQ(model.update(reading(x)).size(), 1u);
  const auto changes = model.update(reading(40));
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[1].kind, Change::Kind::deleted);
  EXPECT_EQ(changes[1].first, created[0].result);
}

TEST(ExpiryRule, WithoutItAnOutlierStays) {
  const Model model = with_outlier(with("-expiry"), 10, 1000);
  EXPECT_EQ(model.counts().expired, 0);
  EXPECT_EQ(model.counts().point_segments, 1);
  EXPECT_TRUE(model.labels()[0]);
}

TEST(ExpiryRule, FiveReadingsAreNoOutlier) {
  Parameters parameters = with("limpet");
  parameters.outlier_patience = 100;
  Random random(5);
  Model model(parameters);
  Points line;  // no plane
  for (int i = 0; i < 5; ++i) line.push_back({{0.5 + 0.01 * i, 0.5, 3}, {0, 0, -1}});
  model.update(line);
  feed(model, plate(random, 1000, 0, 0, 1, 1));
  EXPECT_EQ(model.counts().expired, 0);
  EXPECT_EQ(model.counts().point_segments, 1);
}

/// Polygons beyond the eight faces of a noisy octahedron: slivers across its edges, with a normal of neither
/// face.
std::size_t slivers(const std::string& rules, std::uint64_t seed) {
  Scan scan = scanned("octahedron", 6000, 0.005, Order::shuffled, seed);
  scan.parameters.rules = Rules::parse(rules);
  const std::size_t polygons = judged(scan.parameters, scan.points, 500).polygon_segments.size();
  EXPECT_GE(polygons, 8u);
  return polygons - 8;
}

TEST(DissolveRule, SliversAcrossEdgesGoToTheFacesTheyAreOf) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    // Without rule `position`, which deletes at the end what is left of them.
    EXPECT_EQ(slivers("-position", seed), 0u) << "seed " << seed;
    EXPECT_GT(slivers("-dissolve,-position", seed), 0u) << "seed " << seed;
  }
}

TEST(FinishRule, WithoutItTheEndChangesNothing) {
  Scan scan = scanned("cube", 3000, 0, Order::shuffled);
  scan.parameters.rules = Rules::parse("-finish");
  Model model(scan.parameters);
  feed(model, scan.points);
  const std::string before = bytes(model.record());
  EXPECT_TRUE(model.finish().empty());
  EXPECT_EQ(bytes(model.record()), before);
}

TEST(FinishRule, FinishingTwiceChangesNothingMore) {
  const Scan scan = scanned("plate3", 10000, 0, Order::shuffled);
  Model model = modelled(scan.parameters, scan.points);
  const auto record = model.record();
  model.finish();
  EXPECT_EQ(model.record().polygon_segments.size(), record.polygon_segments.size());
  EXPECT_EQ(holes_of(model.record()), holes_of(record));
}

TEST(ThesisRules, KeepThePromise) {
  for (const char* shape : {"cube", "L", "thin_plate:0.25"})
    for (const double noise : {0.0, 0.001}) {
      Scan scan = scanned(shape, 2000, noise, Order::shuffled);
      scan.parameters.rules = Rules::thesis();
      const ModelRecord record = judged(scan.parameters, scan.points, 26);
      EXPECT_EQ(record.parameters.rules.to_string(), "thesis");
      EXPECT_EQ(points_in_segments(record), record.points);
      EXPECT_GE(record.polygon_segments.size(), 1u);
      EXPECT_EQ(holes_of(record), 0u);
    }
}

TEST(EachRule, LeftOutAloneKeepsThePromise) {
  for (const auto& name : Rules::names()) {
    Scan scan = scanned("L", 3000, 0.001, Order::shuffled);
    scan.parameters.rules = Rules::parse("-" + name);
    const ModelRecord record = judged(scan.parameters, scan.points, 50);
    EXPECT_EQ(("," + record.parameters.rules.to_string() + ",").find("," + name + ","), std::string::npos);
    EXPECT_GE(record.polygon_segments.size(), 4u) << name;
  }
}

}  // namespace
}  // namespace limpet::model
