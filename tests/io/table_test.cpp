// Copyright the limpet authors. GPL-3.0-or-later.
#include <thread>

#include "files.hpp"

namespace limpet::io::testing {
namespace {

class TableTest : public FileTest {};

TEST_F(TableTest, ThreeColumnsArePoints) {
  const ScanResult scan = read_scan(write("a.xyz", "# a comment\n1 2 3\n\n  4\t5 6  \n// another\n+7 8 9e0"));
  EXPECT_EQ(scan.error, "");
  ASSERT_EQ(scan.records.size(), 3u);
  EXPECT_VECTOR(scan.records[1].point.position, 4, 5, 6);
  EXPECT_VECTOR(scan.records[2].point.position, 7, 8, 9);
  EXPECT_FALSE(scan.records[0].has_axis);
}

TEST_F(TableTest, SixColumnsAreNormals) {
  for (const char* name : {"a.xyz", "a.pwn", "a.txt"}) {
    const ScanResult scan = read_scan(write(name, "1 2 3 0 0 2\n4 5 6 0 0 0\n"));
    EXPECT_EQ(scan.error, "") << name;
    ASSERT_EQ(scan.records.size(), 1u) << name;
    EXPECT_EQ(scan.skipped, 1) << name;
    EXPECT_VECTOR(scan.records[0].point.axis, 0, 0, -1);
  }
}

TEST_F(TableTest, CommentNamesTheColumns) {
  const ScanResult scan =
      read_scan(write("a.xyz", "# x y z ax ay az face\n1 2 3 0 0 1 12\n4 5 6 0 1 0 -1\n"));
  EXPECT_EQ(scan.error, "");
  ASSERT_EQ(scan.records.size(), 2u);
  EXPECT_VECTOR(scan.records[0].point.axis, 0, 0, 1);
  EXPECT_EQ(scan.records[0].label, 12);
  EXPECT_EQ(scan.records[1].label, -1);
  const ScanResult colours = read_scan(write("c.xyz", "//X Y Z R G B\n1 2 3 255 0 9\n"));
  ASSERT_EQ(colours.records.size(), 1u);
  EXPECT_FALSE(colours.records[0].has_axis) << "colours are no normals";
}

TEST_F(TableTest, FirstLineOfWordsNamesTheColumns) {
  for (const char* name : {"a.txt", "a.xyz"}) {
    const ScanResult scan =
        read_scan(write(name, "\"X\",\"Y\",\"Z\",\"Classification\"\n1,2,3,6\n4,5,6,2\n"));
    EXPECT_EQ(scan.error, "") << name;
    ASSERT_EQ(scan.records.size(), 2u) << name;
    EXPECT_VECTOR(scan.records[1].point.position, 4, 5, 6);
    EXPECT_EQ(scan.records[1].label, 2);
  }
  EXPECT_NE(read_scan(write("b.xyz", "x y w\n1 2 3\n")).error.find("line 1"), std::string::npos);
  EXPECT_NE(read_scan(write("c.xyz", "x y z\nx y z\n")).error.find("line 2"), std::string::npos);
}

TEST_F(TableTest, ColoursWithoutNamesAreNoNormals) {
  EXPECT_FALSE(read_scan(write("a.xyz", "1 2 3 128 0 9\n4 5 6 0 0 1\n")).records.at(0).has_axis);
  EXPECT_TRUE(read_scan(write("b.xyz", "1 2 3 0 1 0\n4 5 6 0 0 1\n")).records.at(0).has_axis);
  EXPECT_TRUE(read_scan(write("c.xyz", "1 2 3 0 -2 0\n")).records.at(0).has_axis) << "a normal of length 2";
  EXPECT_TRUE(read_scan(write("d.xyz", "# x y z nx ny nz\n1 2 3 0 0 9\n")).records.at(0).has_axis);
}

TEST_F(TableTest, AxesCanBeIgnored) {
  ScanOptions options;
  options.ignore_axes = true;
  options.viewpoint = Eigen::Vector3d(0, 0, 9);
  const ScanResult scan = read_scan(write("a.pwn", "1 2 3 0 0 1\n4 5 6 0 0 0\n"), options);
  ASSERT_EQ(scan.records.size(), 2u) << "a record without a normal is a point all the same";
  EXPECT_FALSE(scan.records[0].has_axis);
}

TEST_F(TableTest, PwnMayBeginWithItsCount) {
  EXPECT_EQ(read_scan(write("a.pwn", "2\n1 2 3 0 0 1\n4 5 6 0 0 1\n")).records.size(), 2u);
  ScanResult scan = read_scan(write("b.pwn", "3\n1 2 3 0 0 1\n4 5 6 0 0 1\n"));
  EXPECT_EQ(scan.records.size(), 2u);
  EXPECT_NE(scan.error.find("after 2 of the 3"), std::string::npos) << scan.error;
  scan = read_scan(write("c.pwn", "1\n1 2 3 0 0 1\n4 5 6 0 0 1\n"));
  EXPECT_EQ(scan.records.size(), 1u);
  EXPECT_NE(scan.error.find("more points than the 1"), std::string::npos) << scan.error;
}

TEST_F(TableTest, DamageIsNamedAfterTheRecordsBeforeIt) {
  ScanResult scan = read_scan(write("a.xyz", "1 2 3\n4 5\n6 7 8\n"));
  EXPECT_EQ(scan.records.size(), 1u);
  EXPECT_NE(scan.error.find("a.xyz: line 2: 2 numbers where the first line has 3"), std::string::npos)
      << scan.error;
  scan = read_scan(write("b.xyz", "1 2 3\n4 5 x\n"));
  EXPECT_EQ(scan.records.size(), 1u);
  EXPECT_NE(scan.error.find("line 2: 'x' is not a number"), std::string::npos) << scan.error;
  scan = read_scan(write("c.xyz", "1 2 3\n4 5 6 7\n"));
  EXPECT_EQ(scan.records.size(), 1u);
  EXPECT_NE(scan.error.find("'7' after the 3 numbers"), std::string::npos) << scan.error;
  scan = read_scan(write("d.xyz", "1 2\n"));
  EXPECT_NE(scan.error.find("expected 'x y z'"), std::string::npos) << scan.error;
  scan = read_scan(write("e.xyz", "1 2 3\n" + std::string(3 << 20, '\x01')));
  EXPECT_EQ(scan.records.size(), 1u);
  EXPECT_NE(scan.error.find("longer than 1 MiB"), std::string::npos) << scan.error;
}

TEST_F(TableTest, WhatIsNoScanIsRefused) {
  EXPECT_NE(read_scan(path("missing.xyz")).error.find("cannot be opened"), std::string::npos);
  EXPECT_NE(read_scan(path("")).error.find("is a folder"), std::string::npos);
  EXPECT_NE(read_scan(write("empty.xyz", "")).error.find("empty"), std::string::npos);
  EXPECT_NE(read_scan(write("m.off", "OFF\n3 1 0\n")).error.find("limpet scan"), std::string::npos);
  EXPECT_NE(read_scan(write("m.STL", "solid x\n")).error.find("limpet scan"), std::string::npos);
  EXPECT_NE(read_scan(write("m.obj", "v 1 2 3\n")).error.find("limpet scan"), std::string::npos);
  EXPECT_NE(read_scan(write("m.xyz", "OFF\n3 1 0\n")).error.find("limpet scan"), std::string::npos);
  EXPECT_NE(read_scan(write("image.jpg", "\xff\xd8\xff\xe0")).error.find("no known scan"), std::string::npos);
  ScanOptions options;
  options.format = "e57";
  EXPECT_NE(read_scan(write("a.xyz", "1 2 3\n"), options).error.find("'e57'"), std::string::npos);
}

TEST_F(TableTest, FirstBytesTellTheFormatWhateverTheName) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int "
      "z\nend_header\n1 2 3\n";
  EXPECT_EQ(read_scan(write("really_ply.xyz", ply)).records.size(), 1u);
  EXPECT_EQ(read_scan(write("no_extension", "1 2 3\n4 5 6\n")).records.size(), 2u);
}

/// Standard input is a pipe more often than not: it comes in pieces and cannot be wound back.
TEST_F(TableTest, StandardInputIsReadAsItComes) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const int before = ::dup(STDIN_FILENO);
  ASSERT_EQ(::dup2(ends[0], STDIN_FILENO), STDIN_FILENO);
  std::thread feeder([out = ends[1]] {
    const std::string text = "# x y z ax ay az\n1 2 3 0 0 1\n4 5 6 0 1 0\n7 8 9 1 0";
    for (const char c : text) EXPECT_EQ(::write(out, &c, 1), 1);
    ::close(out);
  });
  const ScanResult scan = read_scan("-");
  feeder.join();
  ::dup2(before, STDIN_FILENO);
  ::close(before);
  ::close(ends[0]);
  ASSERT_EQ(scan.records.size(), 2u);
  EXPECT_VECTOR(scan.records[1].point.axis, 0, 1, 0);
  EXPECT_EQ(scan.error.rfind("standard input: line 4: 5 numbers", 0), 0u) << scan.error;
}

TEST_F(TableTest, LongScansCrossTheBufferUnharmed) {
  std::string text;
  double sum = 0;
  const int count = 200000;
  for (int i = 0; i < count; ++i) {
    text += std::to_string(i) + " " + std::to_string(i % 7) + ".25 -1\n";
    sum += i + i % 7 + 0.25 - 1;
  }
  ASSERT_GT(text.size(), std::size_t{2} << 20);
  const ScanResult scan = read_scan(write("long.xyz", text));
  EXPECT_EQ(scan.error, "");
  ASSERT_EQ(scan.records.size(), static_cast<std::size_t>(count));
  double found = 0;
  for (const ScanRecord& record : scan.records) found += record.point.position.sum();
  EXPECT_EQ(found, sum);
}

}  // namespace
}  // namespace limpet::io::testing
