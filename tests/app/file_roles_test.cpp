// Copyright the limpet authors. GPL-3.0-or-later.
//
// No output takes the place of an input or of another output, by whatever name it is called.
#include <filesystem>
#include <map>

#include "program.hpp"

namespace limpet::app {
namespace {

namespace fs = std::filesystem;

/// A file that a command reads or writes: a word of its command line, as "@a.ply", or one beside it.
struct Role {
  std::string name;                     ///< of the file, where nothing is aliased
  std::vector<std::string> extensions;  ///< that it may have
  bool written = false;
  bool fixed = false;  ///< the name follows from that of another
};

struct Command {
  std::vector<std::string> words;
  std::vector<Role> roles;
};

const std::vector<std::string> kModels = {"limpet", "off", "ply", "obj", "stl"};
const std::vector<std::string> kMeshes = {"off", "ply", "obj", "stl"};
const std::vector<std::string> kAny = {"json", "limpet", "off", "ply", "obj", "stl", "png", "toml", "xyz"};

std::vector<Command> commands() {
  return {
      {{"model", "@scan.ply", "--initial", "@known.off", "-o", "@m.limpet", "-o", "@m.obj", "--labels",
        "@labels.txt", "--json", "@s.json", "--checkpoint", "@c.checkpoint", "--stages", "2"},
       {{"scan.ply", kAny},
        {"known.off", kMeshes},
        {"m.limpet", kModels, true},
        {"m.obj", {"obj"}, true},
        {"labels.txt", kAny, true},
        {"s.json", kAny, true},
        {"c.checkpoint", kAny, true},
        {"m.mtl", {"mtl"}, true, true},
        {"m.stage1.limpet", {"limpet"}, true, true}}},
      {{"follow", "@scene.toml", "-o", "@m.off", "--json", "@s.json", "--record", "@r.run", "--max-sets",
        "3"},
       {{"scene.toml", {"toml"}},
        {"world.off", {"off"}, false, true},
        {"first.off", {"off"}, false, true},
        {"m.off", kModels, true},
        {"s.json", kAny, true},
        {"r.run", kAny, true}}},
      {{"follow", "--replay", "@old.run", "-o", "@m.off", "--json", "@s.json"},
       {{"old.run", kAny}, {"m.off", kModels, true}, {"s.json", kAny, true}}},
      {{"scan", "@mesh.ply", "-o", "@s.ply", "--points", "100"},
       {{"mesh.ply", kMeshes}, {"s.ply", {"ply"}, true}}},
      {{"check", "@old.limpet", "--json", "@s.json"}, {{"old.limpet", kAny}, {"s.json", kAny, true}}},
      {{"check", "@old.limpet", "--scan", "@scan.ply", "--json", "@s.json"},
       {{"old.limpet", kAny}, {"scan.ply", kAny}, {"s.json", kAny, true}}},
      {{"compare", "@old.limpet", "@mesh.ply", "--json", "@s.json"},
       {{"old.limpet", {"limpet"}}, {"mesh.ply", kMeshes}, {"s.json", kAny, true}}},
      {{"compare", "--labels", "@found.txt", "@true.txt", "--polygons", "@old.limpet", "--json", "@s.json"},
       {{"found.txt", kAny}, {"true.txt", kAny}, {"old.limpet", kAny}, {"s.json", kAny, true}}},
      {{"draw", "@old.limpet", "@old2.limpet", "-o", "@p.png"},
       {{"old.limpet", kAny}, {"old2.limpet", kAny}, {"p.png", {"png", "svg"}, true}}},
  };
}

class FileRoles : public testing::ProgramTest {
 protected:
  /// All inputs there are, as they come from the program.
  void SetUp() override {
    scan("scan.ply", "cube", 500, {"--faces"});
    ASSERT_EQ(run({"follow", "cube", "-o", path("old.limpet"), "-o", path("mesh.ply"), "-o",
                   path("known.off"), "--record", path("old.run"), "--resolution", "0.2", "-q"})
                  .code,
              0);
    fs::copy_file(path("known.off"), path("world.off"));
    fs::copy_file(path("known.off"), path("first.off"));
    fs::copy_file(path("old.limpet"), path("old2.limpet"));
    write("scene.toml", "[world]\nmesh = \"world.off\"\n[initial]\nmesh = \"first.off\"\n");
    for (const char* name : {"found.txt", "true.txt"}) write(name, "1\n1\n2\n");
    for (const std::string& name : names())
      if (name != "stdout" && name != "stderr") bytes_[name] = read(path(name));
  }

  void expect_untouched(const std::string& what) {
    for (const auto& [name, bytes] : bytes_) EXPECT_EQ(read(path(name)), bytes) << name << " after " << what;
    EXPECT_EQ(names().size(), bytes_.size() + 2) << "stdout and stderr besides, after " << what;
  }

