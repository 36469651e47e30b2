// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace limpet::io {

/// A file (or standard input) read forwards through a buffer of 1 MiB, by lines or by bytes, with the place
/// kept for messages. Views it returns are good until the next call.
class ByteSource {
 public:
  /// Opens `path`; "-" is standard input. `stop`, where there is one, is asked while bytes of a pipe or a
  /// terminal are waited for, ten times a second; once it says true, the input ends there, after its last
  /// whole line. Errors: InputError when there is no such file, or it is a folder.
  explicit ByteSource(const std::string& path, std::function<bool()> stop = {});
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// The next bytes without taking them: at least `count` (at most 1 MiB) unless the file ends before.
  std::string_view peek(std::size_t count);

  /// Takes the next line, without its end; false at the end of the file. The first line's end tells how all
  /// of the lines end: with a line feed (and the carriage returns before it), or with a carriage return
  /// alone. The other of the two stays in the line, where it is no blank (see no_number()). Errors:
  /// InputError on a line longer than 1 MiB, which no scan has.
  bool line(std::string_view& text);

  /// Passes over a byte order mark. Precondition: nothing has been taken yet. Errors: InputError when the
  /// mark is that of UTF-16, which nothing here reads.
  void skip_byte_order_mark();

  /// Takes exactly `count` bytes (at most 1 MiB); an empty view when the file has fewer left.
  std::string_view take(std::size_t count);

  /// Drops `count` bytes; false when the file has fewer left.
  bool skip(std::uint64_t count);

  bool at_end() { return peek(1).empty(); }

  std::int64_t line_number() const { return line_number_; }  ///< of the line last taken, from 1
  std::int64_t offset() const { return offset_; }            ///< bytes taken so far
  const std::string& name() const { return name_; }          ///< for messages

  /// "name: line 12" and "name: byte 345", for the front of a message.
  std::string here_line() const;
  std::string here_byte() const;

 private:
  bool fill();
  /// Until there are bytes, or none will come. False: it is to stop.
  bool wait() const;
  char first_line_end();

  std::string name_;
  std::function<bool()> stop_;
  int file_ = -1;
  bool waits_ = false, ended_ = false, stopped_ = false;
  char line_end_ = 0;  ///< 0: no line has been taken yet
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  std::int64_t line_number_ = 0, offset_ = 0;
};

}  // namespace limpet::io
