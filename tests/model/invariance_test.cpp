// Copyright the limpet authors. GPL-3.0-or-later.
//
// What a model does not depend on.
#include <gtest/gtest.h>

#include <limpet/evaluation/judgement.hpp>
#include <limpet/evaluation/planar_face.hpp>

#include "random_streams.hpp"

namespace limpet::model {
namespace {

using namespace testing;
using Order = simulation::ScanOptions::Order;

Points mapped(Points points, double scale, const Vector3d& shift) {
  for (auto& p : points) p.position = scale * p.position + shift;
  return points;
}

/// Readings on the grid of their model, so that moving them rounds nothing.
Points on_grid(Points points, const Parameters& parameters) {
  const double step = Model(parameters).record().grid_step;
  for (auto& p : points)
    for (int i = 0; i < 3; ++i) p.position[i] = step * std::floor(p.position[i] / step + 0.5);
  return points;
}

ModelRecord model_of(const Stream& stream) {
  Model model(stream.parameters);
  for (const auto& set : stream.sets) model.update(set);
  model.finish();
  return model.record();
}

/// A stream in another unit, all lengths multiplied by `scale`.
Stream in_unit(Stream stream, double scale) {
  stream.parameters.resolution *= scale;
  stream.parameters.noise *= scale;
  stream.parameters.tolerance *= scale;
  for (auto& set : stream.sets) set = mapped(std::move(set), scale, Vector3d::Zero());
  return stream;
}

Scan in_unit(Scan scan, double scale) {
  scan.parameters.resolution *= scale;
  scan.parameters.noise *= scale;
  scan.points = mapped(std::move(scan.points), scale, Vector3d::Zero());
  return scan;
}

TEST(SameBytes, ForTheSameStream) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Stream stream = random_stream(seed);
    EXPECT_EQ(bytes(model_of(stream)), bytes(model_of(stream))) << "seed " << seed;
  }
}

TEST(SameBytes, ForTheSameScan) {
  const Scan scan = scanned("step_hole", 20000, 0.001, Order::shuffled);
  EXPECT_EQ(bytes(modelled(scan.parameters, scan.points).record()),
            bytes(modelled(scan.parameters, scan.points).record()));
}

TEST(SameBytes, WhateverElseIsModelledBetween) {
  const Stream stream = random_stream(7), other = random_stream(8);
  Model model(stream.parameters), beside(other.parameters);
  for (std::size_t i = 0; i < std::max(stream.sets.size(), other.sets.size()); ++i) {
    if (i < stream.sets.size()) model.update(stream.sets[i]);
    if (i < other.sets.size()) beside.update(other.sets[i]);
  }
  model.finish();
  EXPECT_EQ(bytes(model.record()), bytes(model_of(stream)));
}

TEST(SameBytes, WithLabelsKept) {
  const Stream stream = random_stream(9);
  Model model(stream.parameters);
  model.keep_labels();
  for (const auto& set : stream.sets) model.update(set);
  model.finish();
  EXPECT_EQ(bytes(model.record()), bytes(model_of(stream)));
}

/// The same segments, perimeters and sums; only lengths differ.
void expect_same_shape(const ModelRecord& a, const ModelRecord& b, double scale, const std::string& what) {
  ASSERT_EQ(a.next_segment, b.next_segment) << what;
  ASSERT_EQ(a.next_edge, b.next_edge) << what;
  ASSERT_EQ(a.polygon_segments.size(), b.polygon_segments.size()) << what;
  EXPECT_EQ(scale * a.grid_step, b.grid_step) << what;
  for (std::size_t i = 0; i < a.polygon_segments.size(); ++i) {
    const auto &p = a.polygon_segments[i], &q = b.polygon_segments[i];
    EXPECT_EQ(p.id, q.id) << what;
    EXPECT_EQ(p.moments.product, q.moments.product) << what;
    EXPECT_EQ(scale * p.chart_origin, q.chart_origin) << what;
    EXPECT_EQ(p.chart_u, q.chart_u) << what;
    EXPECT_EQ(p.height, q.height) << what;
    ASSERT_EQ(p.cycles.size(), q.cycles.size()) << what;
    for (std::size_t c = 0; c < p.cycles.size(); ++c) {
      ASSERT_EQ(p.cycles[c].size(), q.cycles[c].size()) << what;
      for (std::size_t v = 0; v < p.cycles[c].size(); ++v) {
        EXPECT_EQ(p.cycles[c][v].edge, q.cycles[c][v].edge) << what;
        EXPECT_EQ(p.cycles[c][v].x, q.cycles[c][v].x) << what;
        EXPECT_EQ(p.cycles[c][v].y, q.cycles[c][v].y) << what;
      }
    }
  }
}

