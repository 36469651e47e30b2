// Copyright the limpet authors. GPL-3.0-or-later.
//
// Scans of curved surfaces, which a model of planes follows with facets some λ wide.
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace limpet::app {
namespace {

class CurvedScan : public testing::ProgramTest {
 protected:
  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(read(path(name))); }
};

/// Facets as wide as the noise alone allows overlapped on a third of the sphere of 10⁴ points.
TEST_F(CurvedScan, ASphereIsCoveredOnce) {
  for (const char* points : {"3000", "10000", "30000"}) {
    for (const char* noise : {"0", "0.0005", "0.002"}) {
      SCOPED_TRACE(std::string(points) + " points, noise " + noise);
      const std::string scan = path("s.ply"), made = path("s.limpet");
      ASSERT_EQ(run({"scan", "sphere", "-o", scan, "--points", points, "--order", "sampled", "--noise", noise,
                     "-q"})
                    .code,
                0);
      ASSERT_EQ(run({"model", scan, "-o", made, "--json", path("m.json"), "-q"}).code, 0);
      EXPECT_EQ(run({"check", made, "--scan", scan, "-q"}).code, 0);
      ASSERT_EQ(run({"compare", made, "sphere", "--json", path("c.json"), "-q"}).code, 0);
      const auto compared = json("c.json");
      const double model_area = compared["model_area"], true_area = compared["true_area"],
                   farthest = compared["model_to_truth"]["max"], lambda = json("m.json")["resolution"];
      EXPECT_NEAR(model_area / true_area, 1, 0.08);
      EXPECT_LT(farthest, 1.5 * lambda);
    }
  }
}

}  // namespace
}  // namespace limpet::app
