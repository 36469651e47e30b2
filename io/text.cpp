// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <limits>
#include <limpet/io/text.hpp>

namespace limpet::io {
namespace {

template <class Number>
bool parse_whole(std::string_view token, Number& value) {
  const char* end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  return error == std::errc() && stop == end;
}

template <class Number>
void append_number(std::string& text, Number value) {
  char buffer[40];
  const auto [stop, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, stop);
}

bool is_blank(char c, bool commas) { return c == ' ' || c == '\t' || (commas && (c == ',' || c == ';')); }

}  // namespace

bool parse_double(std::string_view token, double& value) {
  if (!token.empty() && token.front() == '+') {
    token.remove_prefix(1);
    if (!token.empty() && token.front() == '-') return false;
  }
  const char* end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (stop != end || token.empty()) return false;
  if (error == std::errc()) return true;
  if (error != std::errc::result_out_of_range) return false;
  // from_chars does not say which end of the range was left. Digits before the point or a positive exponent
  // cannot make a number too small, so a negative exponent or a leading zero tells.
  const std::string_view digits = token.front() == '-' ? token.substr(1) : token;
  const auto exponent = digits.find_first_of("eE");
  const bool tiny = exponent != std::string_view::npos ? digits.substr(exponent + 1).starts_with('-')
                                                       : digits.starts_with('0') || digits.starts_with('.');
  value = tiny ? 0.0 : std::numeric_limits<double>::infinity();
  if (token.front() == '-') value = -value;
  return true;
}

bool parse_integer(std::string_view token, std::int64_t& value) { return parse_whole(token, value); }
bool parse_integer(std::string_view token, std::uint64_t& value) { return parse_whole(token, value); }

bool parse_integer(std::string_view token, model::Int128& value) {
  const bool negative = token.starts_with('-');
  if (negative) token.remove_prefix(1);
  if (token.empty()) return false;
  value = 0;
  for (const char c : token) {
    if (c < '0' || c > '9') return false;
    const int digit = negative ? '0' - c : c - '0';
    if (__builtin_mul_overflow(value, model::Int128{10}, &value)) return false;
    if (__builtin_add_overflow(value, model::Int128{digit}, &value)) return false;
  }
  return true;
}

void append(std::string& text, double value) { append_number(text, value); }
void append(std::string& text, std::int64_t value) { append_number(text, value); }
void append(std::string& text, std::uint64_t value) { append_number(text, value); }

void append(std::string& text, model::Int128 value) {
  char buffer[40];
  char* begin = buffer + sizeof buffer;
  const bool negative = value < 0;
  do {  // digit by digit with their own sign: the lowest number has no positive counterpart
    const int digit = static_cast<int>(value % 10);
    *--begin = static_cast<char>('0' + (negative ? -digit : digit));
    value /= 10;
  } while (value != 0);
  if (negative) *--begin = '-';
  text.append(begin, buffer + sizeof buffer);
}

std::string short_text(double number) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, number, std::chars_format::general, 4).ptr;
  return {text, end};
}

double short_number(double number) {
  double value = number;
  parse_double(short_text(number), value);
  return value;
}

std::string grouped(std::int64_t number) {
  std::string text = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > (number < 0 ? 1 : 0); at -= 3) {
    text.insert(static_cast<std::size_t>(at), 1, ',');
  }
  return text;
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front(), false)) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back(), false)) text.remove_suffix(1);
  return text;
}

std::string_view next_token(std::string_view& rest, bool commas) {
  std::size_t begin = 0;
  while (begin < rest.size() && is_blank(rest[begin], commas)) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !is_blank(rest[end], commas)) ++end;
  const std::string_view token = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return token;
}

std::string no_number(std::string_view token) {
  const auto has = [&](char c) { return token.find(c) != std::string_view::npos; };
  std::string text = in_quotes(token) + " is not a number";
  if (has('\n'))
    return text + ": a line feed, where the lines before end with carriage returns; end all alike";
  if (has('\r')) return text + ": a carriage return, where lines end with line feeds; end all lines alike";
  if (has('\0')) return text + ": it has bytes of zero; save UTF-16 as UTF-8 (or is this a binary file?)";
  if (has('"')) return text + ": it is in quotes; write it without them";
  if (has(',')) return text + ": numbers have decimal points here, not commas, and blanks between them";
  return text;
}

std::string in_quotes(std::string_view token) {
  std::string text = "'";
  for (const char c : token.substr(0, 30)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (token.size() > 30 ? "...'" : "'");
}

std::string extension_of(std::string_view path) {
  const auto slash = path.find_last_of('/');
  if (slash != std::string_view::npos) path.remove_prefix(slash + 1);
  const auto dot = path.find_last_of('.');
  if (dot == std::string_view::npos) return {};
  std::string extension(path.substr(dot + 1));
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

}  // namespace limpet::io
