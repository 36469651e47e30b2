// Copyright the limpet authors. GPL-3.0-or-later.
#include <filesystem>

#include "../io/files.hpp"
#include "failing_new.hpp"

namespace limpet::memory {
namespace {

using io::testing::put;

class LargeScan : public io::testing::FileTest {};

/// What is promised but cannot be held is one line, and not a crash.
TEST_F(LargeScan, CompressedPointsThatDoNotFitInMemory) {
  std::string bytes =
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 300000000\nHEIGHT 1\n"
      "POINTS 300000000\nDATA binary_compressed\n";
  put(bytes, std::uint32_t{60'000'000});
  put(bytes, std::uint32_t{3'600'000'000});
  const std::string name = write("large.pcd", bytes);
  std::filesystem::resize_file(name, bytes.size() + 60'000'000);  // a hole: zeros, which are literal runs
  fail_above(400'000'000);
  const auto scan = io::testing::read_scan(name);
  relent();
  EXPECT_NE(scan.error.find("large.pcd: its compressed points take 3660 MB of memory"), std::string::npos)
      << scan.error;
  EXPECT_NE(scan.error.find("DATA binary"), std::string::npos) << scan.error;
}

}  // namespace
}  // namespace limpet::memory
