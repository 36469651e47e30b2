// Copyright the limpet authors. GPL-3.0-or-later.
#include "run_fields_internal.hpp"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limpet/app/arguments.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/text.hpp>

namespace limpet::app::internal {
namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 24;  // no set is that long: this is some other file

/// Reads a number in hexadecimal or decimal form; false when it is none.
bool parse_number(std::string_view token, double& value) {
  const bool negative = token.starts_with('-');
  const std::string_view size = token.substr(negative ? 1 : 0);
  if (!size.starts_with("0x")) return io::parse_double(token, value) && !token.starts_with('+');
  const char *first = size.data() + 2, *last = size.data() + size.size();
  if (first == last || *first == '-') return false;
  const auto [end, error] = std::from_chars(first, last, value, std::chars_format::hex);
  if (negative) value = -value;
  return error == std::errc() && end == last;
}

}  // namespace

RunFields::RunFields(const std::string& path) : path_(path) {
  refuse_folder(path);
  stream_.open(path, std::ios::binary);
  if (!stream_) throw io::InputError(path, std::string("cannot be read: ") + std::strerror(errno));
}

void RunFields::fail(const std::string& what) const {
  throw io::InputError(path_, "line " + std::to_string(line_) + ": " + what + "; see docs/run_format.md");
}

bool RunFields::next() {
  ++line_;
  text_.clear();
  for (int c = stream_.get(); c != '\n'; c = stream_.get()) {
    if (c == std::ifstream::traits_type::eof()) return false;
    if (text_.size() == kLongestLine) fail("the line is too long");
    text_ += static_cast<char>(c);
  }
  rest_ = text_;
  before_ = with_;
  with_.add(std::string_view(text_));
  return true;
}

void RunFields::line(std::string_view word) {
  if (!line_if_any(word)) fail("the file ends where '" + std::string(word) + "' was expected (truncated?)");
}

bool RunFields::line_if_any(std::string_view word) {
  if (!next()) return false;
  if (!optional(word))
    fail("expected '" + std::string(word) + "', found " + io::in_quotes(rest_.substr(0, rest_.find(' '))));
  return true;
}

void RunFields::done() const {
  if (!rest_.empty()) fail("more fields than the format has: " + io::in_quotes(rest_));
}

void RunFields::nothing_more() {
  ++line_;
  if (stream_.peek() != std::ifstream::traits_type::eof()) fail("something follows 'end'");
}

bool RunFields::optional(std::string_view word) {
  const auto blank = rest_.find(' ');
  if (rest_.substr(0, blank) != word) return false;
  rest_.remove_prefix(blank == rest_.npos ? rest_.size() : blank + 1);
  return true;
}

std::string_view RunFields::word() {
  const std::string_view token = rest_.substr(0, rest_.find(' '));
  if (token.empty()) fail("a field is missing");
  optional(token);
  return token;
}

std::string RunFields::one_of(std::initializer_list<std::string_view> words) {
  const std::string_view found = word();
  std::string known;
  for (const std::string_view one : words) {
    if (found == one) return std::string(one);
    known += (known.empty() ? "" : ", ") + std::string(one);
  }
  fail(io::in_quotes(found) + " is none of " + known);
}

double RunFields::any_real() {
  const std::string_view token = word();
  double value = 0;
  if (!parse_number(token, value) || std::isnan(value)) fail(io::in_quotes(token) + " is not a number");
  return value;
}

double RunFields::real() {
  const double value = any_real();
  if (!std::isfinite(value)) fail("a number must be finite");
  return value;
}

Eigen::Vector3d RunFields::vector() {
  const double x = real(), y = real(), z = real();
  return {x, y, z};
}

template <class Integer>
Integer RunFields::integer() {
  const std::string_view token = word();
  Integer value = 0;
  if (!io::parse_integer(token, value)) fail(io::in_quotes(token) + " is not a whole number that fits here");
  return value;
}
template std::int64_t RunFields::integer();
template std::uint64_t RunFields::integer();

std::size_t RunFields::index(std::size_t bound, const char* what) {
  const std::size_t i = count();
  if (i >= bound)
    fail("there is no " + std::string(what) + " " + std::to_string(i) + ": there are " +
         std::to_string(bound));
  return i;
}

}  // namespace limpet::app::internal
