// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>
#include <filesystem>
#include <limits>
#include <limpet/io/lzf.hpp>

#include "files.hpp"

namespace limpet::io::testing {
namespace {

class PcdTest : public FileTest {};

const float kNan = std::numeric_limits<float>::quiet_NaN();
struct Pixel {
  float x, y, z;
  std::uint32_t label;
};
const std::vector<Pixel> kPixels = {{1, 2, 3, 10}, {kNan, kNan, kNan, 0}, {-0.5f, 0, 4, 4000000000u}};

std::string head(const std::string& data, const std::string& viewpoint = "1 2 -1 1 0 0 0", int height = 1) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS label _ x y z\nSIZE 4 1 4 4 4\n"
         "TYPE U U F F F\nCOUNT 1 3 1 1 1\nWIDTH 3\nHEIGHT " +
         std::to_string(height) + "\nVIEWPOINT " + viewpoint + "\nPOINTS 3\nDATA " + data + "\n";
}

std::string ascii() {
  return head("ascii") + "10 0 0 0 1 2 3\n0 0 0 0 nan nan nan\n4000000000 9 9 9 -0.5 0 4\n";
}

std::string binary() {
  std::string bytes = head("binary");
  for (const Pixel& p : kPixels) {
    put(bytes, p.label);
    bytes += "abc";
    put(bytes, p.x);
    put(bytes, p.y);
    put(bytes, p.z);
  }
  return bytes;
}

/// The block of a compressed file, field by field.
std::string columns() {
  std::string block;
  for (const Pixel& p : kPixels) put(block, p.label);
  block += "abcabcabc";
  for (const Pixel& p : kPixels) put(block, p.x);
  for (const Pixel& p : kPixels) put(block, p.y);
  for (const Pixel& p : kPixels) put(block, p.z);
  return block;
}

/// LZF without a match found: literal runs of up to 32 bytes.
std::string packed(const std::string& bytes) {
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 32) {
    const std::string run = bytes.substr(i, 32);
    out += static_cast<char>(run.size() - 1);
    out += run;
  }
  return out;
}

std::string compressed(const std::string& block, std::uint32_t size) {
  std::string bytes = head("binary_compressed");
  put(bytes, static_cast<std::uint32_t>(block.size()));
  put(bytes, size);
  return bytes + block;
}

TEST_F(PcdTest, AllEncodingsGiveTheSameRecords) {
  const std::string block = columns();
  const std::vector<std::pair<std::string, std::string>> files = {
      {"ascii.pcd", ascii()}, {"binary.pcd", binary()}, {"packed.pcd", compressed(packed(block), 57)}};
  for (const auto& [name, bytes] : files) {
    SCOPED_TRACE(name);
    const ScanResult scan = read_scan(write(name, bytes));
    EXPECT_EQ(scan.error, "");
    EXPECT_EQ(scan.skipped, 1);
    ASSERT_EQ(scan.records.size(), 2u);
    EXPECT_VECTOR(scan.records[0].point.position, 1, 2, 3);
    EXPECT_VECTOR(scan.records[0].point.axis, 0, 0, 1);  // from the viewpoint in the file
    EXPECT_EQ(scan.records[0].label, 10);
    EXPECT_VECTOR(scan.records[1].point.position, -0.5, 0, 4);
    EXPECT_EQ(scan.records[1].label, 4000000000);
  }
}

TEST_F(PcdTest, ViewpointOptionGoesBeforeTheFiles) {
  ScanOptions options;
  options.viewpoint = Eigen::Vector3d(1, 2, 8);
  const ScanResult scan = read_scan(write("a.pcd", ascii()), options);
  ASSERT_EQ(scan.records.size(), 2u);
  EXPECT_VECTOR(scan.records[0].point.axis, 0, 0, -1);
}

TEST_F(PcdTest, IsKnownByItsFirstBytesBehindAnyComments) {
  const std::string comments = "# made by somebody's program\n#\n";
  for (const std::string& bytes :
       {ascii(), comments + ascii(), comments + ascii().substr(ascii().find('\n') + 1)}) {
    const ScanResult scan = read_scan(write("no_extension", bytes));
    EXPECT_EQ(scan.error, "");
    EXPECT_EQ(scan.records.size(), 2u);
  }
}

/// `bytes` with other line ends in the first `lines` lines.
std::string with_line_ends(const std::string& bytes, int lines, const std::string& end) {
  std::string text;
  for (const char c : bytes) {
    if (c == '\n' && lines-- > 0) {
      text += end;
    } else {
      text += c;
    }
  }
  return text;
}

TEST_F(PcdTest, HeadersEndTheirLinesInAnyWay) {
  constexpr int kHeader = 11, kAll = 1000;
  for (const std::string end : {"\r", "\r\n"}) {
    for (const std::string& bytes :
         {with_line_ends(ascii(), kAll, end), with_line_ends(binary(), kHeader, end),
          with_line_ends(compressed(packed(columns()), 57), kHeader, end),
          with_line_ends("# made by hand\n#\n" + ascii(), kAll, end),
          "\xef\xbb\xbf" + with_line_ends(ascii(), kAll, end)}) {
      const ScanResult scan = read_scan(write("no_extension", bytes));
      EXPECT_EQ(scan.error, "");
      ASSERT_EQ(scan.records.size(), 2u);
      EXPECT_VECTOR(scan.records[0].point.position, 1, 2, 3);
      EXPECT_EQ(scan.records[1].label, 4000000000);
    }
  }
}

