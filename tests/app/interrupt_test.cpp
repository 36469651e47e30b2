// Copyright the limpet authors. GPL-3.0-or-later.
//
// A signal ends a run with the model so far; a second one ends it at once.
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "program.hpp"

namespace limpet::app {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

class Interrupt : public testing::ProgramTest {
 protected:
  /// Ends by itself within the time; otherwise it is killed, and the test fails.
  testing::Result finish_within(pid_t child, milliseconds limit) {
    const auto end = Clock::now() + limit;
    while (::kill(child, 0) == 0 && Clock::now() < end) {
      siginfo_t state = {};
      if (::waitid(P_PID, static_cast<id_t>(child), &state, WEXITED | WNOHANG | WNOWAIT) == 0 &&
          state.si_pid == child)
        return finish(child);
      std::this_thread::sleep_for(milliseconds(5));
    }
    ADD_FAILURE() << "it goes on after " << limit.count() << " ms";
    ::kill(child, SIGKILL);
    return finish(child);
  }

  void wait_for_words(const std::string& words) {
    for (int i = 0; i < 1000 && read(path("stderr")).find(words) == std::string::npos; ++i)
      std::this_thread::sleep_for(milliseconds(5));
  }
};

/// The scan comes through a pipe that stays open, so the program waits for more.
TEST_F(Interrupt, WritesWhatThereIs) {
  const std::string scan_file = scan("c.xyz", "cube", 3000);
  const std::string text = read(scan_file);
  const auto points = std::count(text.begin(), text.end(), '\n') - std::count(text.begin(), text.end(), '#');
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    for (const bool named : {false, true}) {
      const pid_t child = start({"model", named ? path("pipe") : "-", "-o", path("m.limpet"), "--resolution",
                                 "0.1", "--noise", "0", "--order", "arrival", "--json", path("s.json")},
                                {"", {}, named ? "" : path("pipe")});
      std::ofstream pipe(path("pipe"), std::ios::binary);
      pipe << read(scan_file) << "0.25 0.5" << std::flush;  // the last line is not whole
      std::this_thread::sleep_for(milliseconds(700));
      ASSERT_EQ(::kill(child, signal), 0);
      const auto result = finish_within(child, milliseconds(5000));
      EXPECT_EQ(result.code, 1) << result.err;
      EXPECT_NE(result.err.find("interrupted"), std::string::npos) << result.err;
      EXPECT_EQ(result.error_lines(), 1) << result.err;
      const auto json = nlohmann::json::parse(read(path("s.json")));
      EXPECT_EQ(json["points"], points);
      EXPECT_EQ(json["interrupted"], true);
      EXPECT_EQ(run({"check", path("m.limpet")}).code, 0);
    }
}

/// A scan that is put in order is read to its end before anything is modelled.
TEST_F(Interrupt, WhileAScanIsPutInOrderWritesNothing) {
  const std::string scan_file = scan("c.xyz", "cube", 3000);
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const pid_t child =
      start({"model", path("pipe"), "-o", path("m.limpet"), "--resolution", "0.1", "--noise", "0"});
  std::ofstream pipe(path("pipe"), std::ios::binary);
  pipe << read(scan_file) << std::flush;
  std::this_thread::sleep_for(milliseconds(300));
  ASSERT_EQ(::kill(child, SIGINT), 0);
  const auto result = finish_within(child, milliseconds(5000));
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_EQ(result.error_lines(), 1) << result.err;
  EXPECT_NE(result.err.find("--order arrival"), std::string::npos) << result.err;
  EXPECT_FALSE(exists("m.limpet"));
}

TEST_F(Interrupt, APipeThatNobodyWritesToIsNotWaitedForEver) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const pid_t child = start({"model", path("pipe"), "-o", path("m.limpet")});
  std::this_thread::sleep_for(milliseconds(300));
  ASSERT_EQ(::kill(child, SIGTERM), 0);
  const auto result = finish_within(child, milliseconds(5000));
  EXPECT_GT(result.code, 0) << result.err;
  EXPECT_EQ(result.error_lines(), 1) << result.err;
  EXPECT_FALSE(exists("m.limpet"));
}

