// Copyright the limpet authors. GPL-3.0-or-later.
//
// Scans with a few bytes changed, cut or doubled: modelled or refused, never a crash.
#include <limpet/survey/random.hpp>

#include "../fuzz/tokens.hpp"
#include "program.hpp"

namespace limpet::app {
namespace {

class Mutation : public testing::ProgramTest {
 protected:
  static std::string mutate(std::string bytes, survey::Random& random) {
    const auto times = 1 + random.below(3);
    for (std::uint64_t i = 0; i < times && !bytes.empty(); ++i) {
      // Half of the damage is done to the header, where most of the meaning is.
      const auto reach = random.below(2) == 0 ? std::min<std::size_t>(bytes.size(), 400) : bytes.size();
      const auto at = random.below(reach);
      const auto length = 1 + random.below(16);
      switch (random.below(9)) {
        case 0:
          bytes.resize(std::max<std::size_t>(at, 1));
          break;
        case 1:
        case 2:
          bytes.erase(at, length);
          break;
        case 3:
        case 4:
          bytes.insert(at, bytes.substr(at, length));
          break;
        case 5:
          bytes[at] = static_cast<char>(random.below(256));
          break;
        default:
          bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
          break;
      }
    }
    return bytes;
  }
};

TEST_F(Mutation, TwoHundredScans) {
  const std::uint64_t seed = 20240607;
  RecordProperty("seed", std::to_string(seed));
  std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
  survey::Random random(seed);
  const std::vector<std::string> whole = {
      read(scan("binary.ply", "cube", 400)), read(scan("ascii.ply", "cube", 200, {"--ascii"})),
      read(scan("table.xyz", "cube", 200)),
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 4\nHEIGHT 1\n"
      "VIEWPOINT 0 0 5 1 0 0 0\nPOINTS 4\nDATA ascii\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n"};
  const std::vector<std::string> extensions = {"ply", "ply", "xyz", "pcd"};
  int modelled = 0;
  for (int i = 0; i < 200; ++i) {
    const auto kind = static_cast<std::size_t>(i) % whole.size();
    const auto name = write("mutant." + extensions[kind], mutate(whole[kind], random));
    const auto result =
        run({"model", name, "-o", path("m.limpet"), "--resolution", "0.3", "--noise", "0", "-q"});
    const bool known = result.code == 0 || result.code == 2;
    EXPECT_TRUE(known) << "mutant " << i << " of seed " << seed << ": " << result.code << " " << result.err;
    // At most the warnings of no axes and of too few points, and the error itself.
    EXPECT_LE(result.error_lines(), 3) << result.err;
    modelled += result.code == 0;
  }
  std::printf("%d of 200 were modelled\n", modelled);
  EXPECT_GT(modelled, 10);
}

/// Recorded runs without their digest, so that what still has the form of a run reaches the model.
TEST_F(Mutation, TwoHundredRuns) {
  ASSERT_EQ(
      run({"follow", "cube", "-q", "-o", path("m.limpet"), "--max-sets", "12", "--record", path("r.run")})
          .code,
      1);
  std::string whole = read(path("r.run"));
  whole = whole.substr(0, whole.rfind(' ')) + " -\n";
  const std::uint64_t seed = 20261128;
  survey::Random random(seed);
  fuzz::TokenMutator by_tokens(seed);
  int replayed = 0;
  for (int i = 0; i < 200; ++i) {
    const std::string mutant = i % 2 == 0 ? by_tokens(whole) : mutate(whole, random);
    const auto result =
        run({"follow", "--replay", write("mutant.run", mutant), "-o", path("again.limpet"), "-q"});
    const bool known = result.code == 1 || result.code == 2;
    EXPECT_TRUE(known) << "mutant " << i << ": " << result.code << " " << result.err;
    EXPECT_LE(result.error_lines(), 2) << "mutant " << i << ": " << result.err;
    EXPECT_EQ(result.err.find("bug"), std::string::npos) << "mutant " << i << ": " << result.err;
    EXPECT_EQ(result.err.find("broken after"), std::string::npos) << "mutant " << i << ": " << result.err;
    replayed += result.code == 1;
  }
  std::printf("%d of 200 were replayed\n", replayed);
  EXPECT_GT(replayed, 10);
}

}  // namespace
}  // namespace limpet::app
