// Copyright the limpet authors. GPL-3.0-or-later.
#include <bit>
#include <iomanip>
#include <limits>
#include <sstream>

#include "files.hpp"

namespace limpet::io::testing {
namespace {

class PlyTest : public FileTest {};

struct Reading {
  double x, y, z, ax, ay, az;
  int face;
};

const std::vector<Reading> kReadings = {
    {0.5, -1.25, 3, 0, 0, -1, 4}, {1e6, 2, -0.125, 0.6, 0.8, 0, 5}, {-7, 0, 0, 0, -1, 0, -3}};

/// The readings among other elements and properties, in one of the three encodings.
std::string ply(const std::string& encoding) {
  const bool ascii = encoding == "ascii", big = encoding == "binary_big_endian";
  std::string bytes = "ply\nformat " + encoding + " 1.0\ncomment made by hand\nobj_info nothing\n";
  bytes += "element camera 2\nproperty list uchar short pose\nproperty char kind\n";
  bytes += "element vertex 3\nproperty uchar red\nproperty double x\nproperty list int ushort seen_by\n";
  bytes +=
      "property double y\nproperty float z\nproperty int face\nproperty double ax\nproperty float32 "
      "quality\n";
  bytes += "property double ay\nproperty double az\nelement note 1\nproperty uint code\nend_header\n";
  const auto number = [&](auto value) {
    if (ascii) {
      std::ostringstream text;
      text << std::setprecision(17) << +value << ' ';
      bytes += text.str();
    } else {
      put(bytes, value, big);
    }
  };
  const auto end_line = [&] {
    if (ascii) bytes += '\n';
  };
  for (int i = 0; i < 2; ++i) {
    number(static_cast<unsigned char>(2));
    number(static_cast<short>(300));
    number(static_cast<short>(-2));
    number(static_cast<signed char>(-1));
    end_line();
  }
  for (const Reading& r : kReadings) {
    number(static_cast<unsigned char>(200));
    number(r.x);
    number(2);
    number(static_cast<unsigned short>(7));
    number(static_cast<unsigned short>(65535));
    number(r.y);
    number(static_cast<float>(r.z));
    number(r.face);
    number(r.ax);
    number(0.5f);
    number(r.ay);
    number(r.az);
    end_line();
  }
  number(9u);
  end_line();
  return bytes;
}

std::string ascii_points(const std::string& properties, const std::string& body, int count) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) + "\n" + properties +
         "end_header\n" + body;
}
const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";

TEST_F(PlyTest, AllEncodingsGiveTheSameRecords) {
  for (const char* encoding : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    SCOPED_TRACE(encoding);
    const ScanResult scan = read_scan(write("scan.ply", ply(encoding)));
    EXPECT_EQ(scan.error, "");
    EXPECT_EQ(scan.skipped, 0);
    ASSERT_EQ(scan.records.size(), kReadings.size());
    for (std::size_t i = 0; i < kReadings.size(); ++i) {
      const Reading& r = kReadings[i];
      EXPECT_VECTOR(scan.records[i].point.position, r.x, r.y, r.z);
      EXPECT_VECTOR(scan.records[i].point.axis, r.ax, r.ay, r.az);
      EXPECT_TRUE(scan.records[i].has_axis);
      EXPECT_EQ(scan.records[i].label, r.face);
    }
  }
}

TEST_F(PlyTest, EveryTypeIsReadInBothByteOrders) {
  for (const bool big : {false, true}) {
    std::string bytes =
        std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
        " 1.0\nelement vertex 1\nproperty char x\nproperty ushort y\nproperty int z\n"
        "property short nx\nproperty uchar ny\nproperty float nz\nproperty uint label\nend_header\n";
    put(bytes, static_cast<signed char>(-100), big);
    put(bytes, static_cast<unsigned short>(65000), big);
    put(bytes, -2000000000, big);
    put(bytes, static_cast<short>(-3), big);
    put(bytes, static_cast<unsigned char>(0), big);
    put(bytes, 4.0f, big);
    put(bytes, 4000000000u, big);
    const ScanResult scan = read_scan(write("types.ply", bytes));
    EXPECT_EQ(scan.error, "");
    ASSERT_EQ(scan.records.size(), 1u);
    EXPECT_VECTOR(scan.records[0].point.position, -100, 65000, -2e9);
    EXPECT_NEAR((scan.records[0].point.axis - Eigen::Vector3d(0.6, 0, -0.8)).norm(), 0, 1e-15);
    EXPECT_EQ(scan.records[0].label, 4000000000);
  }
}

