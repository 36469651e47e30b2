// Copyright the limpet authors. GPL-3.0-or-later.
#include "instructions.hpp"

#include <fstream>

#include "../child.hpp"

namespace limpet::benchmarks {
namespace {

using Words = std::vector<std::string>;

Words joined(Words words, const Words& command) {
  words.insert(words.end(), command.begin(), command.end());
  return words;
}

std::optional<double> by_perf(const Words& command, const std::string& scratch) {
  const std::string counted = scratch + "/perf.csv";
  const ChildEnd end = run_program(
      joined({"perf", "stat", "-x", ",", "-e", "instructions:u", "-o", counted, "--"}, command), {});
  if (!end.done()) return std::nullopt;
  std::ifstream file(counted);
  for (std::string line; std::getline(file, line);)
    if (line.find("instructions") != std::string::npos && line[0] >= '0' && line[0] <= '9')
      return std::stod(line);
  return std::nullopt;
}

std::optional<double> by_callgrind(Words options, const Words& command, const std::string& scratch) {
  const std::string counted = scratch + "/callgrind.out";
  options.insert(options.begin(), {"valgrind", "-q", "--tool=callgrind", "--callgrind-out-file=" + counted});
  const ChildEnd end = run_program(joined(options, command), {.seconds = 900});
  if (!end.done()) return std::nullopt;
  std::ifstream file(counted);
  std::optional<double> total;
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("totals: ")) total = std::stod(line.substr(8));
  return total;
}

}  // namespace

const std::string& instruction_counter() {
  static const std::string counter = by_perf({"true"}, "/tmp")                                   ? "perf"
                                     : run_program({"valgrind", "--version"}, {}).exit_code == 0 ? "callgrind"
                                                                                                 : "";
  return counter;
}

std::optional<double> count_instructions(const Words& command, const std::string& scratch) {
  if (instruction_counter() == "perf") return by_perf(command, scratch);
  if (instruction_counter() == "callgrind") return by_callgrind({}, command, scratch);
  return std::nullopt;
}

std::optional<double> count_instructions_within(const std::string& function, const Words& command,
                                                const std::string& scratch) {
  return by_callgrind({"--toggle-collect=" + function}, command, scratch);
}

}  // namespace limpet::benchmarks