TEST_F(Interrupt, ASecondSignalEndsAtOnce) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  // The output is a pipe that nobody reads, so that the end of the run takes for ever.
  ASSERT_EQ(::mkfifo(path("labels").c_str(), 0600), 0);
  const pid_t child = start({"model", "-", "-o", path("m.limpet"), "--resolution", "0.1", "--noise", "0",
                             "--order", "arrival", "--labels", path("labels")},
                            {"", {}, path("pipe")});
  std::ofstream pipe(path("pipe"), std::ios::binary);
  pipe << read(scan("c.xyz", "cube", 3000)) << std::flush;
  std::this_thread::sleep_for(milliseconds(700));
  ASSERT_EQ(::kill(child, SIGINT), 0);
  std::this_thread::sleep_for(milliseconds(700));
  ASSERT_EQ(::kill(child, SIGTERM), 0);
  EXPECT_EQ(finish_within(child, milliseconds(5000)).code, -SIGTERM);
}

/// At random moments, of reading, modelling, finishing and writing.
TEST_F(Interrupt, AtAnyMomentTheModelIsWhole) {
  const std::string scan_file = scan("s.ply", "sphere:32", 15'000, {"--noise", "0.01"});
  const std::vector<std::string> words = {"model",   scan_file, "-o", path("m.limpet"), "--resolution", "0.2",
                                          "--noise", "0.006",   "-q"};
  const auto begin = Clock::now();
  ASSERT_EQ(run(words).code, 0);
  const auto whole = std::chrono::duration_cast<milliseconds>(Clock::now() - begin);
  std::mt19937 random(7);
  int interrupted = 0;
  for (int i = 0; i < 20; ++i) {
    std::filesystem::remove(path("m.limpet"));
    const pid_t child = start(words);
    std::this_thread::sleep_for(whole * std::uniform_int_distribution<>(0, 1000)(random) / 1000);
    ::kill(child, i % 2 == 0 ? SIGINT : SIGTERM);
    const auto result = finish_within(child, milliseconds(20'000));
    if (result.code < 0) continue;  // before signals are caught: nothing has been read yet
    ASSERT_TRUE(result.code == 0 || result.code == 1) << result.code << result.err;
    interrupted += result.code;
    if (result.err.find("nothing is written") == std::string::npos)
      EXPECT_EQ(run({"check", path("m.limpet")}).code, 0) << result.err;
    else
      EXPECT_FALSE(exists("m.limpet"));
  }
  EXPECT_GT(interrupted, 5) << "of a run of " << whole.count() << " ms";
}

/// What a run that is ended in finish() kept is what it had read: it goes on to the same bytes.
TEST_F(Interrupt, ACheckpointHoldsTheStateBeforeFinishing) {
  const std::string scan_file = scan("c.ply", "step_hole", 5000, {"--noise", "0.002"});
  const std::vector<std::string> words = {"model",        scan_file, "-o",       path("m.limpet"),
                                          "--resolution", "0.1",     "--noise",  "0.002",
                                          "--checkpoint", path("c"), "--resume", "-q"};
  ASSERT_EQ(run(words).code, 0);
  const std::string first = read(path("m.limpet"));
  std::filesystem::remove(path("m.limpet"));
  ASSERT_EQ(run(words).code, 0);
  EXPECT_EQ(read(path("m.limpet")), first);
}

TEST_F(Interrupt, FollowingEndsWithTheModelSoFar) {
  const pid_t child = start({"follow", "cube", "-o", path("m.limpet"), "--record", path("r"), "--json",
                             path("s.json"), "--resolution", "0.02"});
  std::this_thread::sleep_for(milliseconds(1500));
  ASSERT_EQ(::kill(child, SIGHUP), 0);
  const auto result = finish_within(child, milliseconds(20'000));
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_NE(result.err.find("the model so far is written"), std::string::npos) << result.err;
  EXPECT_EQ(nlohmann::json::parse(read(path("s.json")))["ended"], "interrupted");
  EXPECT_EQ(run({"check", path("m.limpet")}).code, 0);
  EXPECT_EQ(run({"follow", "--replay", path("r"), "-o", path("n.limpet")}).code, 1) << "it is not complete";
}

}  // namespace
}  // namespace limpet::app
