// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <istream>
#include <limpet/io/error.hpp>
#include <limpet/io/text.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace limpet::io::internal {

/// The longest line of a native file, its end left out: as of a scan (ByteSource).
inline constexpr std::size_t kLongestLine = 1 << 20;

/// Lines of a native file, taken apart field by field. Counts are promises, never reasons to allocate: every
/// record is pushed as its line is read, so a lying count ends at the end of the file.
class Fields {
 public:
  Fields(std::istream& stream, const std::string& name)
      : stream_(stream), name_(name), buffer_(kLongestLine + 1) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(name_ + ": line " + std::to_string(line_) + ": " + what + "; see docs/native_format.md");
  }

  /// Goes to the next line that is no comment.
  void line() {
    if (std::exchange(kept_, false)) return;
    do {
      ++line_;
      read_line();
    } while (rest_.starts_with('#'));
    ended_ = false;
  }

  /// The next line that is no comment begins with this word; otherwise it is kept for line().
  bool optional_line(std::string_view word) {
    line();
    if (rest_.substr(0, rest_.find(' ')) == word) return field(), true;
    kept_ = true;
    return false;
  }

  void line(std::string_view word) {
    line();
    const std::string_view found = field();
    if (found != word) fail("expected '" + std::string(word) + "', found " + in_quotes(found));
  }

  std::string_view field() {
    if (ended_) fail("a field is missing");
    const auto space = rest_.find(' ');
    const std::string_view token = rest_.substr(0, space);
    ended_ = space == std::string_view::npos;
    rest_.remove_prefix(ended_ ? rest_.size() : space + 1);
    return token;
  }

  void done() const {
    if (!ended_) fail("more fields than the format has: " + in_quotes(rest_));
  }

  double real() {
    const std::string_view token = field();
    double value = 0;
    if (!parse_double(token, value) || token.starts_with('+')) fail(in_quotes(token) + " is not a number");
    if (!std::isfinite(value)) fail(in_quotes(token) + " is not a finite number");
    return value;
  }

  /// A number of at most this size; `what` says in a message what a larger one is.
  double real_within(double limit, const char* what) {
    const std::string_view token = rest_.substr(0, rest_.find(' '));
    const double value = real();
    if (!(std::abs(value) <= limit)) fail(in_quotes(token) + " is " + what);
    return value;
  }

  Eigen::Vector3d vector() {
    const double x = real(), y = real(), z = real();
    return {x, y, z};
  }

  Eigen::Vector3d vector_within(double limit, const char* what) {
    const double x = real_within(limit, what), y = real_within(limit, what), z = real_within(limit, what);
    return {x, y, z};
  }

  template <class Integer>
  Integer integer() {
    const std::string_view token = field();
    Integer value = 0;
    if (!parse_integer(token, value)) fail(in_quotes(token) + " is not a whole number that fits here");
    return value;
  }

  std::int64_t count() {
    const auto value = integer<std::int64_t>();
    if (value < 0) fail("a count is negative");
    return value;
  }

  std::string word() {
    const std::string_view token = field();
    if (token.empty()) fail("a word is missing");
    return std::string(token);
  }

  void nothing_more() {
    ++line_;
    if (stream_.peek() != std::istream::traits_type::eof()) fail("something follows 'end'");
  }

 private:
  void read_line() {
    stream_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    const auto taken = static_cast<std::size_t>(stream_.gcount());
    if (stream_.eof())
      fail(taken == 0 ? "the file ends before its 'end' line (truncated?)"
                      : "the file ends within a line (truncated?)");
    if (taken == kLongestLine && stream_.fail()) fail("longer than 1 MiB; is this a binary file?");
    if (stream_.fail()) fail("the file cannot be read any further");
    rest_ = {buffer_.data(), taken - 1};  // the line's end is counted, too
  }

  std::istream& stream_;
  const std::string& name_;
  long line_ = 0;
  std::vector<char> buffer_;  ///< the line
  std::string_view rest_;     ///< of it, what has not been taken
  bool ended_ = true;
  bool kept_ = false;
};

}  // namespace limpet::io::internal
