// Copyright the limpet authors. GPL-3.0-or-later.
//
// What becomes of the files that the program writes over, and of the others when one cannot be written.
#include <sys/stat.h>

#include <filesystem>

#include "program.hpp"

namespace limpet::app {
namespace {

namespace fs = std::filesystem;

class OutputFiles : public testing::ProgramTest {
 protected:
  mode_t mode_of(const std::string& name) const {
    struct stat found;
    EXPECT_EQ(::stat(path(name).c_str(), &found), 0) << name;
    return found.st_mode & 07777;
  }
  std::vector<std::string> model(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"model", path("c.ply"), "--resolution", "0.1", "--noise", "0"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  void SetUp() override { scan("c.ply", "cube", 3000); }
};

/// /dev/full takes no byte.
TEST_F(OutputFiles, OneThatFailsDoesNotLoseTheOthers) {
  const auto result = run(model({"-o", path("m.off"), "--labels", "/dev/full", "--json", path("s.json"), "-o",
                                 path("m.limpet"), "--stages", "1"}));
  expect_refused(result, "/dev/full: cannot be written");
  for (const char* name : {"m.off", "s.json", "m.limpet", "m.stage1.limpet"})
    EXPECT_TRUE(exists(name)) << name;
  EXPECT_EQ(run({"check", path("m.limpet")}).code, 0);
}

TEST_F(OutputFiles, AStageThatFailsDoesNotLoseTheOthers) {
  fs::create_symlink("/dev/full", path("m.stage1.limpet"));
  expect_refused(run(model({"-o", path("m.limpet"), "--stages", "3"})), "m.stage1.limpet: cannot be written");
  for (const char* name : {"m.limpet", "m.stage2.limpet", "m.stage3.limpet"})
    EXPECT_TRUE(exists(name)) << name;
}

TEST_F(OutputFiles, EachFailureIsNamed) {
  fs::create_symlink("/dev/full", path("l"));
  fs::create_symlink("/dev/full", path("j"));
  const auto result = run(model({"-o", path("m.off"), "--labels", path("l"), "--json", path("j")}));
  expect_refused(result, path("l") + ": cannot be written");
  expect_refused(result, path("j") + ": cannot be written");
  EXPECT_TRUE(exists("m.off"));
}

TEST_F(OutputFiles, ARunGoesOnWithoutItsRecord) {
  const auto result = run({"follow", "cube", "-o", path("m.off"), "--record", "/dev/full", "--resolution",
                           "0.2", "--json", path("s.json"), "-q"});
  EXPECT_EQ(result.code, 2) << result.err;
  EXPECT_NE(result.err.find("/dev/full: cannot be written"), std::string::npos) << result.err;
  EXPECT_TRUE(exists("m.off"));
  EXPECT_TRUE(exists("s.json"));
}

TEST_F(OutputFiles, PermissionsStay) {
  for (const mode_t mode : {0600, 0640, 0664, 0444, 0755}) {
    write("m.off", "old");
    ::chmod(path("m.off").c_str(), mode);
    if (::geteuid() != 0 && (mode & 0200) == 0) {
      expect_refused(run(model({"-o", path("m.off")})), "may not be written");
    } else {
      EXPECT_EQ(run(model({"-o", path("m.off")})).code, 0);
      EXPECT_NE(read(path("m.off")), "old");
    }
    EXPECT_EQ(mode_of("m.off"), mode);
    fs::remove(path("m.off"));
  }
}

TEST_F(OutputFiles, OwnersStayWhereTheSystemAllowsIt) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root may give files away";
  write("m.off", "old");
  ASSERT_EQ(::chown(path("m.off").c_str(), 1234, 1235), 0);
  EXPECT_EQ(run(model({"-o", path("m.off")})).code, 0);
  struct stat found;
  ASSERT_EQ(::stat(path("m.off").c_str(), &found), 0);
  EXPECT_EQ(found.st_uid, 1234u);
  EXPECT_EQ(found.st_gid, 1235u);
}

TEST_F(OutputFiles, ACheckpointIsNoMoreReadableThanTheScan) {
  for (const mode_t mode : {0600, 0640, 0644}) {
    ::chmod(path("c.ply").c_str(), mode);
    ASSERT_EQ(run(model({"-o", path("m.off"), "--checkpoint", path("c")})).code, 0);
    EXPECT_EQ(mode_of("c") & 044, mode & 044) << std::oct << mode;
    fs::remove(path("c"));
  }
  testing::Surroundings piped;
  piped.input = path("c.ply");
  ASSERT_EQ(run({"model", "-", "-o", path("m.off"), "--checkpoint", path("c")}, piped).code, 0);
  EXPECT_EQ(mode_of("c") & 044, 0u) << "of standard input nobody knows who may read it";
}

TEST_F(OutputFiles, LinksStay) {
  fs::create_directory(path("there"));
  write("there/m.off", "old");
  ::chmod(path("there/m.off").c_str(), 0600);
  fs::create_symlink("there/m.off", path("to_old.off"));
  fs::create_symlink("there/new.off", path("to_new.off"));
  EXPECT_EQ(run(model({"-o", path("to_old.off"), "-o", path("to_new.off")})).code, 0);
  for (const char* name : {"to_old.off", "to_new.off"}) EXPECT_TRUE(fs::is_symlink(path(name))) << name;
  EXPECT_NE(read(path("there/m.off")), "old");
  EXPECT_EQ(mode_of("there/m.off"), 0600u);
  EXPECT_EQ(read(path("there/new.off")), read(path("there/m.off")));
}

TEST_F(OutputFiles, ALinkToNothingLeavesNothingWhenTheRunFails) {
  fs::create_symlink("new.off", path("link.off"));
  write("empty.ply", "");
  EXPECT_EQ(run({"model", path("empty.ply"), "-o", path("link.off")}).code, 2);
  EXPECT_FALSE(exists("new.off"));
}

/// What the kernel forbids (fs.protected_symlinks) is forbidden: another user's link in a sticky folder.
TEST_F(OutputFiles, AnothersLinkInAStickyFolderIsNotFollowed) {
  std::ifstream setting("/proc/sys/fs/protected_symlinks");
  int on = 0;
  if (::geteuid() != 0 || !(setting >> on) || on == 0) GTEST_SKIP() << "not root, or links are not protected";
  fs::create_directory(path("sticky"));
  ASSERT_EQ(::chmod(path("sticky").c_str(), 01777), 0);
  write("victim.off", "old");
  fs::create_symlink(path("victim.off"), path("sticky/m.off"));
  ASSERT_EQ(::lchown(path("sticky/m.off").c_str(), 1234, 1234), 0);
  expect_refused(run(model({"-o", path("sticky/m.off")})), "");
  EXPECT_EQ(read(path("victim.off")), "old");
}

TEST_F(OutputFiles, TheLongestNameWillDo) {
  const std::string name = std::string(251, 'n') + ".off";
  for (int again = 0; again < 2; ++again) EXPECT_EQ(run(model({"-o", path(name)})).code, 0);
  EXPECT_TRUE(exists(name));
}

/// Only files that the user named are touched, whatever lies beside them.
TEST_F(OutputFiles, NothingElseInTheFolderIsTouched) {
  write("m.off", "old");
  for (const char* name : {"m.off.part-of-limpet", "m.off.part", ".m.off"}) write(name, "mine");
  EXPECT_EQ(run(model({"-o", path("m.off")})).code, 0);
  for (const char* name : {"m.off.part-of-limpet", "m.off.part", ".m.off"})
    EXPECT_EQ(read(path(name)), "mine");
  EXPECT_EQ(names().size(), 7u) << "and nothing is left there";
}

TEST_F(OutputFiles, OfHardLinksOneIsReplaced) {
  write("m.off", "old");
  fs::create_hard_link(path("m.off"), path("other.off"));
  EXPECT_EQ(run(model({"-o", path("m.off")})).code, 0);
  EXPECT_EQ(read(path("other.off")), "old");
}

}  // namespace
}  // namespace limpet::app
