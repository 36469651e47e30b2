// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/io/scan_reader.hpp>
#include <memory>
#include <string>

namespace limpet::io {

struct ScanWriterOptions {
  bool ascii = false;   ///< of PLY: text instead of binary little-endian
  bool axes = true;     ///< write ax ay az; a record without an axis gets zeros, which a reader passes over
  bool ranges = false;  ///< with axes: write how far the sensor was, as `range`; 0: not known
  bool labels = false;  ///< write the label, as `int face`
  std::string comment;  ///< one line for the header; line ends become blanks
};

/// Writes a scan as it comes: the number of points need not be known. Nothing is lost: every double reads
/// back as it was. The file gets its name only when close() succeeds; destroyed before, it leaves nothing
/// behind.
class ScanWriter {
 public:
  virtual ~ScanWriter() = default;

  /// Precondition: with labels, the label fits 32 bits (std::invalid_argument). Errors: OutputError.
  virtual void write(const ScanRecord& record) = 0;

  /// Errors: OutputError. Nothing may be written afterwards.
  virtual void close() = 0;
};

/// Creates a scan by the extension of `path`: .ply, or .xyz (text, columns named in its first line).
/// Errors: OutputError for another extension, or a file that cannot be made.
std::unique_ptr<ScanWriter> create_scan(const std::string& path, const ScanWriterOptions& options);

}  // namespace limpet::io
