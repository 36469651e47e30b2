// Copyright the limpet authors. GPL-3.0-or-later.
//
// How tables write their numbers: each is read as it is meant, or refused by a line that says why.
#include <algorithm>
#include <limpet/io/text.hpp>
#include <random>
#include <sstream>

#include "files.hpp"

namespace limpet::io::testing {
namespace {

class TableDialectTest : public FileTest {
 protected:
  void expect_points(const std::string& text, const std::vector<Eigen::Vector3d>& points) const {
    const ScanResult scan = read_scan(write("a.xyz", text));
    EXPECT_EQ(scan.error, "") << text;
    ASSERT_EQ(scan.records.size(), points.size()) << text;
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_EQ(scan.records[i].point.position, points[i]) << text;
  }

  /// Refused after `points` points by one line that has `parts` in it.
  void expect_refused(const std::string& text, std::size_t points,
                      const std::vector<std::string>& parts) const {
    const ScanResult scan = read_scan(write("a.xyz", text));
    EXPECT_EQ(scan.records.size(), points) << text;
    EXPECT_EQ(scan.error.rfind(path("a.xyz") + ": ", 0), 0u) << text << " -> " << scan.error;
    EXPECT_EQ(scan.error.find_first_of("\r\n"), std::string::npos) << scan.error;
    for (const std::string& part : parts)
      EXPECT_NE(scan.error.find(part), std::string::npos) << text << " -> " << scan.error;
  }
};

TEST_F(TableDialectTest, DecimalCommas) {
  expect_points("101,344;208,474;50,000\n-1,5;2;3,25e1\n", {{101.344, 208.474, 50}, {-1.5, 2, 32.5}});
  expect_points("1,5; 2,5; 3,5\n", {{1.5, 2.5, 3.5}});
  expect_points("1,5\t2,5\t3,5\n1\t2\t3\n", {{1.5, 2.5, 3.5}, {1, 2, 3}});
  expect_points("  1,5 2,5 3,5\n", {{1.5, 2.5, 3.5}});
  expect_points("2\n1,5;2;3\n4;5;6\n", {{1.5, 2, 3}, {4, 5, 6}});
}

TEST_F(TableDialectTest, CommasThatSeparate) {
  expect_points("1.5,2.5,3.5\n4,5,6\n", {{1.5, 2.5, 3.5}, {4, 5, 6}});
  expect_points("1.5, 2.5, 3.5\n4 ,5 , 6\n", {{1.5, 2.5, 3.5}, {4, 5, 6}});
  expect_points("1, 2, 3\n4.5,5,6\n", {{1, 2, 3}, {4.5, 5, 6}});
  // Columns of eight characters leave no blank before some numbers.
  expect_points("   1.500,  12.250,-123.456\n1000.125,   0.000,   1.000\n",
                {{1.5, 12.25, -123.456}, {1000.125, 0, 1}});
}

TEST_F(TableDialectTest, WholeNumbersLeaveTheDecimalSignOpen) {
  expect_points("0;0;0\n0,5;0,25;0\n", {{0, 0, 0}, {0.5, 0.25, 0}});
  expect_points("0 0 0\n0,5 0,25 0\n", {{0, 0, 0}, {0.5, 0.25, 0}});
  expect_points("0 0 0\n0.5 0.25 0\n", {{0, 0, 0}, {0.5, 0.25, 0}});
  expect_points("nan;nan;nan\n0,5;0,25;0\n", {{0.5, 0.25, 0}});
  expect_refused("0;0;0\n0,5;0,25;0\n0.5;0;0\n", 2, {"line 3", "'0.5' has a point"});
  expect_refused("0;0;0\n0.5;0.25;0\n0,5;0;0\n", 2, {"line 3", "'0,5' has a comma"});
}

std::string twice(const std::string& row) {
  std::string rows = row;
  rows.append("\n").append(row).append("\n");
  return rows;
}

TEST_F(TableDialectTest, WhatCanBeReadInTwoWaysIsRefused) {
  for (const std::string row :
       {"1,2,3 4,5,6", "1,2,3 4,5,6 7,8,9", "1,5, 2,5, 3,5", "1,5 2 3, 4", "1,5 2.5 3",
        "1,234.5 2,345.6 3,456.7", "1,234.5, 2,345.6, 3,456.7", "1,234,567 2 3"})
    expect_refused(twice(row), 0, {"line 1", in_quotes(row).substr(0, 20), "decimal points"});
  for (const std::string row : {"1.234,5;1;2", "1,234.5;1;2"})
    expect_refused(row + "\n", 0, {"line 1", "a comma and a point"});
  expect_refused("1,234,567;1;2\n", 0, {"line 1", "'1,234,567' is not a number"});
}

TEST_F(TableDialectTest, RowsOfAnotherDialectAreRefused) {
  expect_refused("1 2 3\n4;5;6\n", 1, {"line 2", "'4;5;6'", "blanks separate"});
  expect_refused("1 2 3\n+7,8,9e0\n", 1, {"line 2", "blanks separate"});
  expect_refused("1;2;3\n4 5 6\n", 1, {"line 2", "semicolons separate"});
  expect_refused("1;2;3 4\n", 0, {"line 1", "'3 4'", "semicolons separate"});
  expect_refused("1,2,3\n4,5 6\n", 1, {"line 2", "'5 6'", "commas separate"});
  expect_refused("1.5 2.5 3.5 0 0 1\n1,5 2,5 3,5\n", 1, {"line 2", "'1,5' has a comma"});
}

/// A comma written for a point makes of three numbers six, which could be a point and its normal.
TEST_F(TableDialectTest, HalvesOfNumbersAreNoNumbers) {
  expect_refused("101,344,208,474,50,000\n", 0, {"line 1", "'000' is half a number"});
  expect_refused("101,344,208,474,50,125\n101,344,208,074,50,125\n", 1, {"line 2", "'074' is half a number"});
  expect_refused("1,234.5,2,045.5,3,456.5\n", 0, {"line 1", "'045.5' is half a number"});
  expect_points("# x y z r g b\n1,02,3,04,5,06\n", {{1, 2, 3}});
  expect_points("1,2,3,255,0,9\n", {{1, 2, 3}});
  expect_points("1.5,02,3,04,5,06\n", {{1.5, 2, 3}});
}

TEST_F(TableDialectTest, EmptyFieldsDoNotMoveColumns) {
  expect_refused("1;2;3\n1;;3\n", 1, {"line 2", "no number between two semicolons", "nan"});
  expect_refused("1,2,3,4\n1,,3,4\n", 1, {"line 2", "no number between two commas"});
  expect_refused("1;;3;4\n1;;3;4\n", 0, {"line 1", "no number between"});
  expect_refused("1;;3\n", 0, {"line 1", "no number between"});
  expect_refused(";1;2;3\n", 0, {"line 1", "no number between"});
  expect_refused("1;2;3;;\n", 0, {"line 1", "no number between"});
  expect_points("1;2;3;\n4;5;6\n;;\n7;8;9;\n", {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
}

TEST_F(TableDialectTest, NamesWithEverySeparator) {
  expect_points("label;x;y;z\n9;1,5;2;3\n", {{1.5, 2, 3}});
  expect_points("\"label\",\"X\",\"Y\",\"Z\"\n9,1.5,2,3\n", {{1.5, 2, 3}});
  expect_points("label\tX\tY\tZ\n9\t1,5\t2\t3\n", {{1.5, 2, 3}});
  expect_points("label, x, y, z\n9 1.5 2 3\n", {{1.5, 2, 3}});
  expect_points("\"GPS time\",\"X\",\"Y\",\"Z\"\n9,1.5,2,3\n", {{1.5, 2, 3}});
  expect_points("#label;x;y;z\n9;1,5;2;3\n", {{1.5, 2, 3}});
  const ScanResult scan = read_scan(write("a.csv", "id;x;y;z;;label\n9;1,5;2;3;8;7\n"));
  ASSERT_EQ(scan.records.size(), 1u) << scan.error;
  EXPECT_VECTOR(scan.records[0].point.position, 1.5, 2, 3);
  EXPECT_EQ(scan.records[0].label, 7);
  expect_refused("x;y;z\n1;2;3;0;0;1\n", 0, {"line 2", "6 numbers under 3 names"});
  expect_refused("East;North;Height\n1;2;3\n", 0, {"line 1", "'East' is not a number", "x, y and z"});
}

TEST_F(TableDialectTest, ByteOrderMarks) {
  expect_points(
      "\xef\xbb\xbf"
      "1 2 3\n",
      {{1, 2, 3}});
  expect_points("\xef\xbb\xbfx;y;z\r\n1,5;2;3\r\n", {{1.5, 2, 3}});
  expect_points("\xef\xbb\xbf# label x y z\n9 1 2 3\n", {{1, 2, 3}});
  expect_refused("\xef\xbb\xbf", 0, {"empty"});
  using namespace std::string_literals;
  expect_refused(
      "\xff\xfe"
      "1\0 \0"
      "2\0 \0"
      "3\0\n\0"s,
      0, {"UTF-16", "UTF-8"});
  expect_refused(
      "\xfe\xff\0"
      "1\0 \0"
      "2\0 \0"
      "3\0\n"s,
      0, {"UTF-16", "UTF-8"});
  expect_refused(
      "1\0 \0"
      "2\0 \0"
      "3\0\n\0"s,
      0, {"line 1", "UTF-16"});
}

TEST_F(TableDialectTest, LinesThatEndWithCarriageReturns) {
  std::string text = "# x y z\r";
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 40; ++i) {
    text += std::to_string(i) + " 2 3\r";
    points.emplace_back(i, 2, 3);
  }
  expect_points(text, points);
  text.pop_back();
  expect_points(text, points);
  expect_points("1,5;2;3\r4;5;6\r", {{1.5, 2, 3}, {4, 5, 6}});
  expect_points("\r\r1 2 3\r\r4 5 6\r", {{1, 2, 3}, {4, 5, 6}});
  expect_points("1 2 3\r\n\r\n4 5 6\n7 8 9\r\r\n", {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
  expect_refused("1 2 3\r4 5 x\r", 1, {"line 2", "'x'"});
}

TEST_F(TableDialectTest, LineEndsOfBothKinds) {
  expect_refused("1 2 3\n4\r5 6\n", 1, {"line 2", "carriage return"});
  expect_refused("1 2 3\n4 5 6\r7 8 9\n", 1, {"line 2", "carriage return"});
  expect_refused("1 2 3\r4 5 6\n7 8 9\r", 1, {"line 2", "line feed"});
  expect_refused("1 2 3\n# a comment\r4 5 6\n7 8 9\n", 1, {"line 2", "line feeds", "carriage returns"});
  expect_refused("# a comment\r# another\n1 2 3\n4 5 6\n", 0, {"line 2", "line feeds", "carriage returns"});
}

/// The same numbers, however they are written, are the same points to the last bit.
TEST_F(TableDialectTest, EveryWayToWriteARowGivesTheSamePoints) {
  constexpr std::uint64_t kSeed = 20260711;
  RecordProperty("seed", std::to_string(kSeed));
  std::mt19937_64 random(kSeed);
  std::vector<std::vector<std::string>> rows;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 200; ++i) {
    rows.emplace_back();
    points.emplace_back();
    for (int k = 0; k < 3; ++k) {
      std::ostringstream number;
      number.precision(1 + static_cast<int>(random() % 17));
      number << 1e-3 * static_cast<double>(static_cast<std::int64_t>(random() % 4'000'001) - 2'000'000);
      rows.back().push_back(number.str());
      points.back()[k] = std::stod(number.str());
    }
  }
  for (const std::string separator : {" ", "\t", "  \t ", ";", "; ", " ;\t"}) {
    for (const char decimal : {'.', ','}) {
      for (const std::string end : {"\n", "\r\n", "\r", "\r\n\r\n"}) {
        for (const std::string& mark : {std::string(), std::string("\xef\xbb\xbf")}) {
          std::string text = mark;
          for (std::vector<std::string> row : rows) {
            for (std::string& number : row) std::replace(number.begin(), number.end(), '.', decimal);
            text.append(row[0]).append(separator).append(row[1]).append(separator).append(row[2]).append(end);
          }
          expect_points(text, points);
        }
      }
    }
  }
}

}  // namespace
}  // namespace limpet::io::testing
