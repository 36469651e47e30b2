// Copyright the limpet authors. GPL-3.0-or-later.
//
// Damaged models and meshes, given to what is behind `draw`, `check`, `compare` and `--initial`, in this
// process: each is taken or refused in one line, in little time and memory; none of them shows a bug.
#include <fcntl.h>
#include <sys/resource.h>

#include <ctime>
#include <functional>
#include <limpet/app/arguments.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/mesh_writer.hpp>
#include <limpet/simulation/initial_faces.hpp>
#include <utility>

#include "../model/streams.hpp"
#include "../sanitized.hpp"
#include "../temporary_folder.hpp"
#include "mutants.hpp"

namespace limpet::app {
namespace {

using model::testing::scanned;
using simulation::ScanOptions;

constexpr std::uint64_t kSlower = kSanitized ? 10 : 1;
constexpr double kLongest = 5 * kSlower;  ///< seconds of processor time
constexpr long kMostMemory = 1L << 20;    ///< KiB, of the whole program
constexpr unsigned kGivenUpAfter = 120;  ///< seconds; then the mutant's file is left for whoever looks for it

/// What a command printed is not asked for.
class Silence {
 public:
  Silence() : kept_(::dup(STDOUT_FILENO)) {
    std::fflush(stdout);
    const int nothing = ::open("/dev/null", O_WRONLY);
    ::dup2(nothing, STDOUT_FILENO);
    ::close(nothing);
  }
  ~Silence() {
    std::fflush(stdout);
    ::dup2(kept_, STDOUT_FILENO);
    ::close(kept_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int kept_;
};

class DamagedModels : public limpet::testing::TemporaryFolder {
 protected:
  /// Did the command take what it was given? Anything that main() would call a bug fails the test.
  bool taken(const std::string& command, const std::function<void()>& run) {
    const std::clock_t start = std::clock();
    bool done = false;
    std::string refusal = "-";
    ::alarm(kGivenUpAfter);
    try {
      const Silence silence;
      run();
      done = true;
    } catch (const UsageError& error) {
      refusal = error.what();
    } catch (const io::InputError& error) {
      refusal = error.what();
    } catch (const simulation::MeshError& error) {
      refusal = error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << command << ": a bug in limpet: " << error.what();
    }
    ::alarm(0);
    EXPECT_FALSE(refusal.empty()) << command;
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << command << ": " << refusal;
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_LT(seconds, kLongest) << command;
    longest_ = std::max(longest_, seconds);
    return done;
  }

  bool draws(const std::string& file, const char* extension) {
    DrawArguments args;
    args.models = {file};
    args.picture = path(std::string("p.") + extension);
    args.width = 300;
    args.quiet = true;
    return taken("draw", [&] { run(args); });
  }
  bool compares(const std::string& model, const std::string& truth) {
    CompareArguments args;
    args.model = model;
    args.truth = truth;
    args.json = path("c.json");
    args.quiet = true;
    return taken("compare", [&] { run(args); });
  }
  bool checks(const std::string& file) {
    int code = kBadInput;
    taken("check", [&] { code = run(CheckArguments{.model = file, .json = "", .quiet = true}); });
    return code == kDone;
  }
  /// As faces known beforehand; what is taken keeps the laws.
  bool is_known_beforehand(const std::string& mesh) {
    return taken("--initial", [&] {
      model::Model model(model::testing::of_resolution(0.1));
      try {
        model.add_initial(simulation::initial_faces(simulation::load_mesh(mesh)));
      } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
      }
      model.update(std::vector<model::SensorPoint>{{{0.5, 0.5, 1.02}, {0, 0, -1}, 0}});
      // Each pair of faces that cross is looked at, and bytes that have moved make hundreds that all do.
      if (model.counts().polygons < 200) model.finish();
      EXPECT_EQ(model::testing::broken_laws(model.record()), "");
    });
  }

  /// Goes through the mutants of these files; `LIMPET_MUTANTS` says how many, `LIMPET_SEED` from which on.
  void for_each_mutant(const std::vector<std::pair<std::string, std::string>>& originals,
                       std::uint64_t usually,
                       const std::function<void(const std::string& file, std::uint64_t seed)>& judge) {
    const std::uint64_t first = model::testing::wanted("LIMPET_SEED", 20261129),
                        count = model::testing::wanted("LIMPET_MUTANTS", usually / kSlower);
    RecordProperty("seed", std::to_string(first));
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
      const auto& [name, bytes] = originals[seed % originals.size()];
      SCOPED_TRACE("LIMPET_SEED=" + std::to_string(seed) + " LIMPET_MUTANTS=1, of " + name);
      const bool failed_before = HasFailure();
      const std::string file = write("mutant" + name.substr(name.rfind('.')), testing::Mutator(seed)(bytes));
      judge(file, seed);
      if (!failed_before && HasFailure())
        std::filesystem::copy_file(file, std::filesystem::temp_directory_path() / ("limpet-failing-" + name),
                                   std::filesystem::copy_options::overwrite_existing);
    }
    struct rusage used = {};
    ::getrusage(RUSAGE_SELF, &used);
    std::printf("%llu mutants from seed %llu on; longest command %.2f s; %ld MiB at most\n",
                static_cast<unsigned long long>(count), static_cast<unsigned long long>(first), longest_,
                used.ru_maxrss >> 10);
    EXPECT_LT(used.ru_maxrss, kMostMemory);
  }