TEST_F(PlyTest, AxisComesFromAxisThenNormalThenViewpoint) {
  ScanOptions options;
  options.viewpoint = Eigen::Vector3d(0, 0, 10);
  const std::string normal = "property float nx\nproperty float ny\nproperty float nz\n";
  const std::string axis = "property float ax\nproperty float ay\nproperty float az\n";
  ScanResult scan =
      read_scan(write("a.ply", ascii_points(kXyz + normal + axis, "0 0 2 1 0 0 0 3 0\n", 1)), options);
  ASSERT_EQ(scan.records.size(), 1u);
  EXPECT_VECTOR(scan.records[0].point.axis, 0, 1, 0);
  scan = read_scan(write("n.ply", ascii_points(kXyz + normal, "0 0 2 2 0 0\n", 1)), options);
  ASSERT_EQ(scan.records.size(), 1u);
  EXPECT_VECTOR(scan.records[0].point.axis, -1, 0, 0);
  scan = read_scan(write("v.ply", ascii_points(kXyz, "0 0 2\n0 0 10\n", 2)), options);
  ASSERT_EQ(scan.records.size(), 1u);
  EXPECT_VECTOR(scan.records[0].point.axis, 0, 0, -1);
  EXPECT_EQ(scan.skipped, 1) << "the point at the viewpoint has no axis";
  scan = read_scan(path("v.ply"));
  ASSERT_EQ(scan.records.size(), 2u);
  EXPECT_FALSE(scan.records[0].has_axis);
  EXPECT_VECTOR(scan.records[0].point.axis, 0, 0, 0);
}

TEST_F(PlyTest, RecordsThatAreNoPointAreCountedAndPassedOver) {
  const std::string properties = kXyz + "property float ax\nproperty float ay\nproperty float az\n";
  const ScanResult scan = read_scan(write(
      "s.ply",
      ascii_points(properties,
                   "nan 0 0 0 0 1\n1 2 3 0 0 1\n0 -inf 0 0 0 1\n0 0 0 0 0 0\n0 0 0 0 nan 1\n4 5 6 1 0 0\n",
                   6)));
  EXPECT_EQ(scan.error, "");
  EXPECT_EQ(scan.skipped, 4);
  ASSERT_EQ(scan.records.size(), 2u);
  EXPECT_VECTOR(scan.records[1].point.position, 4, 5, 6);
}

TEST_F(PlyTest, AxesOfAnyLengthAreNormalised) {
  const std::string properties = kXyz + "property double ax\nproperty double ay\nproperty double az\n";
  const ScanResult scan =
      read_scan(write("l.ply", ascii_points(properties, "0 0 0 3e200 0 4e200\n0 0 0 0 -3e-310 4e-310\n", 2)));
  ASSERT_EQ(scan.records.size(), 2u);
  EXPECT_NEAR((scan.records[0].point.axis - Eigen::Vector3d(0.6, 0, 0.8)).norm(), 0, 1e-15);
  EXPECT_NEAR((scan.records[1].point.axis - Eigen::Vector3d(0, -0.6, 0.8)).norm(), 0, 1e-13);
}

TEST_F(PlyTest, WindowsLineEndsAndBlankLinesDoNotMatter) {
  std::string bytes = ascii_points(kXyz, "1 2 3\n\n4 5 6\n\n", 2), windows;
  for (const char c : bytes) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const ScanResult scan = read_scan(write("w.ply", windows));
  EXPECT_EQ(scan.error, "");
  EXPECT_EQ(scan.records.size(), 2u);
}

/// The first byte of a binary body is a number's, even where it looks like part of a line's end.
TEST_F(PlyTest, HeadersEndTheirLinesInAnyWay) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    for (const bool ascii : {true, false}) {
      for (const unsigned first : {0x3f80000au, 0x3f80000du, 0x3f800020u}) {
        std::string bytes;
        for (const std::string line :
             {"ply", ascii ? "format ascii 1.0" : "format binary_little_endian 1.0", "comment x",
              "element vertex 2", "property float x", "property float y", "property float z", "end_header"})
          bytes += line + end;
        const float x = std::bit_cast<float>(first);
        for (int i = 0; i < 2; ++i) {
          std::ostringstream text;
          text << std::setprecision(17) << x << " 2 3" << end;
          if (ascii) bytes += text.str();
          if (!ascii) put(bytes, x), put(bytes, 2.f), put(bytes, 3.f);
        }
        const ScanResult scan = read_scan(write("a.ply", bytes));
        EXPECT_EQ(scan.error, "");
        ASSERT_EQ(scan.records.size(), 2u);
        for (const ScanRecord& record : scan.records) EXPECT_VECTOR(record.point.position, x, 2, 3);
      }
    }
  }
}

TEST_F(PlyTest, DecimalCommasAndStrayLineEndsAreRefused) {
  const auto error = [&](const std::string& body) {
    return read_scan(write("a.ply", ascii_points(kXyz, body, 2))).error;
  };
  EXPECT_NE(
      error("1 2 3\n4,5 6 7\n").find("a.ply: line 9: '4,5' is not a number: numbers have decimal points"),
      std::string::npos)
      << error("1 2 3\n4,5 6 7\n");
  EXPECT_NE(error("1 2 3\n4 5\r6\n").find("line 9: '5?6' is not a number: a carriage return"),
            std::string::npos)
      << error("1 2 3\n4 5\r6\n");
}