TEST_F(PcdTest, DecimalCommasAreRefused) {
  const ScanResult scan = read_scan(write("a.pcd", head("ascii") + "10 0 0 0 1 2 3\n10 0 0 0 1,5 2 3\n"));
  EXPECT_EQ(scan.records.size(), 1u);
  EXPECT_NE(scan.error.find("a.pcd: line 13: '1,5' is not a number: numbers have decimal points"),
            std::string::npos)
      << scan.error;
}

TEST_F(PcdTest, NormalsGoBeforeTheViewpoint) {
  const ScanResult scan = read_scan(write(
      "n.pcd",
      "VERSION .7\nFIELDS x y z normal_x normal_y normal_z\nSIZE 4 4 4 4 4 4\nTYPE F F F F F F\nWIDTH 1\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nDATA ascii\n1 2 3 0 -1 0\n"));
  EXPECT_EQ(scan.error, "");
  ASSERT_EQ(scan.records.size(), 1u);
  EXPECT_VECTOR(scan.records[0].point.axis, 0, 1, 0);
}

TEST_F(PcdTest, LzfCopiesMayReachIntoThemselves) {
  // "ab", then 9 bytes from 2 back, then a long copy of 264 bytes from 1 back.
  const std::string bytes{'\x01', 'a', 'b', '\xe0', '\x00', '\x01', '\xe0', '\xff', '\x00'};
  const std::vector<char> out = unpack_lzf(bytes, 2 + 9 + 264);
  EXPECT_EQ(std::string(out.begin(), out.end()), "ababababab" + std::string(1, 'a') + std::string(264, 'a'));
  EXPECT_EQ(unpack_lzf(bytes, 20).size(), 11u) << "a copy beyond the promised size is not made";
  EXPECT_EQ(unpack_lzf(std::string("\x20\x05", 2), 100).size(), 0u) << "nothing lies that far back";
  EXPECT_EQ(unpack_lzf(std::string("\x05"
                                   "ab",
                                   3),
                       100)
                .size(),
            2u)
      << "of a run that is cut, what is there";
}

TEST_F(PcdTest, DamageIsNamedAfterTheRecordsBeforeIt) {
  const std::string block = columns(), whole = binary(), text = ascii();
  const auto changed = [&](const char* from, const char* to) {
    std::string bytes = text;
    return bytes.replace(bytes.find(from), std::string(from).size(), to);
  };
  const std::vector<Damage> damages = {
      {"header cut", text.substr(0, text.find("SIZE")), 0, "within its header"},
      {"binary cut", whole.substr(0, whole.size() - 1), 1, "after 2 of the 3"},
      {"ascii cut", text.substr(0, text.rfind("4000000000")), 1, "after 2 of the 3"},
      {"ascii line cut", text.substr(0, text.size() - 3), 1, "truncated"},
      {"ascii goes on", text + "1 0 0 0 1 1 1\n", 2, "goes on after the 3"},
      {"garbage", changed("1 2 3", "1 zwei 3"), 0, "'zwei' is not a number"},
      {"points", changed("POINTS 3", "POINTS 4"), 0, "WIDTH times HEIGHT"},
      {"overflow", changed("WIDTH 3\nHEIGHT 1", "WIDTH 9000000000000000000\nHEIGHT 9"), 0,
       "more than any file"},
      {"sizes", changed("SIZE 4 1 4 4 4", "SIZE 4 1 4 4"), 0, "not of one length"},
      {"type", changed("TYPE U U F F F", "TYPE U U F F C"), 0, "TYPE 'C'"},
      {"count", changed("COUNT 1 3", "COUNT 1 99999999"), 0, "64 KiB"},
      {"encoding", changed("DATA ascii", "DATA morse"), 0, "'morse'"},
      {"twice", changed("HEIGHT 1", "HEIGHT 1\nWIDTH 3"), 0, "there twice"},
      {"no size block", compressed("", 0).substr(0, head("binary_compressed").size()), 0, "truncated"},
      {"packed cut", compressed(packed(block), 57).substr(0, head("binary_compressed").size() + 8 + 55), 1,
       "within its compressed points"},
      {"packed garbage", compressed(std::string(20, '\xff'), 57), 0, "damaged"},
      {"packed size", compressed(packed(block), 4000000000u), 0, "which are not the 3 points"},
  };
  for (const Damage& damage : damages) {
    SCOPED_TRACE(damage.what);
    const ScanResult scan = read_scan(write("damaged.pcd", damage.bytes));
    EXPECT_EQ(scan.records.size(), damage.records);
    EXPECT_NE(scan.error.find(damage.says), std::string::npos) << scan.error;
    EXPECT_NE(scan.error.find("damaged.pcd"), std::string::npos) << scan.error;
  }
}

}  // namespace
}  // namespace limpet::io::testing
