// Copyright the limpet authors. GPL-3.0-or-later.
//
// Outputs that cannot take what they are given: a full disk, a file that may not grow, a pipe that nobody
// reads. One line, exit code 2, nothing half written under a final name and nothing left beside it.
#include <sys/resource.h>

#include <csignal>

#include "program.hpp"

namespace limpet::app {
namespace {

class FullOutput : public testing::ProgramTest {
 protected:
  /// Runs it where no file may grow beyond `bytes`, as on a full disk. What it says is not limited: a pipe.
  testing::Result run_within(rlim_t bytes, const std::vector<std::string>& arguments) const {
    const struct rlimit small = {bytes, RLIM_INFINITY};
    struct rlimit usual = {};
    ::getrlimit(RLIMIT_FSIZE, &usual);
    ::setrlimit(RLIMIT_FSIZE, &small);
    const auto child = start(arguments);
    ::setrlimit(RLIMIT_FSIZE, &usual);
    return finish(child);
  }
  void expect_only(std::vector<std::string> wanted) const {
    wanted.insert(wanted.end(), {"stderr", "stdout"});
    std::sort(wanted.begin(), wanted.end());
    EXPECT_EQ(names(), wanted);
  }
  /// Runs it with a pipe that nobody reads as its standard output.
  testing::Result run_into_closed_pipe(const std::vector<std::string>& arguments) const {
    int ends[2];
    EXPECT_EQ(::pipe(ends), 0);
    ::close(ends[0]);
    testing::Surroundings around;
    around.output = ends[1];
    const auto child = start(arguments, around);
    ::close(ends[1]);
    return finish(child);
  }
};

TEST_F(FullOutput, ModelIsWholeOrNotThere) {
  const auto scan_file = scan("c.ply", "cube", 2'000);
  for (const std::string name : {"m.limpet", "m.off", "m.ply", "m.obj", "m.stl"}) {
    const auto result = run_within(200, {"model", scan_file, "-q", "-o", path(name)});
    expect_refused(result, "/m.");  // an .obj begins with its .mtl
    expect_only({"c.ply"});
  }
}

TEST_F(FullOutput, OldFilesStayWhenNewOnesDoNotFit) {
  const auto scan_file = scan("c.ply", "cube", 2'000);
  const auto old = write("m.limpet", "old");
  expect_refused(run_within(200, {"model", scan_file, "-q", "-o", old}), "m.limpet");
  EXPECT_EQ(read(old), "old");
  expect_only({"c.ply", "m.limpet"});
}

TEST_F(FullOutput, LabelsSummaryAndCheckpointAreWholeOrNotThere) {
  const auto scan_file = scan("c.ply", "cube", 4'000);
  const std::string device = path("m.limpet");
  std::filesystem::create_symlink("/dev/null", device);
  const std::vector<std::string> model{"model", scan_file, "-q", "-o", device};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), model.begin(), model.end());
    return more;
  };
  expect_refused(run_within(200, with({"--labels", path("l.txt")})), "l.txt");
  expect_only({"c.ply", "m.limpet"});
  expect_refused(run_within(200, with({"--json", path("s.json")})), "s.json");
  expect_only({"c.ply", "m.limpet"});
  const auto result = run_within(200, with({"--checkpoint", path("c"), "--checkpoint-every", "10"}));
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("warning"), std::string::npos) << result.err;
  expect_only({"c.ply", "m.limpet"});
}

TEST_F(FullOutput, ALinkStaysALinkToWhatIsWritten) {
  const auto scan_file = scan("c.ply", "cube", 2'000);
  std::filesystem::create_directory(path("runs"));
  std::filesystem::create_symlink("runs/latest", path("m.limpet"));
  std::filesystem::create_symlink("1.limpet", path("runs/latest"));
  for (int run_number = 0; run_number < 2; ++run_number) {  // the file is not there yet, then it is
    EXPECT_EQ(run({"model", scan_file, "-q", "-o", path("m.limpet")}).code, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(path("m.limpet")));
    EXPECT_TRUE(std::filesystem::is_symlink(path("runs/latest")));
    EXPECT_EQ(run({"check", path("runs/1.limpet")}).code, 0);
  }
}

TEST_F(FullOutput, DevicesThatAreFullAreTold) {
  const auto scan_file = scan("c.ply", "cube", 2'000);
  std::filesystem::create_symlink("/dev/full", path("full.off"));
  expect_refused(run({"model", scan_file, "-q", "-o", path("full.off")}), "full.off");
  expect_refused(run({"model", scan_file, "-q", "-o", path("m.off"), "--labels", "/dev/full"}), "/dev/full");
  expect_refused(run({"model", scan_file, "-q", "-o", path("m.off"), "--json", "/dev/full"}), "/dev/full");
}

TEST_F(FullOutput, ClosedPipesAreTold) {
  const auto scan_file = scan("c.ply", "cube", 2'000);
  const auto of_summary =
      run_into_closed_pipe({"model", scan_file, "-q", "-o", path("m.off"), "--json", "-"});
  expect_refused(of_summary, "standard output");
  const auto of_text = run_into_closed_pipe({"model", scan_file, "-o", path("m.off")});
  expect_refused(of_text, "standard output");
  std::filesystem::create_symlink("/dev/stdout", path("out.limpet"));
  expect_refused(run_into_closed_pipe({"model", scan_file, "-q", "-o", path("out.limpet")}), "out.limpet");
  expect_refused(
      run_into_closed_pipe({"model", scan_file, "-q", "-o", path("m.off"), "--labels", "/dev/stdout"}),
      "/dev/stdout");
  EXPECT_EQ(run_into_closed_pipe({"--version"}).code, 2);
}

}  // namespace
}  // namespace limpet::app
