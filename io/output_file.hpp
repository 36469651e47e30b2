// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace limpet::io {

/// A file written aside, in the same folder, and given its final name by close(), once it is on the disk:
/// under that name there is either the old file or the whole new one, even after a loss of power. Destroyed
/// without close(), it leaves nothing behind; nor does a program that is killed, where the file system knows
/// files without a name (else FILE.part...). What exists and is no file (a pipe, /dev/null) is written to as
/// it stands.
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

  /// Flushes, syncs, and gives the file its final name. Errors: OutputError. Nothing may be written
  /// afterwards.
  void close();

  const std::string& path() const { return path_; }

 private:
  [[noreturn]] void fail(const char* doing) const;
  void open_unnamed();
  void open_aside();
  bool link_to(const std::string& name);
  void give_name();
  void sync_folder() const;
  void put(std::string_view bytes);
  void flush();

  std::string path_;     ///< as given
  std::string target_;   ///< the file meant, links followed
  bool device_ = false;  ///< written to as it stands
  std::string aside_;    ///< the name until close(); empty: none
  std::string buffer_;
  int file_ = -1;
};

}  // namespace limpet::io
