// Copyright the limpet authors. GPL-3.0-or-later.
//
// The same input gives the same bytes: whatever the compiler, its optimisation and sanitizers, the folder and
// the locale. Every build of the tests holds its models against the digests in tests/corpus/same_bytes.txt;
// tools/same_bytes.sh makes several builds and holds them against each other, on real scans too. Who changes
// what models come out takes the new digests from the failures.
#include <cinttypes>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "program.hpp"

namespace limpet::app {
namespace {

struct Entry {
  std::string name;
  std::vector<std::string> scan, model;  ///< arguments
  std::string digest;                    ///< of the scan, then of the model
};

void PrintTo(const Entry& entry, std::ostream* out) { *out << entry.name; }  // NOLINT: googletest's name

/// name | arguments of scan | arguments of model | digests
std::vector<Entry> entries() {
  std::ifstream file(LIMPET_SOURCE_DIR "/tests/corpus/same_bytes.txt");
  std::vector<Entry> all;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    std::vector<std::string> parts;
    std::istringstream fields(line);
    for (std::string part; std::getline(fields, part, '|');) parts.push_back(part);
    const auto words = [&](std::size_t i) {
      std::istringstream text(i < parts.size() ? parts[i] : "");
      std::vector<std::string> result;
      for (std::string word; text >> word;) result.push_back(word);
      return result;
    };
    const auto name = words(0), digests = words(3);
    all.push_back(
        {name.at(0), words(1), words(2), digests.empty() ? "" : digests.at(0) + " " + digests.at(1)});
  }
  return all;
}

/// FNV-1a, 64 bits.
std::string digest(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  char text[17];
  std::snprintf(text, sizeof text, "%016" PRIx64, hash);
  return text;
}

class MadeModels : public testing::ProgramTest {
 protected:
  using Surroundings = testing::Surroundings;

  std::string made(const Entry& entry, const Surroundings& around) {
    std::vector<std::string> arguments{"scan"};
    arguments.insert(arguments.end(), entry.scan.begin(), entry.scan.end());
    arguments.insert(arguments.end(), {"-o", path("s.ply"), "-q"});
    const auto scanned = run(arguments, around);
    EXPECT_EQ(scanned.code, 0) << scanned.err;
    arguments = {"model", path("s.ply"), "-o", path("m.limpet"), "-q"};
    arguments.insert(arguments.end(), entry.model.begin(), entry.model.end());
    const auto modelled = run(arguments, around);
    EXPECT_EQ(modelled.code, 0) << modelled.err;
    return digest(read(path("s.ply"))) + " " + digest(read(path("m.limpet")));
  }
};

class SameBytes : public MadeModels, public ::testing::WithParamInterface<Entry> {};

TEST_P(SameBytes, OnAnyBuild) {
  EXPECT_EQ(made(GetParam(), {}), GetParam().digest) << "for " << GetParam().name;
}

TEST_P(SameBytes, InAnyFolderAndTimeZone) {
  const std::string here = made(GetParam(), {});
  EXPECT_EQ(made(GetParam(), {"/", {{"LC_ALL", "C.UTF-8"}, {"TZ", "Asia/Kathmandu"}}, ""}), here);
}

TEST_F(MadeModels, AreTheSameInAnyLocale) {
  const Entry entry = entries().at(0);
  const std::string here = made(entry, {});
  // Decimal commas, and an i without a dot; few machines have these locales on their own.
  for (const std::string locale : {"de_DE", "tr_TR"}) {
    const std::string made_here = path(locale + ".UTF-8");
    std::string make = "localedef -f UTF-8 --no-archive -i ";
    make.append(locale).append(" ").append(made_here);
    ASSERT_EQ(std::system(make.c_str()), 0) << "the package 'locales' has what is missing";
    EXPECT_EQ(made(entry, {path(""), {{"LC_ALL", locale + ".UTF-8"}, {"LOCPATH", path("")}}, ""}), here);
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, SameBytes, ::testing::ValuesIn(entries()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace limpet::app
