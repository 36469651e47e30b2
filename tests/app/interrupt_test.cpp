// Copyright the limpet authors. GPL-3.0-or-later.
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <thread>

#include "program.hpp"

namespace limpet::app {
namespace {

using Interrupt = testing::ProgramTest;

/// The scan comes through a pipe that stays open, so the program waits for more.
TEST_F(Interrupt, WritesWhatThereIs) {
  const std::string scan_file = scan("c.xyz", "cube", 3000);
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const pid_t child = start(
      {"model", "-", "-o", path("m.limpet"), "--resolution", "0.1", "--noise", "0", "--json", path("s.json")},
      {"", {}, path("pipe")});
  std::ofstream pipe(path("pipe"), std::ios::binary);
  pipe << read(scan_file) << std::flush;
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  ASSERT_EQ(::kill(child, SIGINT), 0);
  const auto result = finish(child);
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_NE(result.err.find("interrupted"), std::string::npos) << result.err;
  EXPECT_EQ(result.error_lines(), 1) << result.err;
  const auto json = nlohmann::json::parse(read(path("s.json")));
  EXPECT_GT(json["points"], 2000);
  EXPECT_EQ(json["interrupted"], true);
  EXPECT_EQ(run({"check", path("m.limpet")}).code, 0);
}

}  // namespace
}  // namespace limpet::app
