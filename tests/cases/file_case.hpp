// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case.hpp"

namespace limpet::cases {

/// A file for one of the readers, whole or damaged. Every reader either refuses it, in one line, as the
/// caller's mistake (law refusal; anything else thrown is law exception), or gives what keeps the reader's
/// promises:
///   - scans: finite points, axes of length 1 where there are any, and the same when read again (law
///   promise);
///   - meshes: finite vertices, indices in range, a face for every triangle (law promise);
///   - labels: of a list, one for every line that is no comment (law promise);
///   - native: written again it reads back to the same bytes (law native); what the oracle's own reader
///   refuses,
///     which shares no code with it, it refuses too, and what the oracle finds nothing wrong with, it takes
///     (law grammar); of that, where its grid is that of its resolution, a model can be made (law native),
///     and it stays sound when points come (law audit).
struct FileCase {
  static constexpr const char* kKind = "file";
  std::string format;  ///< ply, pcd, xyz, pwn: a scan; off, stl, obj, mesh-ply: a mesh; labels; limpet
  std::string bytes;
  std::string law;  ///< that it once broke
};

std::optional<BrokenLaw> broken_law(const FileCase&);

std::string to_text(const FileCase&);
/// Throws CaseError.
FileCase file_case(std::string_view text);
std::vector<FileCase> reductions(const FileCase&);

/// A file in memory, under a name that readers can open.
class FileInMemory {
 public:
  /// Throws std::runtime_error when there is no place for it.
  FileInMemory(const std::string& bytes, const std::string& extension);
  ~FileInMemory();
  FileInMemory(const FileInMemory&) = delete;
  FileInMemory& operator=(const FileInMemory&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace limpet::cases
