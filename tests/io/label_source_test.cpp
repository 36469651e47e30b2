// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/io/label_source.hpp>

#include "files.hpp"

namespace limpet::io {
namespace {

class LabelSourceTest : public testing::FileTest {
 protected:
  static std::vector<std::int64_t> labels(const std::string& path, const std::string& column = "") {
    LabelSource source(path, column);
    std::vector<std::int64_t> labels;
    for (std::int64_t label = 0; source.next(label);) labels.push_back(label);
    return labels;
  }

  static std::string error(const std::string& path, const std::string& column = "") {
    try {
      labels(path, column);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
};

using Labels = std::vector<std::int64_t>;

TEST_F(LabelSourceTest, ListHasOneALine) {
  EXPECT_EQ(labels(write("a.txt", "# made by hand\n3\n0\r\n-1\n 17 \n4000000000000")),
            (Labels{3, 0, -1, 17, 4000000000000}));
  EXPECT_EQ(labels(write("b.txt", "3.0\n1.700000000000000000e+01\n")), (Labels{3, 17})) << "as NumPy writes";
  EXPECT_EQ(labels(write("empty.txt", "")), Labels{});
}

TEST_F(LabelSourceTest, ListAsItComesFromOtherSystems) {
  EXPECT_EQ(labels(write("cr.txt", "# by hand\r3\r0\r-1")), (Labels{3, 0, -1}));
  EXPECT_EQ(labels(write("mark.txt", "\xef\xbb\xbf# by hand\n3\n0\n")), (Labels{3, 0}));
  EXPECT_EQ(labels(write("both.txt",
                         "\xef\xbb\xbf"
                         "3\r0\r")),
            (Labels{3, 0}));
  EXPECT_NE(error(write("wide.txt", std::string("\xff\xfe"
                                                "3\0\n\0",
                                                6)))
                .find("UTF-16"),
            std::string::npos);
  EXPECT_NE(error(write("mixed.txt", "3\n0\r1\n")).find("line 2"), std::string::npos);
}

TEST_F(LabelSourceTest, DamagedListSaysTheLine) {
  EXPECT_NE(error(write("a.txt", "1\n2\nx\n")).find("line 3: 'x' is no label"), std::string::npos);
  EXPECT_NE(error(write("b.txt", "1\n2.5\n")).find("line 2"), std::string::npos);
  EXPECT_NE(error(write("c.txt", "1\n\n2\n")).find("line 2"), std::string::npos);
  EXPECT_NE(error(write("d.txt", "1 2\n")).find("line 1: more than one number"), std::string::npos);
  EXPECT_NE(error(write("e.txt", "nan\n")).find("line 1"), std::string::npos);
  EXPECT_NE(error(path("none.txt")).find("none.txt"), std::string::npos);
}

const std::string kPcd =
    "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z plane intensity\nSIZE 4 4 4 4 4\nTYPE F F F I F\nCOUNT 1 1 1 1 "
    "1\n"
    "WIDTH 4\nHEIGHT 2\nVIEWPOINT 0 0 5 1 0 0 0\nPOINTS 8\nDATA ascii\n"
    "nan nan nan 9 9\nnan nan nan 9 9\n0 0 0 1 10\n1 0 0 2 11.5\n"
    "nan nan nan 9 9\n0 0 5 3 12\n1 1 0 4 13\nnan nan nan 9 9\n";

TEST_F(LabelSourceTest, ScanGivesOneARecordPointOrNot) {
  const std::string scan = write("s.pcd", kPcd);
  // The sixth record is where the sensor stands: it has no axis.
  EXPECT_EQ(labels(scan), (Labels{-1, -1, 1, 2, -1, -1, 4, -1}));
  EXPECT_EQ(labels(scan, "intensity"), (Labels{-1, -1, 10, -1, -1, -1, 13, -1})) << "11.5 is no label";
  EXPECT_EQ(labels(write("without_extension", kPcd)), (Labels{-1, -1, 1, 2, -1, -1, 4, -1}));
}

TEST_F(LabelSourceTest, ColumnThatIsNotThere) {
  const std::string scan = write("s.pcd", kPcd);
  EXPECT_NE(error(scan, "class").find("no 'class'; they have x y z plane intensity"), std::string::npos);
  EXPECT_NE(error(scan, "y").find("'y' is a coordinate"), std::string::npos);
}

TEST_F(LabelSourceTest, AListHasNoColumns) {
  EXPECT_NE(error(write("a.txt", "1\n2\n"), "label").find("a.txt: is read as a list"), std::string::npos);
}

TEST_F(LabelSourceTest, PropertyOfAPly) {
  const std::string ply =
      write("s.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nproperty uchar class\nproperty list uchar int tags\n"
            "end_header\n0 0 0 7 0\n1 0 0 8 2 1 1\nnan 1 0 9 0\n");
  EXPECT_EQ(labels(ply), (Labels{7, 8, -1}));
  EXPECT_EQ(labels(ply, "class"), (Labels{7, 8, -1}));
}

}  // namespace
}  // namespace limpet::io
