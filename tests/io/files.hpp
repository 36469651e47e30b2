// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <gtest/gtest.h>

#include <limpet/io/error.hpp>
#include <limpet/io/scan_reader.hpp>
#include <memory>
#include <string>
#include <vector>

#include "../temporary_folder.hpp"

namespace limpet::io::testing {

using FileTest = limpet::testing::TemporaryFolder;

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

/// A file that is damaged, and what is to come of it.
struct Damage {
  const char* what;
  std::string bytes;
  std::size_t records;  ///< before the damage
  const char* says;
};

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