TEST_F(PlyTest, AByteOrderMarkDoesNotMatter) {
  EXPECT_EQ(read_scan(write("a", "\xef\xbb\xbf" + ascii_points(kXyz, "1 2 3\n4 5 6\n", 2))).records.size(),
            2u);
}

TEST_F(PlyTest, DamageIsNamedAfterTheRecordsBeforeIt) {
  const std::string head = "ply\nformat ascii 1.0\n", three = "1 2 3\n4 5 6\n7 8 9\n";
  std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" + kXyz + "end_header\n";
  for (int i = 0; i < 8; ++i) put(binary, 1.5f);
  const std::vector<Damage> damages = {
      {"empty", "", 0, "empty"},
      {"promise too high", ascii_points(kXyz, three, 4), 3, "after 3 of the 4"},
      {"promise too low", ascii_points(kXyz, three, 2), 2, "goes on after the 2"},
      {"huge promise", ascii_points(kXyz, three, 2000000000), 3, "after 3 of the 2000000000"},
      {"line cut", ascii_points(kXyz, "1 2 3\n4 5", 2), 1, "truncated"},
      {"binary cut", binary, 2, "after 2 of the 3"},
      {"garbage", ascii_points(kXyz, "1 2 3\n4 five 6\n", 2), 1, "line 9: 'five' is not a number"},
      {"too many numbers", ascii_points(kXyz, "1 2 3 4\n", 1), 0, "'4' after the numbers"},
      {"header cut", head + "element vertex 3\nproperty float x", 0, "within its header"},
      {"no vertices", head + "element dot 3\n" + kXyz + "end_header\n" + three, 0, "no 'vertex'"},
      {"no z", head + "element vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n", 0, "no z"},
      {"negative count", head + "element vertex -3\n" + kXyz + "end_header\n", 0, "'-3' is not a count"},
      {"count of letters", head + "element vertex many\n" + kXyz + "end_header\n", 0,
       "'many' is not a count"},
      {"unknown type", head + "element vertex 1\nproperty quad x\nend_header\n1\n", 0, "'quad' is no type"},
      {"unknown encoding", "ply\nformat utf8 1.0\nend_header\n", 0, "'utf8'"},
      {"no format", "ply\nelement vertex 1\n" + kXyz + "end_header\n1 2 3\n", 0, "no 'format'"},
      {"unknown word", head + "elephant vertex 1\nend_header\n", 0, "'elephant'"},
      {"orphan property", head + kXyz + "end_header\n", 0, "before the first element"},
      {"two x", head + "element vertex 1\nproperty float x\nproperty float x\nend_header\n", 0, "called 'x'"},
      {"a mesh",
       head + "element vertex 3\n" + kXyz + "element face 1\nproperty list uchar int vertex_indices\n" +
           "end_header\n" + three + "3 0 1 2\n",
       0, "limpet scan"},
  };
  for (const Damage& damage : damages) {
    SCOPED_TRACE(damage.what);
    const ScanResult scan = read_scan(write("damaged.ply", damage.bytes));
    EXPECT_EQ(scan.records.size(), damage.records);
    EXPECT_NE(scan.error.find(damage.says), std::string::npos) << scan.error;
    EXPECT_NE(scan.error.find("damaged.ply"), std::string::npos) << scan.error;
    EXPECT_EQ(scan.error.find('\n'), std::string::npos) << scan.error;
  }
}

TEST_F(PlyTest, ListsThatLieEndAtTheEndOfTheFile) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex 9\n" + kXyz +
                      "property list uint double more\nend_header\n";
  for (const float value : {1.0f, 2.0f, 3.0f}) put(bytes, value);
  put(bytes, 4294967295u);
  ScanResult scan = read_scan(write("lies.ply", bytes));
  EXPECT_EQ(scan.records.size(), 0u);
  EXPECT_NE(scan.error.find("after 0 of the 9"), std::string::npos) << scan.error;
  bytes.replace(bytes.find("uint"), 4, "int ");
  scan = read_scan(write("lies.ply", bytes));
  EXPECT_NE(scan.error.find("negative"), std::string::npos) << scan.error;
}

TEST_F(PlyTest, ElementsWithoutBytesTakeNoTime) {
  const ScanResult scan = read_scan(
      write("e.ply", "ply\nformat ascii 1.0\nelement nothing 9000000000000000000\nelement vertex 1\n" + kXyz +
                         "end_header\n1 2 3\n"));
  EXPECT_EQ(scan.error, "");
  EXPECT_EQ(scan.records.size(), 1u);
}

TEST_F(PlyTest, EmptyFaceElementIsNoMesh) {
  const ScanResult scan =
      read_scan(write("f.ply", "ply\nformat ascii 1.0\nelement vertex 1\n" + kXyz +
                                   "element face 0\nproperty list uchar int vertex_indices\n"
                                   "end_header\n1 2 3\n"));
  EXPECT_EQ(scan.error, "");
  EXPECT_EQ(scan.records.size(), 1u);
}

}  // namespace
}  // namespace limpet::io::testing
