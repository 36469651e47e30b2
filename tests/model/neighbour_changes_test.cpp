// Copyright the limpet authors. GPL-3.0-or-later.
//
// Who reads the changes knows the neighbours, and a model that is written and read goes on with them.
#include <gtest/gtest.h>

#include <stdexcept>

#include "neighbour_ledger.hpp"
#include "random_streams.hpp"

namespace limpet::model {
namespace {

using namespace testing;

/// Edges of two polygons each, in pairs that know each other; the number of pairs is what the counts say.
std::string asymmetry(const Model& model) {
  const ModelRecord record = model.record();
  const auto partners = partners_of(record), segments = segments_of_edges(record);
  std::string wrong;
  for (const auto& [edge, partner] : partners) {
    const auto back = partners.find(partner);
    if (back == partners.end() || back->second != edge)
      wrong += "edge " + std::to_string(edge) + " is not its partner's\n";
    else if (segments.at(edge) == segments.at(partner))
      wrong += "edge " + std::to_string(edge) + " is shared within a segment\n";
  }
  if (static_cast<std::size_t>(model.counts().shared_edges) * 2 != partners.size()) wrong += "miscounted\n";
  return wrong;
}

TEST(NeighbourChanges, MirrorTheRecordOfKnownShapes) {
  long shared = 0, unshared = 0, corners = 0;
  for (const std::string name : {"cube", "L", "octahedron", "step_hole", "open_box"})
    for (const Order order : {Order::raster, Order::shuffled}) {
      const JudgedScan scan = judged_shape(name, 4'000, 0.002, order);
      Model model(scan.parameters);
      NeighbourLedger ledger;
      for (std::size_t i = 0; i < scan.points.size(); i += 26) {
        const auto set = std::span(scan.points).subspan(i, std::min<std::size_t>(26, scan.points.size() - i));
        const auto& changes = model.update(set);
        ASSERT_EQ(ledger.read(changes, model.record()), "") << name << " set " << i / 26;
        ASSERT_EQ(asymmetry(model), "") << name << " set " << i / 26;
      }
      const auto& changes = model.finish();
      ASSERT_EQ(ledger.read(changes, model.record()), "") << name << " finished";
      ASSERT_EQ(asymmetry(model), "") << name << " finished";
      EXPECT_EQ(ledger.shared() - ledger.unshared(), model.counts().shared_edges) << name;
      shared += ledger.shared(), unshared += ledger.unshared(), corners += ledger.corners();
    }
  EXPECT_GT(shared, 100);
  EXPECT_GT(unshared, 20);
  EXPECT_GT(corners, 60);
}

TEST(NeighbourChanges, MirrorTheRecordOfAnyStream) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Stream stream = random_stream(seed);
    Model model(stream.parameters);
    NeighbourLedger ledger;
    for (std::size_t i = 0; i < stream.sets.size(); ++i) {
      const auto& changes = model.update(stream.sets[i]);
      ASSERT_EQ(ledger.read(changes, model.record()), "") << "seed " << seed << " set " << i;
      ASSERT_EQ(asymmetry(model), "") << "seed " << seed << " set " << i;
    }
    const auto& changes = model.finish();
    ASSERT_EQ(ledger.read(changes, model.record()), "") << "seed " << seed << " finished";
  }
}

ModelRecord read_again(const ModelRecord& record) {
  std::istringstream text(bytes(record));
  return io::read_native(text, "record");
}

TEST(NeighbourRecords, AreTheSameAfterARoundTrip) {
  for (const std::string name : {"cube", "step_hole", "octahedron"}) {
    const JudgedScan scan = judged_shape(name, 8'000, 0.002, Order::shuffled);
    const Model whole = modelled(scan.parameters, scan.points);
    ASSERT_GT(whole.counts().shared_edges, 10) << name;
    const Model again(read_again(whole.record()));
    EXPECT_EQ(bytes(again.record()), bytes(whole.record())) << name;
    EXPECT_EQ(again.counts().shared_edges, whole.counts().shared_edges) << name;
    EXPECT_EQ(again.surfaces(), whole.surfaces()) << name;
    EXPECT_EQ(asymmetry(again), "") << name;
  }
}

TEST(NeighbourRecords, AreGoneOnFrom) {
  for (const std::string name : {"cube", "L", "octahedron"})
    for (const std::size_t part : {2u, 5u}) {
      const JudgedScan scan = judged_shape(name, 6'000, 0.001, Order::shuffled);
      const std::size_t cut = scan.points.size() * part / 7;
      Model model(scan.parameters);
      feed(model, Points(scan.points.begin(), scan.points.begin() + static_cast<std::ptrdiff_t>(cut)));
      const ModelRecord before = model.record();
      Model again(read_again(before));
      ASSERT_EQ(bytes(again.record()), bytes(before)) << name;
      for (std::size_t i = cut; i < scan.points.size(); i += 100) {
        again.update(std::span(scan.points).subspan(i, std::min<std::size_t>(100, scan.points.size() - i)));
        ASSERT_EQ(broken_laws(again.record()), "") << name << " from " << cut << " at " << i;
        ASSERT_EQ(asymmetry(again), "") << name << " from " << cut << " at " << i;
      }
      again.finish();
      ASSERT_EQ(broken_laws(again.record()), "") << name << " from " << cut;
      const auto topology = scan.topology(again.record());
      EXPECT_TRUE(topology.isomorphic) << name << " from " << cut << "\n" << faults_of(topology);
    }
}

/// A finished model may be gone on with, too: more points, and finished again.
TEST(NeighbourRecords, OfFinishedModelsAreGoneOnFrom) {
  const JudgedScan scan = judged_shape("cube", 8'000, 0.001, Order::shuffled);
  Model model(scan.parameters);
  for (std::size_t i = 0; i < scan.points.size(); i += 2'000) {
    feed(model,
         Points(scan.points.begin() + static_cast<std::ptrdiff_t>(i),
                scan.points.begin() + static_cast<std::ptrdiff_t>(std::min(i + 2'000, scan.points.size()))));
    ASSERT_EQ(broken_laws(model.record()), "") << i;
    model.finish();
    ASSERT_EQ(broken_laws(model.record()), "") << i << " finished";
    model = Model(read_again(model.record()));
  }
  EXPECT_TRUE(scan.topology(model.record()).isomorphic);
}

TEST(NeighbourRecords, WithoutAMutualPartnerAreRefused) {
  const JudgedScan scan = judged_shape("cube", 8'000, 0, Order::sampled);
  const ModelRecord sound = modelled(scan.parameters, scan.points).record();
  ASSERT_EQ(partners_of(sound).size(), 24u);
  EXPECT_NO_THROW(Model{sound});
  const auto with = [&](std::size_t edge, std::uint64_t partner) {
    ModelRecord changed = sound;
    changed.polygon_segments[0].cycles[0].at(edge).partner = partner;
    return changed;
  };
  const auto& cycle = sound.polygon_segments[0].cycles[0];
  EXPECT_THROW(Model{with(0, 0)}, std::invalid_argument) << "its partner holds it still";
  EXPECT_THROW(Model{with(0, sound.next_edge)}, std::invalid_argument) << "no such edge";
  EXPECT_THROW(Model{with(0, cycle[1].partner)}, std::invalid_argument) << "another's partner";
  EXPECT_THROW(Model{with(0, cycle[1].edge)}, std::invalid_argument) << "on the same segment";
  EXPECT_THROW(Model{with(0, cycle[0].edge)}, std::invalid_argument) << "itself";
  ModelRecord within = sound;  // two edges of one segment that are each other's
  for (auto& s : within.polygon_segments)
    for (auto& v : s.cycles[0])
      if (v.edge == cycle[0].partner || v.edge == cycle[2].partner) v.partner = 0;
  within.polygon_segments[0].cycles[0][0].partner = cycle[2].edge;
  within.polygon_segments[0].cycles[0][2].partner = cycle[0].edge;
  EXPECT_THROW(Model{within}, std::invalid_argument);
  ModelRecord without = sound;  // a neighbour is missing altogether
  without.polygon_segments.pop_back();
  EXPECT_THROW(Model{without}, std::invalid_argument);
}

/// Readings of a part of a plane, spread evenly: corner + a·u + b·v for a and b from 0 to 1.
Points patch(Random& random, const Vector3d& corner, const Vector3d& u, const Vector3d& v,
             const Vector3d& axis) {
  Points points;
  const auto count = static_cast<int>(u.cross(v).norm() * 3000);  // 30 on λ²
  for (int i = 0; i < count; ++i) {
    const double a = random.uniform(0, 1), b = random.uniform(0, 1);
    points.push_back({corner + a * u + b * v, axis});
  }
  return points;
}

/// Along one side of a floor: a wall, a ramp, the wall again, the ramp again. While the two walls are not
/// known to be one this is in order; when they merge it is not (thesis §2.2, global ordering), though it is
/// the floor's order that is broken, and not the wall's.
TEST(NeighbourOrder, IsKeptWhenNeighboursOfOneSegmentMerge) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const Vector3d down = -y - z, into_ramp = (y - z).normalized();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Points points;
    const auto add = [&](const Points& more) { points.insert(points.end(), more.begin(), more.end()); };
    add(patch(random, {0, 0, 0}, 5.2 * x, 2 * y, -z));              // the floor
    add(patch(random, {0, 0, 0}, 1.2 * x, 1.5 * z, -y));            // wall
    add(patch(random, {2.8, 0, 0}, 1.2 * x, 1.5 * z, -y));          // wall
    add(patch(random, {1.2, 0, 0}, 1.6 * x, 2 * down, into_ramp));  // ramp, below a gap in the wall
    add(patch(random, {4, 0, 0}, 1.2 * x, 2 * down, into_ramp));    // ramp, beside the wall
    add(patch(random, Vector3d(2.8, 0, 0) + 0.6 * down, 1.2 * x, 1.4 * down, into_ramp));
    shuffle(points, random);
    Model model(of_resolution(0.1));
    feed(model, points);
    ASSERT_EQ(broken_laws(model.record()), "");
    const auto pieces = model.counts().polygons;
    const Points between = patch(random, {1.2, 0, 0.6}, 1.6 * x, 0.9 * z, -y);  // the walls are one
    for (std::size_t i = 0; i < between.size(); i += 26) {
      model.update(std::span(between).subspan(i, std::min<std::size_t>(26, between.size() - i)));
      ASSERT_EQ(broken_laws(model.record()), "") << "after " << i << " readings between";
    }
    EXPECT_LT(model.counts().polygons, pieces) << "nothing has merged: not what is tried here";
    model.finish();
    EXPECT_EQ(broken_laws(model.record()), "");
  }
}

}  // namespace
}  // namespace limpet::model
