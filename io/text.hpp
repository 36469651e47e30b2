// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <charconv>
#include <cstdint>
#include <limpet/model/record.hpp>
#include <string>
#include <string_view>

/// Numbers to text and back, the same in every locale.
namespace limpet::io {

/// Reads the whole of `token` as a number; false when it is none. Accepts a leading '+', "nan" and "inf"; a
/// value too large for a double becomes infinite, one too small becomes zero.
bool parse_double(std::string_view token, double& value);

/// Reads the whole of `token` as a decimal integer that fits; false otherwise. No leading '+' or blanks.
bool parse_integer(std::string_view token, std::int64_t& value);
bool parse_integer(std::string_view token, std::uint64_t& value);
bool parse_integer(std::string_view token, model::Int128& value);

/// Appends the shortest decimal that reads back to the same bits.
void append(std::string& text, double value);
void append(std::string& text, std::int64_t value);
void append(std::string& text, std::uint64_t value);
void append(std::string& text, model::Int128 value);

/// A number for people: up to four significant digits, as printf's %.4g.
std::string short_text(double number);
/// The number that short_text() prints, so that what was printed can be typed and means the same.
double short_number(double number);
/// "1,234,567"
std::string grouped(std::int64_t number);

/// `text` without the blanks (spaces and tabs) at its ends.
std::string_view without_blanks(std::string_view text);

/// Cuts the next token off `rest` (between tokens: blanks and, where `commas`, commas and semicolons); empty
/// at the end of the line.
std::string_view next_token(std::string_view& rest, bool commas = false);

/// "'x' is not a number" for a message, and what to do about it where that can be told.
std::string no_number(std::string_view token);

/// `token` for a message: in quotes, unprintable bytes replaced, cut after 30 characters.
std::string in_quotes(std::string_view token);

/// The extension of `path` in lower case without its dot; empty when there is none.
std::string extension_of(std::string_view path);

}  // namespace limpet::io
