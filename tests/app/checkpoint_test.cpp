// Copyright the limpet authors. GPL-3.0-or-later.
//
// A run killed at any moment and resumed gives the bytes of the uninterrupted one; what does not fit together
// is refused in one line.
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include <limpet/survey/random.hpp>

#include "program.hpp"

namespace limpet::app {
namespace {

using Words = std::vector<std::string>;
using Clock = std::chrono::steady_clock;

class Checkpoints : public testing::ProgramTest {
 protected:
  /// `limpet model SCAN` into NAME.limpet, NAME.txt and three stages, all of which must come out the same.
  Words command(const std::string& scan, const std::string& name, const Words& more = {}) const {
    Words words{"model",    scan, "-q", "-o", path(name + ".limpet"), "--labels", path(name + ".txt"),
                "--stages", "3"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// The same with checkpoints, going on from what there is.
  Words resumed(const std::string& scan, const std::string& name, const Words& more = {}) const {
    Words words =
        command(scan, name, {"--checkpoint", path("run.checkpoint"), "--checkpoint-every", "40", "--resume"});
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  void expect_same_results(const std::string& a, const std::string& b) const {
    for (const std::string end : {".limpet", ".txt", ".stage1.limpet", ".stage2.limpet", ".stage3.limpet"}) {
      EXPECT_FALSE(read(path(a + end)).empty()) << a + end;
      EXPECT_TRUE(read(path(a + end)) == read(path(b + end))) << end;
    }
  }
  void remove(const std::string& name) const { std::filesystem::remove(path(name)); }

  /// A checkpoint of a run that was killed after it had written one.
  std::string left_by_a_killed_run(const std::string& scan, const Words& more = {}) const {
    for (int milliseconds = 20;; milliseconds += 10) {
      const pid_t child = start(resumed(scan, "killed", more));
      const auto until = Clock::now() + std::chrono::milliseconds(milliseconds);
      while (!exists("run.checkpoint") && Clock::now() < until) pause(1);
      ::kill(child, SIGKILL);
      const auto result = finish(child);
      if (exists("run.checkpoint")) return read(path("run.checkpoint"));
      if (result.code == -SIGKILL) continue;
      ADD_FAILURE() << "it ended by itself, without a checkpoint: " << result.err;
      return {};
    }
  }
  static void pause(std::int64_t milliseconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  }

  /// Kills and resumes until it is done; returns the number of kills.
  int killed_again_and_again(const Words& words, survey::Random& random, double seconds) const {
    for (int kills = 0;; ++kills) {
      const pid_t child = start(words);
      std::this_thread::sleep_for(std::chrono::duration<double>(random.uniform(0, seconds)));
      ::kill(child, SIGKILL);
      const auto result = finish(child);
      if (result.code != -SIGKILL) {
        EXPECT_EQ(result.code, 0) << result.err;
        return kills;
      }
      EXPECT_LE(result.error_lines(), 1) << result.err;  // that there was no checkpoint yet
    }
  }
  /// Until so many kills have been tried: LIMPET_KILLS, else `kills`.
  void expect_same_however_often_killed(const std::string& scan, int kills, const Words& more = {}) const {
    const auto start = Clock::now();
    ASSERT_EQ(run(command(scan, "whole", more)).code, 0);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (const char* text = std::getenv("LIMPET_KILLS")) kills = std::atoi(text);
    survey::Random random(1);
    int tried = 0, runs = 0;
    while (tried < kills && !HasFailure()) {
      remove("run.checkpoint");
      tried += killed_again_and_again(resumed(scan, "again", more), random, 0.8 * seconds);
      expect_same_results("whole", "again");
      ++runs;
    }
    std::printf("%d kills in %d runs\n", tried, runs);
    RecordProperty("kills", tried);
  }
};

TEST_F(Checkpoints, KilledAtAnyMomentAndResumedGivesTheSameBytes) {
  expect_same_however_often_killed(
      scan("s.ply", "step_hole", 100'000, {"--noise", "0.002", "--outliers", "0.01"}), 20);
  // Aside names are gone with the process where files can be without a name; else they are left.
  const int unnamed = ::open(path("").c_str(), O_TMPFILE | O_WRONLY, 0666);
  if (unnamed < 0) return;
  ::close(unnamed);
  const auto left = names();
  EXPECT_LE(std::count_if(left.begin(), left.end(), [](const auto& n) { return n.find(".part") != n.npos; }),
            1);
}

TEST_F(Checkpoints, OfGuessedAxesGiveTheSameBytes) {
  std::string bare;
  std::istringstream text(read(scan("s.xyz", "L", 30'000, {"--noise", "0.002"})));
  for (std::string line; std::getline(text, line);) {
    std::istringstream numbers(line);
    std::string x, y, z;
    numbers >> x >> y >> z;
    if (line.starts_with("#"))
      bare += "# x y z\n";
    else
      bare.append(x).append(" ").append(y).append(" ").append(z).append("\n");
  }
  const std::string scan_file = write("bare.xyz", bare);
  ASSERT_EQ(run(command(scan_file, "whole")).code, 0);
  left_by_a_killed_run(scan_file);
  EXPECT_EQ(run(resumed(scan_file, "again")).code, 0);
  expect_same_results("whole", "again");
}

TEST_F(Checkpoints, OfInitialFacesAndRecordsThatAreNoPointGiveTheSameBytes) {
  std::string text = read(scan("s.xyz", "cube", 30'000));
  for (std::size_t at = text.size() / 4; at < text.size(); at += text.size() / 7)
    text.insert(text.find('\n', at) + 1, "nan 0 0 0 0 1\n1 2 3 0 0 0\n");
  const std::string scan_file = write("n.xyz", text);
  const Words initial{"--initial", write("t.off", "OFF\n3 1 0\n5 0 0\n6 0 0\n5 1 0\n3 0 1 2\n")};
  ASSERT_EQ(run(command(scan_file, "whole", initial)).code, 0);
  left_by_a_killed_run(scan_file, initial);
  EXPECT_EQ(run(resumed(scan_file, "again", initial)).code, 0);
  expect_same_results("whole", "again");
  write("t.off", "OFF\n3 1 0\n5 0 0\n6 0 0\n5 2 0\n3 0 1 2\n");
  expect_refused(run(resumed(scan_file, "again", initial)), "--initial");
}

TEST_F(Checkpoints, MakeNoDifferenceToARunThatIsNotStopped) {
  const std::string scan_file = scan("s.ply", "cube", 20'000);
  ASSERT_EQ(run(command(scan_file, "whole")).code, 0);
  const auto first = run(resumed(scan_file, "again"));
  EXPECT_EQ(first.code, 0);
  EXPECT_EQ(first.error_lines(), 1) << first.err;
  EXPECT_NE(first.err.find("no checkpoint yet"), std::string::npos) << first.err;
  expect_same_results("whole", "again");
  const auto second = run(resumed(scan_file, "again"));  // what is done is done again from the last one
  EXPECT_EQ(second.code, 0);
  EXPECT_EQ(second.err, "");
  expect_same_results("whole", "again");
}

TEST_F(Checkpoints, AreWrittenOnASignalAtTheLastWholeSet) {
  const std::string scan_file = scan("s.xyz", "cube", 20'000), whole = read(scan_file);
  const Words given{"--resolution", "0.05", "--noise", "0", "--set-size", "300", "--order", "arrival"};
  ASSERT_EQ(run(command("-", "whole", given), {"", {}, scan_file}).code, 0);
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const Words words = resumed("-", "again", given);
  const pid_t child = start(words, {"", {}, path("pipe")});
  const int pipe = ::open(path("pipe").c_str(), O_WRONLY);
  const std::size_t half = whole.size() / 2;  // in the middle of a record
  ASSERT_EQ(::write(pipe, whole.data(), half), static_cast<ssize_t>(half));
  for (int left = 1; left > 0; pause(10)) ASSERT_EQ(::ioctl(pipe, FIONREAD, &left), 0);
  pause(300);  // to model what it has read
  ASSERT_EQ(::kill(child, SIGTERM), 0);
  const auto result = finish(child);
  ::close(pipe);
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_TRUE(exists("again.limpet"));
  EXPECT_EQ(run({"check", path("again.limpet")}).code, 0);
  ASSERT_TRUE(exists("run.checkpoint"));
  EXPECT_EQ(run(words, {"", {}, scan_file}).code, 0);
  expect_same_results("whole", "again");
}

TEST_F(Checkpoints, OfAnotherScanAreRefused) {
  const std::string scan_file = scan("s.ply", "step_hole", 60'000, {"--noise", "0.002"});
  const Words given{"--resolution", "0.05"};
  const std::string kept = left_by_a_killed_run(scan_file, given);
  const auto refused = [&](const std::string& other, const std::string& part) {
    expect_refused(run(resumed(other, "again", given)), part);
    EXPECT_FALSE(exists("again.limpet"));
    EXPECT_TRUE(read(path("run.checkpoint")) == kept);
  };
  refused(scan("t.ply", "step_hole", 60'000, {"--noise", "0.002", "--seed", "2"}), "t.ply: is not the scan");
  refused(scan("short.ply", "step_hole", 50), "short.ply: is not the scan");
  std::string bytes = read(scan_file);
  bytes[bytes.find("end_header") + 200] ^= 1;
  refused(write("changed.ply", bytes), "changed.ply");
  std::filesystem::rename(scan_file, path("moved.ply"));
  refused(scan_file, "s.ply");  // it has vanished
  EXPECT_EQ(run(resumed(path("moved.ply"), "again", given)).code, 0);
}

TEST_F(Checkpoints, OfOtherOptionsAreRefused) {
  const std::string scan_file = scan("s.ply", "cube", 30'000);
  left_by_a_killed_run(scan_file);
  for (const auto& [option, value] :
       std::vector<std::pair<std::string, std::string>>{{"--resolution", "0.06"},
                                                        {"--noise", "0.1"},
                                                        {"--tolerance", "0.1"},
                                                        {"--angle", "5"},
                                                        {"--set-size", "27"},
                                                        {"--order", "arrival"},
                                                        {"--rules", "-near"},
                                                        {"--redundancy", "1,0.5"},
                                                        {"--check-every", "9"},
                                                        {"--viewpoint", "1,2,3"}}) {
    const auto result = run(resumed(scan_file, "again", {option, value}));
    expect_refused(result, "run.checkpoint: was written with " + option);
  }
  expect_refused(run(resumed(scan_file, "again", {"--open"})), "--open no, and this run has --open yes");
  expect_refused(run(resumed(scan_file, "again", {"--orient"})), "--orient");
  expect_refused(run({"model", scan_file, "-o", path("again.limpet"), "--stages", "3", "--checkpoint",
                      path("run.checkpoint"), "--resume"}),
                 "--labels");
  EXPECT_FALSE(exists("again.limpet"));
}

TEST_F(Checkpoints, ThatAreDamagedAreRefused) {
  const std::string scan_file = scan("s.ply", "cube", 20'000);
  const std::string whole = left_by_a_killed_run(scan_file);
  survey::Random random(5);
  for (int i = 0; i < 24; ++i) {
    std::string bytes = whole;
    const auto at = random.below(i % 2 ? whole.size() : 700);
    if (i % 3 == 0)
      bytes.resize(at);
    else
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
    write("run.checkpoint", bytes);
    expect_refused(run(resumed(scan_file, "again")), "run.checkpoint");
  }
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string bytes = whole;
    bytes.replace(bytes.find(from), from.size(), to);
    write("run.checkpoint", bytes);
    return run(resumed(scan_file, "again"));
  };
  expect_refused(replaced("limpet checkpoint 1", "limpet checkpoint 2"), "was written by limpet");
  expect_refused(replaced("\nprogram ", "\nprogram 9"), "was written by limpet");
  expect_refused(replaced("limpet checkpoint", "timpet checkpoint"), "is no checkpoint");
  EXPECT_FALSE(exists("again.limpet"));
}

TEST_F(Checkpoints, AreNoModels) {
  left_by_a_killed_run(scan("s.ply", "cube", 20'000));
  expect_refused(run({"check", path("run.checkpoint")}), "checkpoint of a run");
  expect_refused(run({"draw", path("run.checkpoint"), "-o", path("m.png")}), "checkpoint of a run");
}

TEST_F(Checkpoints, AreAskedForInFull) {
  const std::string scan_file = scan("s.ply", "cube", 1'000), model = path("m.limpet");
  expect_refused(run({"model", scan_file, "-o", model, "--resume"}), "--checkpoint");
  expect_refused(run({"model", scan_file, "-o", model, "--checkpoint-every", "5"}), "--checkpoint");
  expect_refused(run({"model", scan_file, "-o", model, "--checkpoint", path("c"), "--checkpoint-every", "0"}),
                 "--checkpoint-every");
  expect_refused(run({"model", scan_file, "-o", model, "--checkpoint", path("no/such/c")}), "no/such");
  expect_refused(run({"model", scan_file, "-o", model, "--checkpoint", "/proc/c"}), "/proc/c");
  expect_refused(run({"model", scan_file, "-o", model, "--checkpoint", path("")}), "folder");
  expect_refused(run({"model", scan_file, "-o", model, "--checkpoint", model}), "same file");
  const std::string before = read(scan_file);
  expect_refused(run({"model", scan_file, "-o", model, "--checkpoint", write("mine.txt", "text")}),
                 "mine.txt");
  expect_refused(run({"model", scan_file, "-o", model, "--checkpoint", scan_file}), "same file");
  expect_refused(run({"model", scan_file, "-o", model, "--checkpoint", "/dev/full", "--resume"}),
                 "/dev/full");
  EXPECT_EQ(read(scan_file), before);
  EXPECT_EQ(read(path("mine.txt")), "text");
  EXPECT_FALSE(exists("m.limpet"));
}

TEST_F(Checkpoints, ThatCannotBeWrittenDoNotStopTheRun) {
  const std::string scan_file = scan("s.ply", "cube", 20'000);
  ASSERT_EQ(run(command(scan_file, "whole")).code, 0);
  const auto result =
      run(command(scan_file, "again", {"--checkpoint", "/dev/full", "--checkpoint-every", "40"}));
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.error_lines(), 2) << result.err;  // at once, and in the end
  EXPECT_NE(result.err.find("warning: /dev/full: cannot be written"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("the model is written"), std::string::npos) << result.err;
  expect_same_results("whole", "again");
}

}  // namespace
}  // namespace limpet::app
