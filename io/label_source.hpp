// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/io/byte_source.hpp>
#include <limpet/io/scan_reader.hpp>
#include <memory>
#include <string>

namespace limpet::io {

/// The label of each record of a scan, in order, from the scan itself or from a list with one label a line
/// (as `limpet model --labels` writes it). Records that are no point count too, so that the labels of an
/// organised cloud stay with their pixels.
class LabelSource {
 public:
  /// Opens `path` ("-": standard input): a scan when its name ends in .ply, .pcd, .xyz or .pwn, or it begins
  /// like a PLY or PCD file, else a list. `column` names the scan's column with the labels; empty: see
  /// ScanOptions. Errors: InputError when it cannot be opened, or has no such column.
  LabelSource(const std::string& path, const std::string& column);

  /// The next record's label; -1 for a record that is no point or has no whole number there. False at the
  /// end. Errors: InputError at damage.
  bool next(std::int64_t& label);

  /// A list, as opposed to a scan.
  bool is_list() const { return list_ != nullptr; }

 private:
  bool next_of_list(std::int64_t& label);
  bool next_of_scan(std::int64_t& label);

  std::unique_ptr<ByteSource> list_;
  std::unique_ptr<ScanReader> scan_;
  ScanRecord record_;
  std::int64_t gap_ = 0;      ///< records without a point still to be given out before record_
  std::int64_t skipped_ = 0;  ///< records without a point given out or in the gap
  bool has_record_ = false, ended_ = false;
};

}  // namespace limpet::io