  /// The command with `b` called by a name that is also `a`'s. False: there is no such name.
  bool alias(Command command, std::size_t a, std::size_t b, const std::string& how) {
    Role one = command.roles[a], other = command.roles[b];
    const auto rename = [&](Role& role, const std::string& to) {
      for (std::string& word : command.words)
        if (word == "@" + role.name) word = "@" + to;
      role.name = to;
    };
    if (how == "same path" || how == "./") {
      if (one.fixed && other.fixed) return false;
      // The stages are called by the first model, and go with it.
      if (command.roles[a].name == "m.limpet" && other.fixed) return false;
      if (one.fixed) std::swap(one, other);
      const std::string extension = fs::path(one.name).extension().string().substr(1);
      const auto takes = [&](const Role& role, const std::string& wanted) {
        return std::find(role.extensions.begin(), role.extensions.end(), wanted) != role.extensions.end() ||
               role.extensions == kAny;
      };
      const std::string theirs = fs::path(other.name).extension().string().substr(1);
      if (!other.fixed && takes(other, extension))
        rename(other, (how == "./" ? "./" : "") + one.name);
      else if (one.written && takes(one, theirs))
        rename(one, (how == "./" ? "./" : "") + other.name);
      else
        return false;
    } else {
      if (!exists(one.name)) {
        if (how == "hard link") made(one.name, "old bytes");
      }
      if (how == "hard link")
        fs::create_hard_link(path(one.name), path(other.name));
      else
        fs::create_symlink(one.name, path(other.name));
      bytes_[other.name] = read(path(other.name));
    }
    for (std::string& word : command.words)
      if (word.starts_with('@')) word = word.substr(1);
    std::string what = how + ":";
    for (const std::string& word : command.words) what += " " + word;
    testing::Surroundings around;
    around.folder = path("");
    SCOPED_TRACE(what);
    const testing::Result result = run(command.words, around);
    expect_refused(result, "");
    if (how == "hard link" || how == "symbolic link") {
      // A link that leads to nothing is there, but has no bytes.
      expect_untouched(what);
      fs::remove(path(other.name)), bytes_.erase(other.name);
      if (made_) fs::remove(path(one.name)), bytes_.erase(one.name);
      made_ = false;
    } else {
      EXPECT_NE(result.err.find("same file"), std::string::npos) << result.err;
      expect_untouched(what);
    }
    return true;
  }

  void made(const std::string& name, const std::string& bytes) {
    write(name, bytes), bytes_[name] = bytes, made_ = true;
  }

  std::map<std::string, std::string> bytes_;
  bool made_ = false;
};

TEST_F(FileRoles, NoOutputTakesThePlaceOfAnother) {
  int pairs = 0;
  for (const Command& command : commands())
    for (std::size_t b = 0; b < command.roles.size(); ++b) {
      if (!command.roles[b].written) continue;
      for (std::size_t a = 0; a < command.roles.size(); ++a) {
        if (a == b || (command.roles[a].written && a > b)) continue;
        for (const char* how : {"same path", "./", "symbolic link", "hard link"})
          pairs += alias(command, a, b, how);
        if (HasFailure()) return;
      }
    }
  EXPECT_GT(pairs, 200);
}

TEST_F(FileRoles, TheColoursOfAnotherProgramStay) {
  write("v.mtl", "newmtl wood\nKd 0.5 0.3 0.1\n");
  expect_refused(run({"model", path("scan.ply"), "-o", path("v.obj")}), "v.mtl: is there already");
  EXPECT_FALSE(exists("v.obj"));
  fs::remove(path("v.mtl"));
  EXPECT_EQ(run({"model", path("scan.ply"), "-o", path("v.obj")}).code, 0);
  EXPECT_EQ(run({"model", path("scan.ply"), "-o", path("v.obj")}).code, 0) << "its own it replaces";
}

TEST_F(FileRoles, ADeviceMayBeNamedTwice) {
  EXPECT_EQ(
      run({"model", path("scan.ply"), "-o", path("m.off"), "--labels", "/dev/null", "--json", "/dev/null"})
          .code,
      0);
}

TEST_F(FileRoles, StandardStreamsHaveOneUse) {
  expect_refused(run({"compare", "--labels", "-", "-"}), "only once");
  expect_refused(run({"model", path("scan.ply"), "-o", path("m.off"), "--labels", "-", "--json", "-"}),
                 "same file");
  // Standard output is a file here, and what is said there would be lost.
  expect_refused(run({"model", path("scan.ply"), "-o", path("m.off"), "--json", path("stdout")}),
                 "same file");
  testing::Surroundings from_scan;
  from_scan.input = path("scan.ply");
  expect_refused(run({"model", "-", "-o", path("m.off"), "--json", path("scan.ply")}, from_scan),
                 "same file");
}

}  // namespace
}  // namespace limpet::app
