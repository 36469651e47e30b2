// Copyright the limpet authors. GPL-3.0-or-later.
//
// Cases by hand:
//   limpet_case replay FILE...                        which laws they break; exit 1 if any
//   limpet_case show KIND BYTES -o FILE               what a fuzzer's input of this kind stands for
//   limpet_case minimise FILE -o FILE [SECONDS]       the smallest case that ends in the same way
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>

#include "any_case.hpp"
#include "minimise.hpp"

namespace limpet::cases {
namespace {

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw CaseError(path + ": cannot be read");
  return text.str();
}

void write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw CaseError(path + ": cannot be written");
}

int replay(const std::vector<std::string>& files) {
  int broken = 0;
  for (const std::string& path : files) {
    const std::string text = read_file(path);
    const std::string verdict = verdict_aside(
        [&] {
          return with_case(text, [](const auto& c) {
            const auto law = broken_law(c);
            return law ? law->law + ": " + law->what : std::string();
          });
        },
        60);
    std::printf("%s: %s\n", path.c_str(), verdict.empty() ? "all laws hold" : verdict.c_str());
    broken += !verdict.empty();
  }
  return broken > 0;
}

/// Of what crashes in a perimeter operation, up to that operation.
int show(const std::string& kind, const std::string& path, const std::string& out) {
  const std::string bytes = read_file(path);
  const std::string verdict = verdict_aside(
      [&] {
        const auto law =
            broken_law_of_bytes(kind, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()},
                                [&](const std::string& text) { write_file(out, text); });
        return law ? law->law : std::string();
      },
      60);
  std::printf("%s: %s\n", out.c_str(), verdict.empty() ? "all laws hold" : verdict.c_str());
  return 0;
}

int minimise_file(const std::string& path, const std::string& out, unsigned seconds) {
  return with_case(read_file(path), [&](auto c) {
    const std::string wanted = verdict_aside(
        [&] {
          const auto law = broken_law(c);
          return law ? law->law : std::string();
        },
        seconds);
    if (wanted.empty()) {
      std::fprintf(stderr, "%s: breaks no law\n", path.c_str());
      return 1;
    }
    c.law = wanted;
    const auto told = [&](const auto& smaller) { write_file(out, to_text(smaller)); };
    told(c);
    told(minimise(c, wanted, seconds, std::function<void(const decltype(c)&)>(told)));
    std::printf("%s: %s\n", out.c_str(), wanted.c_str());
    return 0;
  });
}

int run(int argc, char** argv) {
  const std::vector<std::string> args(argv + 1, argv + argc);
  if (args.size() >= 2 && args[0] == "replay") return replay({args.begin() + 1, args.end()});
  if (args.size() == 5 && args[0] == "show" && args[3] == "-o") return show(args[1], args[2], args[4]);
  if (args.size() >= 4 && args[0] == "minimise" && args[2] == "-o")
    return minimise_file(
        args[1], args[3],
        args.size() > 4 ? static_cast<unsigned>(std::strtoul(args[4].c_str(), nullptr, 10)) : 20);
  std::fputs(
      "usage: limpet_case replay FILE... | show KIND BYTES -o FILE | minimise FILE -o FILE [SECONDS]\n",
      stderr);
  return 2;
}

}  // namespace
}  // namespace limpet::cases

int main(int argc, char** argv) {
  try {
    return limpet::cases::run(argc, argv);
  } catch (const limpet::cases::CaseError& error) {
    std::fprintf(stderr, "limpet_case: %s\n", error.what());
    return 2;
  }
}
