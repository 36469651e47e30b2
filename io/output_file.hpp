// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace limpet::io {

/// A file written aside, in the same folder, and given its final name by close(), once it is on the disk:
/// under that name there is either the old file or the whole new one, even after a loss of power. Destroyed
/// without close(), it leaves nothing behind; nor does a program that is killed, where the file system knows
/// files without a name. The names it uses aside are random and never those of files that exist.
///
/// A file that it replaces keeps its permissions and, where the system allows it, its owner and group; one
/// that may not be written is not replaced. A symbolic link stays, and the file it leads to is replaced; the
/// system follows it, by its own rules. Of a file with several names (hard links), only this one leads to the
/// new bytes. What exists and is no file (a pipe, /dev/null) is written to as it stands.
class OutputFile {
 public:
  /// Errors: OutputError when the file cannot be made, or the old one may not be written.
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Takes from group and others the right to read what they may not read of `path`; of a file that does not
  /// exist, or is no file, they may read nothing.
  void no_more_readable_than(const std::string& path);

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
  void abandon();
  void find_target();
  void open_folder();
  void open_unnamed();
  void open_aside();
  void take_over_permissions();
  bool link_to(const std::string& name);
  void give_name();
  void put(std::string_view bytes);
  void flush();

  std::string path_;       ///< as given
  bool device_ = false;    ///< written to as it stands
  int folder_ = -1;        ///< of the file meant, links followed
  std::string name_;       ///< in this folder
  int old_ = -1;           ///< the file that is replaced; -1: none
  bool made_old_ = false;  ///< where a link led to nothing: empty, and goes again unless it is replaced
  std::string aside_;      ///< the name until close(); empty: none
  std::string buffer_;
  int file_ = -1;
};

}  // namespace limpet::io
