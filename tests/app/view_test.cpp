// Copyright the limpet authors. GPL-3.0-or-later.
//
// `limpet view` as scripts see it. What its pages do in a browser is told by tests/page.
#include <limpet/drawing/page.hpp>

#include "program.hpp"

namespace limpet::app {
namespace {

class View : public testing::ProgramTest {
 protected:
  /// The recorded run of a cube that ends early; its name.
  std::string record(const std::string& name, const std::string& sets = "60") const {
    const auto result =
        run({"follow", "cube", "--max-sets", sets, "-q", "-o", path("m.limpet"), "--record", path(name)});
    EXPECT_EQ(result.code, 1) << result.err;
    return path(name);
  }
  void require_pages() const {
    try {
      drawing::require_page();
    } catch (const drawing::NoPage& error) {
      GTEST_SKIP() << error.what();
    }
  }
};

TEST_F(View, WritesThePageOfARunAndOfAModelTheSameEachTime) {
  require_pages();
  if (IsSkipped()) return;
  record("r.run");
  for (const std::string source : {"r.run", "m.limpet"}) {
    const auto result = run({"view", path(source), "-o", path("one.html"), "--truth", "cube"});
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "written: " + path("one.html") + "\n");
    EXPECT_EQ(run({"view", path(source), "-q", "-o", path("two.html"), "--truth", "cube"}).code, 0);
    EXPECT_EQ(read(path("one.html")), read(path("two.html")));
    EXPECT_EQ(read(path("one.html")).find("http://"), std::string::npos);
    EXPECT_EQ(read(path("one.html")).find("https://"), std::string::npos);
  }
}

TEST_F(View, ANameIsNoMarkup) {
  require_pages();
  if (IsSkipped()) return;
  const std::string name = "<img onerror=alert(1)>.run";
  record(name);
  ASSERT_EQ(run({"view", path(name), "-o", path("p.html")}).code, 0);
  EXPECT_EQ(read(path("p.html")).find("<img"), std::string::npos);
}

TEST_F(View, WritesSeriesForParaView) {
  record("r.run");
  ASSERT_EQ(run({"view", path("r.run"), "-o", path("s.pvd"), "-o", path("s.vtp"), "-o", path("s.glb"),
                 "--stages", "5"})
                .code,
            0);
  const std::string list = read(path("s.pvd"));
  for (const std::string stage : {"stage0", "stage1", "stage2", "stage3", "stage4", "stage5"}) {
    EXPECT_NE(list.find("file=\"s/" + stage + ".vtp\""), std::string::npos) << list;
    EXPECT_TRUE(exists("s/" + stage + ".vtp"));
  }
  EXPECT_NE(list.find("timestep=\"12\""), std::string::npos) << list;
  EXPECT_EQ(read(path("s/stage5.vtp")), read(path("s.vtp"))) << "the last one is the finished model";
}

TEST_F(View, RefusesWhatItCannotShowInOneLine) {
  record("r.run");
  const std::string whole = read(path("r.run")), model = read(path("m.limpet"));
  write("cut.run", whole.substr(0, 3000));
  expect_refused(run({"view", path("cut.run"), "-o", path("p.vtp")}), "cut.run");
  std::string changed = whole;
  changed.replace(changed.find("\nset ") + 5, 1, "?");
  write("changed.run", changed);
  expect_refused(run({"view", path("changed.run"), "-o", path("p.vtp")}), "changed.run");
  expect_refused(run({"view", path("changed.run"), "-o", path("p.pvd")}), "changed.run");
  write("cut.limpet", model.substr(0, model.size() / 2));
  expect_refused(run({"view", path("cut.limpet"), "-o", path("p.vtp")}), "cut.limpet");
  expect_refused(run({"view", path("nothing.run"), "-o", path("p.vtp")}), "nothing.run");
  expect_refused(run({"view", path(""), "-o", path("p.vtp")}), "folder");
  expect_refused(run({"view", path("m.limpet"), "-o", path("p.txt")}), "p.txt");
  expect_refused(run({"view", path("m.limpet"), "-o", path("p.pvd")}), "recorded run");
  expect_refused(run({"view", path("r.run"), "-o", path("r.run")}), "r.run");
  EXPECT_FALSE(exists("p.vtp"));
}

TEST_F(View, RefusesDamagedPagesInOneLine) {
  require_pages();
  if (IsSkipped()) return;
  record("r.run");
  std::string changed = read(path("r.run"));
  changed.replace(changed.find("\nset ") + 5, 1, "?");
  write("changed.run", changed);
  expect_refused(run({"view", path("changed.run"), "-o", path("p.html")}), "changed.run");
  expect_refused(run({"view", path("m.limpet"), "-o", path("p.html"), "--truth", "nothing.off"}),
                 "nothing.off");
  std::string model = read(path("m.limpet"));
  const std::size_t cycle = model.find("\ncycle ");
  ASSERT_NE(cycle, std::string::npos);
  const auto line_after = [&](std::size_t at, int lines) {
    for (; lines > 0; --lines) at = model.find('\n', at) + 1;
    return at;
  };
  const std::size_t first = line_after(cycle + 1, 1), second = line_after(first, 1);
  const std::size_t far = line_after(first, 12);
  const std::string vertex = model.substr(first, second - first);
  model.insert(far, vertex).erase(first, vertex.size());  // the perimeter crosses itself
  write("crossed.limpet", model);
  expect_refused(run({"view", path("crossed.limpet"), "-o", path("p.html")}), "crossed.limpet");
  EXPECT_FALSE(exists("p.html"));
}

/// What is said of a run and of a model leads into a page, where it is asked for.
TEST_F(View, SummariesLinkIntoPages) {
  const auto followed =
      run({"follow", "cube", "--max-sets", "60", "-o", path("m.limpet"), "--page", "a b.html"});
  EXPECT_NE(followed.out.find("a%20b.html#edge="), std::string::npos) << followed.out;
  EXPECT_EQ(run({"follow", "cube", "--max-sets", "60", "-o", path("m.limpet")}).out.find(".html#"),
            std::string::npos);
  std::string model = read(path("m.limpet"));
  const std::size_t polygon = model.find("\npolygon ") + 9, count = model.find(' ', polygon);
  model.replace(count + 1, model.find(' ', count + 1) - count - 1, "1");  // more readings than it says
  write("wrong.limpet", model);
  const auto checked = run({"check", path("wrong.limpet"), "--page", "p.html"});
  EXPECT_EQ(checked.code, 1);
  EXPECT_NE(checked.out.find("; see p.html#polygon=" + model.substr(polygon, count - polygon)),
            std::string::npos)
      << checked.out;
}

/// A run without its end is one that was killed: what there is of it is shown.
TEST_F(View, ShowsWhatThereIsOfARunThatWasKilled) {
  require_pages();
  if (IsSkipped()) return;
  record("r.run");
  const std::string whole = read(path("r.run"));
  write("killed.run", whole.substr(0, whole.find("\nunreachable_segments") + 1));
  EXPECT_EQ(run({"view", path("killed.run"), "-o", path("p.html")}).code, 0);
  EXPECT_TRUE(exists("p.html"));
}

}  // namespace
}  // namespace limpet::app
