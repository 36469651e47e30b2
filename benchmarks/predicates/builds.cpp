// Copyright the limpet authors. GPL-3.0-or-later.
#include "builds.hpp"

#include <cstdio>
#include <filesystem>
#include <sstream>

namespace limpet::benchmarks {
namespace {

std::string beside(const std::string& path) {
  const auto here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  return (here / path).lexically_normal().string();
}

}  // namespace

std::string model_program(std::size_t build) {
  return beside(build == 0 ? "../../limpet" : std::string("../../limpet-") + kBuilds[build]);
}

std::string replay_program(std::size_t build) {
  return beside(std::string("limpet_replay_") + kBuilds[build]);
}

std::string operations_program(std::size_t build) {
  const std::string name = "../limpet_perimeter_operations";
  return beside(build == 0 ? name : name + "_" + kBuilds[build]);
}

std::string counted_model_program() { return beside("../../limpet-counted"); }

std::string counted_operations_program() { return beside("../limpet_perimeter_operations_exact-counted"); }

std::vector<Setting> all_settings() {
  std::vector<Setting> all;
  for (const bool general : {true, false})
    for (const char* regime : {"grid", "free", "far"}) all.push_back({regime, general});
  return all;
}

std::vector<Json> told_lines(const std::string& output) {
  std::vector<Json> told;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);)
    if (Json json = Json::parse(line, nullptr, false); json.is_object()) told.push_back(std::move(json));
  return told;
}

void replay_once(std::vector<std::string> command, std::size_t count, std::vector<Json>& so_far) {
  const bool first = so_far.empty();
  if (first) command.push_back("--judge");
  const ChildEnd end = run_program(command, {});
  std::vector<Json> told = told_lines(end.output);
  if (!end.done() || told.size() != count)
    throw std::runtime_error(command[0] + " ended with " + end.how() + " after " +
                             std::to_string(told.size()) + " of " + std::to_string(count) + " cases");
  if (first) {
    so_far = std::move(told);
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
    if (so_far[i].contains("us") && told[i].contains("us"))
      so_far[i]["us"] = std::min(so_far[i]["us"].get<double>(), told[i]["us"].get<double>());
}

std::array<std::vector<Json>, kBuilds.size()> replay_in_turn(const std::string& cases, std::size_t count,
                                                             int rounds, int repeats) {
  std::array<std::vector<Json>, kBuilds.size()> told;
  for (int round = 0; round < rounds; ++round)
    in_turn(round, [&](std::size_t build) {
      replay_once({replay_program(build), "perimeters", cases, "--repeats", std::to_string(repeats)}, count,
                  told[build]);
    });
  return told;
}

}  // namespace limpet::benchmarks
