// Copyright the limpet authors. GPL-3.0-or-later.
//
// Every bad input: one line that says what and where, exit code 2, and nothing half written.
#include <sys/resource.h>

#include "program.hpp"

namespace limpet::app {
namespace {

class BadInput : public testing::ProgramTest {
 protected:
  testing::Result model(const std::string& scan, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"model", scan, "-o", path("m.limpet")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

TEST_F(BadInput, MissingFile) {
  expect_refused(model(path("nothing.ply")), "nothing.ply");
  expect_refused(run({"check", path("nothing.limpet")}), "nothing.limpet");
  expect_refused(run({"compare", path("nothing.limpet"), "cube"}), "nothing.limpet");
  expect_refused(run({"draw", path("nothing.limpet"), "-o", path("p.png")}), "nothing.limpet");
  expect_refused(run({"scan", path("nothing.off"), "-o", path("s.ply")}), "nothing.off");
}

TEST_F(BadInput, Folder) {
  expect_refused(model(path("")), "");
  expect_refused(run({"check", path("")}), "folder");
  expect_refused(run({"draw", path(""), "-o", path("p.png")}), "");
  expect_refused(run({"scan", path(""), "-o", path("s.ply")}), "folder");
  expect_refused(run({"compare", path(""), "cube"}), "folder");
}

TEST_F(BadInput, MeshAsScan) {
  const auto mesh = write("t.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  expect_refused(model(mesh), "mesh");
  expect_refused(run({"check", mesh}), "t.off");
}

TEST_F(BadInput, EmptyFiles) {
  for (const std::string name : {"e.ply", "e.pcd", "e.xyz", "e.pwn"}) {
    expect_refused(model(write(name, "")), "empty");
  }
  expect_refused(model(write("header.ply",
                             "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
                             "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                             "end_header\n")),
                 "no point");
  expect_refused(run({"check", write("e.limpet", "")}), "e.limpet");
}

TEST_F(BadInput, TruncatedScanIsModelledAsFarAsItGoes) {
  const std::string whole = read(scan("whole.ply", "cube", 5000));
  const auto cut = write("cut.ply", whole.substr(0, whole.size() * 3 / 4));
  const auto result = model(cut, {"--json", path("s.json")});
  expect_refused(result, "cut.ply");
  EXPECT_TRUE(exists("m.limpet"));
  EXPECT_NE(read(path("s.json")).find("\"points\": 37"), std::string::npos) << read(path("s.json"));
  EXPECT_EQ(run({"check", path("m.limpet")}).code, 0);
}

TEST_F(BadInput, LyingHeader) {
  std::string bytes = read(scan("whole.ply", "cube", 2000));
  const auto at = bytes.find("element vertex ");
  const auto end = bytes.find('\n', at);
  bytes.replace(at, end - at, "element vertex 9000000000000000");
  expect_refused(model(write("lie.ply", bytes)), "lie.ply");
  EXPECT_TRUE(exists("m.limpet"));
}

TEST_F(BadInput, ResolutionAngleAndNoiseOutOfRange) {
  const auto scan_file = scan("c.ply", "cube", 1000);
  for (const std::string value : {"0", "-1", "nan", "inf", "abc", "1e400", ""}) {
    expect_refused(model(scan_file, {"--resolution", value}), "--resolution");
  }
  for (const std::string value : {"0", "90", "-5", "x"}) {
    expect_refused(model(scan_file, {"--angle", value}), "--angle");
  }
  for (const std::string value : {"-1", "x", "1,2,3,4", "0.1,-1", "nan", ","}) {
    expect_refused(model(scan_file, {"--noise", value}), "--noise");
  }
  // These readings say along which axes, but not from how far, they were taken.
  expect_refused(model(scan_file, {"--noise", "0.001,0.002"}), "give --noise as one number");
  expect_refused(model(scan_file, {"--tolerance", "-1"}), "--tolerance");
  for (const std::string value : {"20", "-1,0.1", "x,y", "1,2,3", ""}) {
    expect_refused(model(scan_file, {"--redundancy", value}), "--redundancy");
  }
  expect_refused(model(scan_file, {"--set-size", "0"}), "--set-size");
  expect_refused(model(scan_file, {"--viewpoint", "1,2"}), "--viewpoint");
  expect_refused(model(scan_file, {"--rules", "nonsense"}), "nonsense");
  expect_refused(model(scan_file, {"--nonsense"}), "--nonsense");
  EXPECT_FALSE(exists("m.limpet"));
}

TEST_F(BadInput, RecordsThatAreNoPointAreCounted) {
  std::string text = "# x y z ax ay az\n";
  for (int i = 0; i < 400; ++i) {
    const int row = i / 20;
    text += std::to_string(i % 20 * 0.05) + " " + std::to_string(row * 0.05) + " 0 0 0 -1\n";
    if (i % 10 == 0) text += "nan 0 0 0 0 -1\n";
    if (i % 40 == 0) text += "0.5 0.5 0 0 0 0\ninf 0 0 0 0 -1\n";
  }
  const auto result = model(write("n.xyz", text), {"--json", "-", "--labels", path("labels.txt")});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("\"points\": 400"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("\"points_refused\": 60"), std::string::npos) << result.out;
  // One label a record, those that are no point too.
  const std::string labels = read(path("labels.txt"));
  EXPECT_EQ(std::count(labels.begin(), labels.end(), '\n'), 460);
  EXPECT_EQ(labels.substr(labels.find('\n') + 1, 2), "0\n");
}

TEST_F(BadInput, NothingButBadRecords) {
  expect_refused(model(write("n.xyz", "nan nan nan 0 0 1\n1 inf 3 0 0 1\n")), "no point");
}

TEST_F(BadInput, NoAxesAndTooFewPointsToFindThem) {
  const auto bare = write("bare.xyz", "0 0 0\n1 0 0\n0 1 0\n");
  expect_refused(model(bare), "--resolution");
  EXPECT_EQ(model(bare, {"--viewpoint", "0,0,-5", "--resolution", "1", "--noise", "0"}).code, 0);
  EXPECT_EQ(model(bare, {"--resolution", "1", "--noise", "0"}).code, 0);
}

TEST_F(BadInput, FewPointsBecauseOfDamageIsDamage) {
  expect_refused(model(write("bad.xyz", "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 x 0 1\n")),
                 "line 3: 'x' is not a number");
  expect_refused(model(write("bare.xyz", "0 0 0\n1 0 0\n0 1\n")), "line 3");
}

TEST_F(BadInput, Outputs) {
  const auto scan_file = scan("c.ply", "cube", 1000);
  expect_refused(run({"model", scan_file, "-o", path("no/such/m.off")}), "no/such");
  expect_refused(run({"model", scan_file, "-o", path("m.xyz")}), ".limpet");
  expect_refused(run({"model", scan_file}), "--output");
  expect_refused(run({"draw", scan_file, "-o", path("p.jpg")}), ".png");
  expect_refused(run({"scan", "cube", "-o", path("s.pcd")}), "s.pcd");
  expect_refused(run({}), "--help");
  expect_refused(run({"nonsense"}), "nonsense");
}

/// One field of the first line that begins with this word, of a model that is otherwise whole.
std::string with_field(std::string text, const std::string& word, int n, const std::string& value) {
  std::size_t begin = text.find("\n" + word + " ") + 1;
  for (int i = 0; i < n; ++i) begin = text.find(' ', begin) + 1;
  return text.replace(begin, text.find_first_of(" \n", begin) - begin, value);
}

TEST_F(BadInput, ModelsWithNumbersBeyondAllMeasure) {
  ASSERT_EQ(model(scan("c.ply", "cube", 1000)).code, 0);
  const std::string whole = read(path("m.limpet"));
  for (const std::string value : {"1e20", "1e30", "-1e308"}) {
    const auto damaged = write("d.limpet", with_field(whole, "height", 1, value));
    expect_refused(run({"draw", damaged, "-o", path("p.png")}), "farther than 2^49 grid steps");
    expect_refused(run({"compare", damaged, "cube"}), "farther than 2^49 grid steps");
    const auto checked = run({"check", damaged});
    EXPECT_EQ(checked.code, 1) << checked.err;
    EXPECT_NE(checked.out.find("grid: segment"), std::string::npos) << checked.out;
  }
  EXPECT_FALSE(exists("p.png"));
}

/// Broken, but no reason not to draw it.
TEST_F(BadInput, AnEdgeWithoutAnIdentity) {
  ASSERT_EQ(model(scan("c.ply", "cube", 1000)).code, 0);
  const std::string whole = read(path("m.limpet"));
  const std::size_t vertex = whole.find('\n', whole.find("\ncycle ") + 1) + 1;
  std::string text = whole;
  std::size_t begin = text.find(' ', text.find(' ', vertex) + 1) + 1;
  text.replace(begin, text.find(' ', begin) - begin, "0");
  const auto damaged = write("d.limpet", text);
  const auto drawn = run({"draw", damaged, "-o", path("p.png"), "-q"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  const auto checked = run({"check", damaged});
  EXPECT_EQ(checked.code, 1) << checked.err;
  EXPECT_NE(checked.out.find("edge-identity: segment"), std::string::npos) << checked.out;
}

/// A file without lines is not read to its end, which may never come.
TEST_F(BadInput, EndlessLines) {
  expect_refused(run({"check", "/dev/zero"}), "more than 1 MiB");
  // With a scan the model is read twice, so that it is kept first.
  expect_refused(run({"check", "/dev/zero", "--scan", scan("s.ply", "cube", 100)}), "more than 1 MiB");
  expect_refused(run({"draw", "/dev/zero", "-o", path("p.png")}), "longer than 1 MiB");
  expect_refused(run({"compare", "/dev/zero", "cube"}), "not a mesh file");
  std::filesystem::create_symlink("/dev/zero", path("z.off"));
  expect_refused(run({"compare", path("z.off"), "cube"}), "is a device");
  std::filesystem::create_symlink("/dev/zero", path("z.limpet"));
  expect_refused(run({"compare", path("z.limpet"), "cube"}), "longer than 1 MiB");
}

TEST_F(BadInput, FacesKnownBeforehandThatTheGridCannotHold) {
  const auto scan_file = scan("c.ply", "cube", 1000);
  const auto mesh = write("far.off", "OFF\n3 1 0\n0 0 0\n1e9 0 0\n0 1e9 0\n3 0 1 2\n");
  expect_refused(model(scan_file, {"--initial", mesh, "--resolution", "0.1"}),
                 "far.off: initial face 0 is wider");
  const auto wild = write("wild.off", "OFF\n3 1 0\n0 0 0\n1e99 0 0\n0 1 0\n3 0 1 2\n");
  expect_refused(model(scan_file, {"--initial", wild}), "wild.off: a vertex has a coordinate beyond 1e75");
}

/// A file may not grow beyond a few blocks, as on a full disk.
TEST_F(BadInput, FullDisk) {
  const auto scan_file = scan("c.ply", "cube", 1000);
  ASSERT_EQ(model(scan_file).code, 0);
  const std::string before = read(path("m.limpet"));
  const struct rlimit small = {64, RLIM_INFINITY};
  struct rlimit usual = {};
  ::getrlimit(RLIMIT_FSIZE, &usual);
  ::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &small);
  const auto child = start({"model", scan_file, "-o", path("m.limpet"), "-q"});
  ::setrlimit(RLIMIT_FSIZE, &usual);
  const auto result = finish(child);
  ::signal(SIGXFSZ, SIG_DFL);
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(read(path("m.limpet")), before);
  for (const auto& entry : std::filesystem::directory_iterator(path(""))) {
    const std::string name = entry.path().filename();
    EXPECT_TRUE(name == "c.ply" || name == "m.limpet" || name == "stdout" || name == "stderr") << name;
  }
}

}  // namespace
}  // namespace limpet::app
