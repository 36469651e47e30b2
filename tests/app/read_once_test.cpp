// Copyright the limpet authors. GPL-3.0-or-later.
//
// A scan that comes through a pipe gives what the same scan gives as a file.
#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "program.hpp"

namespace limpet::app {
namespace {

class ReadOnce : public testing::ProgramTest {
 protected:
  /// Runs `words`, in which @ stands for the scan, with the scan fed through a pipe with a name.
  testing::Result through_pipe(const std::string& scan, std::vector<std::string> words) {
    EXPECT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    for (std::string& word : words)
      if (word == "@") word = path("pipe");
    const pid_t child = start(words);
    std::thread feed([&] {
      std::ofstream pipe(path("pipe"), std::ios::binary);
      pipe << read(scan);
    });
    const auto result = finish(child);
    feed.join();
    ::unlink(path("pipe").c_str());
    return result;
  }

  void expect_same(const std::string& scan, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"model", scan, "-o", path("file.limpet"), "--labels", path("file.txt")};
    words.insert(words.end(), more.begin(), more.end());
    const auto by_file = run(words);
    EXPECT_EQ(by_file.code, 0) << by_file.err;
    words[1] = "@", words[3] = path("pipe.limpet"), words[5] = path("pipe.txt");
    const auto by_pipe = through_pipe(scan, words);
    EXPECT_EQ(by_pipe.code, 0) << by_pipe.err;
    words[1] = "-", words[3] = path("input.limpet"), words[5] = path("input.txt");
    testing::Surroundings around;
    around.input = scan;
    EXPECT_EQ(run(words, around).code, 0);
    for (const char* how : {"pipe", "input"})
      for (const char* what : {".limpet", ".txt"})
        EXPECT_EQ(read(path(how + std::string(what))), read(path("file" + std::string(what)))) << how << what;
  }
};

TEST_F(ReadOnce, SameBytesFromFileAndPipe) {
  expect_same(scan("c.ply", "cube", 50'000, {"--noise", "0.002"}));
}

/// More than are held in memory.
TEST_F(ReadOnce, SameBytesOfManyPoints) {
  expect_same(scan("c.ply", "step_hole", 150'000, {"--noise", "0.004", "--order", "shuffled"}));
}

TEST_F(ReadOnce, SameBytesWithoutAxes) {
  std::string text;
  const std::string with = read(scan("c.xyz", "cube", 5000, {"--order", "shuffled"}));
  for (std::size_t begin = 0; begin < with.size();) {
    const auto end = with.find('\n', begin);
    std::string line = with.substr(begin, end - begin);
    begin = end + 1;
    if (line.starts_with('#')) continue;
    for (int column = 0; column < 3; ++column) line.erase(line.find_last_of(' '));
    text += line + "\n";
  }
  expect_same(write("bare.xyz", text));
}

TEST_F(ReadOnce, SameBytesOfNormalsThatSayNothing) {
  std::string text = "# x y z nx ny nz\nnan 0 0 0 0 0\n";
  std::string bare;
  for (int i = 0; i < 3000; ++i) {
    const int row = i / 50;
    const std::string at =
        std::to_string(i % 50 * 0.02) + " " + std::to_string(row * 0.02) + " " + std::to_string(i % 7 * 1e-4);
    text += at + " 0 0 0\n", bare += at + "\n";
  }
  const std::string zero = write("zero.xyz", text);
  expect_same(zero);
  const auto result = run({"model", zero, "-o", path("z.off"), "-q"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("are zero; it is read as one without"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("1 records were no point"), std::string::npos) << result.err;
  ASSERT_EQ(run({"model", write("bare.xyz", bare), "-o", path("b.off"), "-q"}).code, 0);
  EXPECT_EQ(read(path("z.off")), read(path("b.off"))) << "as if the normals were not there";
}

/// One normal that says something makes the others records that are no point.
TEST_F(ReadOnce, SomeNormalsAreEnough) {
  std::string text = "# x y z nx ny nz\n";
  for (int i = 0; i < 900; ++i) {
    const int row = i / 30;
    text += std::to_string(i % 30 * 0.02) + " " + std::to_string(row * 0.02) + " 0 0 0 " +
            (i < 400 ? "0" : "1") + "\n";
  }
  const std::string some = write("some.xyz", text);
  expect_same(some);
  const auto result = run({"model", some, "-o", path("s.off"), "-q"});
  EXPECT_NE(result.err.find("400 records were no point"), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find("are zero"), std::string::npos) << result.err;
}

TEST_F(ReadOnce, LabelsThroughAPipe) {
  const std::string labelled = scan("c.ply", "cube", 2000, {"--faces"});
  ASSERT_EQ(run({"model", labelled, "-o", path("m.off"), "--labels", path("l.txt")}).code, 0);
  const auto by_file = run({"compare", "--labels", path("l.txt"), labelled});
  const auto by_pipe = through_pipe(labelled, {"compare", "--labels", path("l.txt"), "@"});
  EXPECT_EQ(by_pipe.code, by_file.code);
  EXPECT_EQ(by_pipe.out, by_file.out);
  EXPECT_EQ(by_pipe.err, "");
}

}  // namespace
}  // namespace limpet::app
