// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/io/byte_source.hpp>
#include <limpet/io/scan_reader.hpp>
#include <memory>

/// The readers of the single formats; the source stands at the file's first byte. A new format adds a line
/// here, a file of its own, and a case in open_scan.
namespace limpet::io {

using SourcePtr = std::unique_ptr<ByteSource>;

/// open_scan() of a source that stands at its first byte. `path` tells the format where its bytes do not.
std::unique_ptr<ScanReader> open_scan(SourcePtr source, const std::string& path, const ScanOptions& options);

std::unique_ptr<ScanReader> open_ply(SourcePtr source, const ScanOptions& options);
std::unique_ptr<ScanReader> open_pcd(SourcePtr source, const ScanOptions& options);
/// XYZ and PWN: columns of numbers, a line a point.
std::unique_ptr<ScanReader> open_table(SourcePtr source, const ScanOptions& options);

/// The one line that says a mesh was given for a scan.
[[noreturn]] void refuse_mesh(const ByteSource& source, const std::string& where, const std::string& what);

}  // namespace limpet::io
