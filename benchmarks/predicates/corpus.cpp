// Copyright the limpet authors. GPL-3.0-or-later.
//
// The corpus of tests, and random degenerate streams, in each build.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "builds.hpp"

namespace limpet::benchmarks {
namespace {

std::vector<std::string> corpus_files() {
  std::vector<std::string> files;
  if (!std::filesystem::is_directory(LIMPET_CORPUS)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(LIMPET_CORPUS))
    if (entry.path().extension() == ".case") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

void add_row(const std::string& what, std::size_t build, const std::vector<Json>& told, Table& table) {
  std::map<std::string, int> laws;
  int broken = 0, exceptions = 0, hangs = 0, crashes = 0;
  for (const Json& t : told) {
    if (t.contains("ended")) {
      ++(t["ended"] == "hang" ? hangs : t["ended"] == "exception" ? exceptions : crashes);
      ++laws[t["ended"]];
      continue;
    }
    const std::string law = t.at("law");
    if (law.empty()) continue;
    ++(law == "exception" ? exceptions : broken);
    ++laws[law];
  }
  std::string listed;
  for (const auto& [law, count] : laws)
    listed += (listed.empty() ? "" : ", ") + law + " " + std::to_string(count);
  table.add({what, kBuilds[build], told.size(), broken, exceptions, hangs, crashes, listed});
}

std::vector<Json> replayed(std::vector<std::string> command) {
  const ChildEnd end = run_program(command, {});
  if (!end.done()) throw std::runtime_error(command[0] + " " + command[1] + ": " + end.how());
  return told_lines(end.output);
}

}  // namespace

void add_corpus(const PredicatesOptions& options, ReportPage& report) {
  Table table({{"cases"},
               {"build"},
               {"count"},
               {"broken_laws"},
               {"exceptions"},
               {"hangs"},
               {"crashes"},
               {"by_kind"}});
  const std::vector<std::string> files = corpus_files();
  for (std::size_t build = 0; build < kBuilds.size(); ++build) {
    std::fprintf(stderr, "corpus: %s\n", kBuilds[build]);
    if (files.empty()) continue;
    std::vector<std::string> command{replay_program(build), "cases"};
    command.insert(command.end(), files.begin(), files.end());
    add_row("tests/corpus", build, replayed(command), table);
  }
  for (std::size_t build = 0; build < kBuilds.size(); ++build) {
    std::fprintf(stderr, "streams: %s\n", kBuilds[build]);
    add_row("random streams", build,
            replayed({replay_program(build), "streams", "--count", options.full ? "5000" : "300"}), table);
  }
  report.add("The corpus",
             "Cases of tests/corpus, and random degenerate streams of readings, each in a process of its own "
             "and judged after every set; the first law that broke in each.",
             table, "corpus");
}

}  // namespace limpet::benchmarks