TEST(Unit, APowerOfTwoChangesNothingAtAll) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Stream stream = random_stream(seed);
    for (const double scale : {0x1p-10, 0x1p+20})
      expect_same_shape(model_of(stream), model_of(in_unit(stream, scale)), scale,
                        "seed " + std::to_string(seed));
  }
}

TEST(Unit, MetresOrMillimetresGiveTheSameFaces) {
  for (const char* shape : {"cube", "plate3"}) {
    const Scan scan = scanned(shape, 20000, 0.001, Order::shuffled);
    const ModelRecord record = modelled(scan.parameters, scan.points).record();
    for (const double scale : {1e-3, 1e3}) {
      const Scan other = in_unit(scan, scale);
      const ModelRecord scaled = modelled(other.parameters, other.points).record();
      EXPECT_EQ(scaled.polygon_segments.size(), record.polygon_segments.size()) << shape << ' ' << scale;
      EXPECT_EQ(holes_of(scaled), holes_of(record)) << shape << ' ' << scale;
      EXPECT_EQ(broken_laws(scaled), "");
    }
  }
}

TEST(Place, FarAwayGivesTheSamePolygonsWithinAThousandthOfTheResolution) {
  const Vector3d away(1e6, -1e6, 1e3);
  for (const char* shape : {"cube", "L"})
    for (const double noise : {0.0, 0.001}) {
      Scan scan = scanned(shape, 10000, noise, Order::shuffled);
      scan.points = on_grid(scan.points, scan.parameters);
      const double lambda = scan.parameters.resolution;
      const ModelRecord here = modelled(scan.parameters, scan.points).record();
      const ModelRecord there = modelled(scan.parameters, mapped(scan.points, 1, away)).record();
      EXPECT_EQ(broken_laws(there), "");
      auto faces = evaluation::planar_faces(there);
      for (auto& face : faces)
        for (auto& cycle : face.cycles)
          for (auto& v : cycle) v -= away;
      const auto difference = evaluation::compare_boundaries(evaluation::planar_faces(here), faces, lambda);
      EXPECT_TRUE(difference.only_a.empty() && difference.only_b.empty()) << shape << ' ' << noise;
      EXPECT_LT(difference.max_distance, lambda / 1000) << shape << ' ' << noise;
    }
}

double area_of(const evaluation::PlanarFace& face) {
  double area = 0;
  for (const auto& [a, b, c] : evaluation::triangulated(face)) area += (b - a).cross(c - a).norm() / 2;
  return area;
}

/// The same polygons, but for how their borders run: a slit about λ wide may stay open or not, so borders are
/// not compared point by point.
TEST(Order, ShuffledOrRasterGivesTheSameFaces) {
  for (const char* shape : {"cube", "L", "pyramid"})
    for (const double noise : {0.0, 0.002}) {
      const Scan raster = scanned(shape, 20000, noise, Order::raster);
      Points points = raster.points;
      Random random(1);
      shuffle(points, random);
      const auto a = evaluation::planar_faces(modelled(raster.parameters, raster.points).record());
      const auto b = evaluation::planar_faces(modelled(raster.parameters, points).record());
      const auto both = evaluation::compare_boundaries(a, b, raster.parameters.resolution);
      ASSERT_EQ(a.size(), b.size()) << shape << ' ' << noise;
      ASSERT_TRUE(both.only_a.empty() && both.only_b.empty()) << shape << ' ' << noise;
      for (const auto& pair : both.pairs) {
        const auto &p = a[static_cast<std::size_t>(pair.a)], &q = b[static_cast<std::size_t>(pair.b)];
        EXPECT_LT((p.normal - q.normal).norm(), 0.005) << shape << ' ' << noise;
        EXPECT_NEAR(area_of(p) / area_of(q), 1, 0.03) << shape << ' ' << noise;
      }
    }
}

TEST(SetSize, DoesNotChangeTheFaces) {
  const Scan scan = scanned("cube", 10000, 0.001, Order::shuffled);
  for (const std::size_t size : {std::size_t{1}, std::size_t{150}, scan.points.size()})
    EXPECT_EQ(modelled(scan.parameters, scan.points, size).record().polygon_segments.size(), 6u) << size;
}

}  // namespace
}  // namespace limpet::model
