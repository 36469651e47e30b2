// Copyright the limpet authors. GPL-3.0-or-later.
//
// tools/las_to_ply.py, on a LAS file made here byte by byte after the specification (ASPRS LAS 1.4 R15).
#include <cmath>
#include <limpet/io/scan_reader.hpp>

#include "program.hpp"

namespace limpet::app {
namespace {

class Las : public testing::ProgramTest {
 protected:
  template <class Number>
  static void put(std::string& bytes, std::size_t at, Number value) {
    bytes.replace(at, sizeof value, reinterpret_cast<const char*>(&value), sizeof value);
  }

  /// A flat square of 50 × 50 points 0.1 apart, millimetres on the grid, at map coordinates.
  static std::string las(int minor, int format, std::uint16_t record) {
    const std::uint16_t header_size = minor >= 4 ? 375 : 227;
    std::string bytes(header_size + 10u, '\0');  // ten bytes of something between header and points
    bytes.replace(0, 4, "LASF");
    put<std::uint8_t>(bytes, 24, 1);
    put(bytes, 25, static_cast<std::uint8_t>(minor));
    put(bytes, 94, header_size);
    put(bytes, 96, static_cast<std::uint32_t>(bytes.size()));
    put(bytes, 104, static_cast<std::uint8_t>(format));
    put(bytes, 105, record);
    if (minor >= 4) {
      put<std::uint64_t>(bytes, 247, 2500);
    } else {
      put<std::uint32_t>(bytes, 107, 2500);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      put(bytes, 131 + 8 * i, 0.001);
      put(bytes, 155 + 8 * i, i == 0 ? 500'000.0 : i == 1 ? 5'400'000.0 : 100.0);
    }
    for (int i = 0; i < 2500; ++i) {
      std::string point(record, '\xff');
      put(point, 0, std::int32_t{100 * (i % 50)});
      put(point, 4, std::int32_t{100 * (i / 50)});
      put(point, 8, std::int32_t{-250});
      put(point, format >= 6 ? 16 : 15, static_cast<std::uint8_t>(format >= 6 ? 200 : 0xE6));  // flags above
      bytes += point;
    }
    return bytes;
  }

  int convert(const std::string& from, const std::string& to) const {
    const std::string command = std::string("python3 '") + LIMPET_SOURCE_DIR + "/tools/las_to_ply.py' '" +
                                from + "' > '" + to + "' 2> '" + path("complaint") + "'";
    return std::system(command.c_str());
  }
};

TEST_F(Las, EveryPointOfEveryVersion) {
  struct Kind {
    int minor, format;
    std::uint16_t record;
    std::int64_t label;
  };
  for (const Kind& kind :
       {Kind{0, 0, 20, 6}, Kind{2, 1, 28, 6}, Kind{3, 3, 40, 6}, Kind{4, 6, 30, 200}, Kind{4, 7, 36, 200}}) {
    const std::string file = write("a.las", las(kind.minor, kind.format, kind.record));
    ASSERT_EQ(convert(file, path("a.ply")), 0) << read(path("complaint"));
    const auto scan = io::open_scan(path("a.ply"), {});
    io::ScanRecord record;
    int i = 0;
    for (; scan->next(record); ++i) {
      const int column = i % 50, row = i / 50;
      const Eigen::Vector3d truth(500'000 + 0.1 * column, 5'400'000 + 0.1 * row, 99.75);
      ASSERT_NEAR((record.point.position - truth).norm(), 0, 1e-8);
      ASSERT_EQ(record.label, kind.label);
    }
    EXPECT_EQ(i, 2500);
  }
}

TEST_F(Las, IsModelled) {
  ASSERT_EQ(convert(write("a.las", las(4, 6, 30)), path("a.ply")), 0);
  const auto result =
      run({"model", "-", "-o", path("m.limpet"), "--noise", "0.001", "--json", "-"}, {"", {}, path("a.ply")});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("\"polygons\": 1,"), std::string::npos) << result.out;
}

TEST_F(Las, WhatCannotBeConvertedIsSaid) {
  std::string packed = las(4, 6, 30);
  packed[104] = static_cast<char>(packed[104] | 0x80);
  EXPECT_NE(convert(write("a.laz", packed), path("a.ply")), 0);
  EXPECT_NE(read(path("complaint")).find("compressed"), std::string::npos);
  EXPECT_NE(convert(write("cut.las", las(4, 6, 30).substr(0, 2000)), path("a.ply")), 0);
  EXPECT_NE(read(path("complaint")).find("of the 2500 points"), std::string::npos);
  EXPECT_NE(convert(write("no.las", "something else"), path("a.ply")), 0);
  EXPECT_NE(read(path("complaint")).find("no LAS"), std::string::npos);
}

}  // namespace
}  // namespace limpet::app
