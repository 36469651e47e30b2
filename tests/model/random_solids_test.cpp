// Copyright the limpet authors. GPL-3.0-or-later.
//
// Solids and planes thrown together at random, scanned coarsely or finely, and finished in between: whatever
// becomes of their neighbours, the oracle finds nothing and the changes tell all.
#include <gtest/gtest.h>

#include <cstdlib>

#include "neighbour_ledger.hpp"
#include "solids.hpp"

namespace limpet::model {
namespace {

using namespace testing;

/// How many worlds are scanned: LIMPET_STREAMS, else 40.
const std::uint64_t kWorlds = [] {
  const char* wanted = std::getenv("LIMPET_STREAMS");
  return wanted ? std::strtoull(wanted, nullptr, 10) : 40;
}();

double quarter(Random& random, int count) {
  return 0.25 * static_cast<double>(random.below(static_cast<std::uint64_t>(count)));
}

/// Something about 1 in size.
Mesh piece(Random& random) {
  switch (random.below(6)) {
    case 0:
      return folded(random.uniform(-170, 170));
    case 1:
      return folded((random.below(2) ? 10 : -10) + random.uniform(-1, 1));
    case 2:
      return wedge(random.uniform(3, 60));
    case 3: {
      const double x = random.uniform(-0.5, 0.5), z = random.uniform(-1, 0);  // a wall through the origin
      return MeshMaker().face({{x, -1, z}, {x, 1, z}, {-x, 1, 1}, {-x, -1, 1}}).make();
    }
    case 4:  // a floor
      return MeshMaker().face({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}).make();
    default:
      return box(Vector3d::Zero(),
                 {0.25 + quarter(random, 4), 0.25 + quarter(random, 4), 0.25 + quarter(random, 4)});
  }
}

JudgedScan random_world(Random& random) {
  MeshMaker maker;
  const auto pieces = 1 + random.below(4);
  for (std::uint64_t i = 0; i < pieces; ++i) {
    Mesh mesh = piece(random);
    const Vector3d at(quarter(random, 8), quarter(random, 8), random.below(2) ? quarter(random, 4) : 0);
    const double turn = random.below(3) ? 0 : random.uniform(0, 6);
    for (auto& p : mesh.vertices) p = Eigen::AngleAxisd(turn, Vector3d::UnitZ()) * p + at;
    if (random.below(8) == 0)
      for (auto& t : mesh.triangles) std::swap(t[0], t[1]);  // seen from inside
    maker.mesh(mesh);
  }
  const double resolution = random.uniform(0.06, 0.3);
  simulation::ScanOptions options;
  options.order = Order::sampled;
  options.points = static_cast<std::int64_t>(300 + random.below(2'500));
  options.outliers = random.below(4) ? 0 : 0.02;
  options.seed = random.next();
  JudgedScan scan =
      judged_scan(maker.make(), resolution, random.below(2) ? 0 : random.uniform(0, resolution / 8), options);
  if (random.below(4) == 0) scan.parameters.tolerance = random.uniform(0, resolution);
  if (random.below(4) == 0) scan.parameters.angle_rad = random.uniform(0.02, 1);
  if (random.below(3) == 0)  // part by part, as a sensor that moves about
    std::sort(scan.points.begin(), scan.points.end(),
              [](const auto& a, const auto& b) { return a.position.x() < b.position.x(); });
  return scan;
}

TEST(RandomSolids, AreSoundAfterEverySet) {
  long shared = 0;
  for (std::uint64_t seed = 1; seed <= kWorlds; ++seed) {
    Random random(seed);
    const JudgedScan scan = random_world(random);
    Model model(scan.parameters);
    NeighbourLedger ledger;
    const auto largest = 20 + random.below(200);
    for (std::size_t i = 0, n = 0; i < scan.points.size(); i += n) {
      n = std::min<std::size_t>(1 + random.below(largest), scan.points.size() - i);
      const auto& changes = model.update(std::span(scan.points).subspan(i, n));
      ASSERT_EQ(ledger.read(changes, model.record()), "") << "seed " << seed << " point " << i;
      ASSERT_EQ(broken_laws(model.record()), "") << "seed " << seed << " point " << i;
      if (random.below(20)) continue;
      const auto& at_last = model.finish();
      ASSERT_EQ(ledger.read(at_last, model.record()), "") << "seed " << seed << " finished at " << i;
      ASSERT_EQ(broken_laws(model.record()), "") << "seed " << seed << " finished at " << i;
    }
    const auto& at_last = model.finish();
    ASSERT_EQ(ledger.read(at_last, model.record()), "") << "seed " << seed << " finished";
    ASSERT_EQ(broken_laws(model.record()), "") << "seed " << seed << " finished";
    shared += model.counts().shared_edges;
  }
  EXPECT_GT(shared, static_cast<long>(kWorlds));
}

}  // namespace
}  // namespace limpet::model