  double longest_ = 0;  ///< seconds
};

/// Models of several kinds: finished, unfinished, open, with growing noise, with faces known beforehand.
std::vector<model::ModelRecord> models() {
  std::vector<model::ModelRecord> all;
  const auto add = [&](const std::string& shape, int points, bool finish,
                       const std::function<void(model::Parameters&)>& change = {}) {
    auto scan = scanned(shape, points, 0.001, ScanOptions::Order::shuffled);
    if (change) change(scan.parameters);
    for (auto& p : scan.points) p.range = 1;
    model::Model model(scan.parameters);
    if (shape == "L") {
      const auto mesh = simulation::make_scene(shape).mesh;
      model.add_initial(simulation::initial_faces(mesh, {0, 1}));
    }
    model::testing::feed(model, scan.points);
    if (finish) model.finish();
    all.push_back(model.record());
  };
  add("cube", 1000, true);
  add("open_box", 600, false);
  add("plate3", 1500, true, [](auto& p) { p.neighbours = false; });
  add("L", 800, true);
  add("octahedron", 800, true, [](auto& p) { p.noise_per_range = 0.0005; });
  add("step_hole", 1500, false, [](auto& p) { p.rules = model::Rules::thesis(); });
  return all;
}

TEST_F(DamagedModels, NativeFiles) {
  std::vector<std::pair<std::string, std::string>> originals;
  for (const model::ModelRecord& record : models()) {
    originals.emplace_back("m" + std::to_string(originals.size()) + ".limpet", model::testing::bytes(record));
    const std::string whole = write(originals.back().first, originals.back().second);
    ASSERT_TRUE(draws(whole, "png") && compares(whole, "cube") && checks(whole)) << whole;
  }
  int drawn = 0, sound = 0;
  for_each_mutant(originals, 200, [&](const std::string& file, std::uint64_t seed) {
    const bool is_drawn = draws(file, seed % 2 == 0 ? "png" : "svg"), is_sound = checks(file);
    if (seed % kSlower == 0) {
      EXPECT_EQ(compares(file, "cube"), is_drawn);
    }
    drawn += is_drawn;
    sound += is_sound;
  });
  std::printf("%d drawn, %d sound\n", drawn, sound);
}

TEST_F(DamagedModels, Meshes) {
  std::vector<std::pair<std::string, std::string>> originals;
  const auto add = [&](const std::string& name) {
    originals.emplace_back(name, read(path(name)));
    EXPECT_TRUE(compares(path(name), "cube")) << name;
  };
  const auto records = models();
  for (const char* extension : {"off", "ply", "obj", "stl"})
    for (const int which : {0, 2, 5}) {
      const std::string name = "s" + std::to_string(which) + "." + extension;
      io::save_mesh(path(name), records[static_cast<std::size_t>(which)]);
      add(name);
    }
  write("text.stl",
        "solid t\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "endloop\nendfacet\nendsolid t\n");
  add("text.stl");
  int compared = 0, known = 0;
  for_each_mutant(originals, 150, [&](const std::string& file, std::uint64_t seed) {
    if (seed % kSlower == 0)
      compared += seed % 7 < 4 ? compares(file, "cube") : compares(path("s0.off"), file);
    draws(file, seed % 2 == 0 ? "svg" : "png");
    known += is_known_beforehand(file);
  });
  std::printf("%d compared, %d known beforehand\n", compared, known);
}

}  // namespace
}  // namespace limpet::app
