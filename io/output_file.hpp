// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace limpet::io {

/// A file written aside, in the same folder, and renamed to its final name by close(): under that name there
/// is either the old file or the whole new one. Destroyed without close(), it leaves nothing behind. What
/// exists and is no file (a pipe, /dev/null) is written to as it stands.
class OutputFile {
 public:
  /// Errors: OutputError when the file cannot be made.
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Appends bytes (buffered). Errors: OutputError.
  void write(std::string_view bytes);

  /// Overwrites bytes already written, at `offset` from the beginning. Errors: OutputError.
  void overwrite(std::int64_t offset, std::string_view bytes);

  /// Flushes, and gives the file its final name. Errors: OutputError. Nothing may be written afterwards.
  void close();

  const std::string& path() const { return path_; }

 private:
  [[noreturn]] void fail(const char* doing) const;
  void open_aside();
  void put(std::string_view bytes);
  void flush();

  std::string path_;    ///< as given
  std::string target_;  ///< the file meant, links followed
  std::string aside_;   ///< written until close(); empty: straight to a device
  std::string buffer_;
  int file_ = -1;
};

}  // namespace limpet::io
