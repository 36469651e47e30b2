// Copyright the limpet authors. GPL-3.0-or-later.
//
// Solids and planes thrown together at random, scanned coarsely or finely, and finished in between: whatever
// becomes of their neighbours, the oracle finds nothing and the changes tell all.
#include <gtest/gtest.h>

#include "neighbour_ledger.hpp"
#include "solids.hpp"

namespace limpet::model {
namespace {

using namespace testing;

/// How many worlds are scanned: LIMPET_STREAMS, else 20.
const std::uint64_t kWorlds = wanted("LIMPET_STREAMS", 20);

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

/// Returns how many edges are shared in the end.
std::int64_t expect_sound(std::uint64_t seed) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const JudgedScan scan = random_world(random);
  Model model(scan.parameters);
  NeighbourLedger ledger;
  std::string wrong;
  const auto look = [&](const std::vector<Change>& changes) {
    wrong = ledger.read(changes, model.record()) + broken_laws(model.record());
  };
  const auto largest = 20 + random.below(200);
  std::size_t i = 0;
  while (i < scan.points.size() && wrong.empty()) {
    const std::size_t n = std::min<std::size_t>(1 + random.below(largest), scan.points.size() - i);
    look(model.update(std::span(scan.points).subspan(i, n)));
    i += n;
    if (wrong.empty() && random.below(20) == 0) look(model.finish());
  }
  if (wrong.empty()) look(model.finish());
  EXPECT_EQ(wrong, "") << "after " << i << " points";
  return model.counts().shared_edges;
}

TEST(RandomSolids, AreSoundAfterEverySet) {
  std::int64_t shared = 0;
  for (std::uint64_t seed = 1; seed <= kWorlds; ++seed) shared += expect_sound(seed);
  EXPECT_GT(shared, static_cast<std::int64_t>(kWorlds));
}

TEST(RandomSolids, KeepOneConcavityWhenNeighboursMerge) { expect_sound(97); }

}  // namespace
}  // namespace limpet::model
