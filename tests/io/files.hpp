// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limpet/io/error.hpp>
#include <limpet/io/scan_reader.hpp>
#include <string>
#include <vector>

namespace limpet::io::testing {

/// A test with a folder of its own, gone when it ends.
class FileTest : public ::testing::Test {
 protected:
  FileTest() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        std::filesystem::temp_directory_path() / ("limpet-" + std::string(test->test_suite_name()) + "-" +
                                                  test->name() + "-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  ~FileTest() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

  static std::string read(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  std::filesystem::path folder_;
};

/// All a scan gave before its end or its damage.
struct ScanResult {
  std::vector<ScanRecord> records;
  long skipped = 0;
  std::string error;  ///< empty: none
};

inline ScanResult read_scan(const std::string& path, const ScanOptions& options = {}) {
  ScanResult result;
  std::unique_ptr<ScanReader> reader;
  try {
    reader = open_scan(path, options);
    ScanRecord record;
    while (reader->next(record)) result.records.push_back(record);
  } catch (const InputError& error) {
    result.error = error.what();
  }
  if (reader) result.skipped = reader->skipped();
  return result;
}

/// The bytes of numbers as they lie in memory, or turned round.
template <class Number>
void put(std::string& bytes, Number value, bool big_endian = false) {
  const char* raw = reinterpret_cast<const char*>(&value);
  std::string piece(raw, raw + sizeof value);
  if (big_endian) piece.assign(piece.rbegin(), piece.rend());
  bytes += piece;
}

#define EXPECT_VECTOR(vector, X, Y, Z)             \
  do {                                             \
    EXPECT_EQ((vector), Eigen::Vector3d(X, Y, Z)); \
  } while (false)

}  // namespace limpet::io::testing
