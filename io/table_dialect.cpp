// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/io/table_dialect.hpp>

#include <algorithm>
#include <limpet/io/error.hpp>
#include <limpet/io/text.hpp>

namespace limpet::io {
namespace {

constexpr auto kNowhere = std::string_view::npos;

bool has(std::string_view text, char c) { return text.find(c) != kNowhere; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::size_t digits_at(std::string_view text) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
}

/// A number whose only comma is its decimal sign, or that has none; `point` becomes it with a decimal point.
bool is_with_decimal_comma(std::string_view word, std::string& point) {
  const auto comma = word.find(',');
  if (has(word, '.')) return false;
  point = word;
  if (comma != kNowhere) {
    if (comma == 0 || comma + 1 == word.size()) return false;
    if (!is_digit(word[comma - 1]) || !is_digit(word[comma + 1])) return false;
    point[comma] = '.';
  }
  double value = 0;
  return parse_double(point, value);
}

/// 1,234,567 or 1,234.5
bool is_with_thousands(std::string_view word) {
  if (!word.empty() && (word.front() == '-' || word.front() == '+')) word.remove_prefix(1);
  const std::size_t first = digits_at(word);
  if (first < 1 || first > 3) return false;
  word.remove_prefix(first);
  while (word.starts_with(',')) {
    if (digits_at(word.substr(1)) != 3) return false;
    word.remove_prefix(4);
  }
  return word.empty() || word.front() == '.';
}

/// Where the commas of a row lie that has blanks or commas between its numbers.
struct Commas {
  int inside = 0;                  ///< words that have commas inside
  int beside = 0, not_beside = 0;  ///< blanks with a comma before or after them, and without
  int words = 0;                   ///< between blanks, without commas at their ends
  bool all_decimal = true;         ///< the words are numbers that have decimal commas, or whole ones
  bool all_numbers = true;         ///< the same, or have thousands set off by commas, or are other numbers
};

Commas commas_of(std::string_view row) {
  Commas commas;
  bool is_first = true, after_comma = false;
  std::string point;
  double value = 0;
  for (auto word = next_token(row); !word.empty(); word = next_token(row)) {
    if (!is_first) ++(after_comma || word.starts_with(',') ? commas.beside : commas.not_beside);
    is_first = false;
    after_comma = word.ends_with(',');
    if (word.starts_with(',')) word.remove_prefix(1);
    if (word.ends_with(',')) word.remove_suffix(1);
    if (word.empty()) continue;
    ++commas.words;
    commas.inside += has(word, ',');
    const bool decimal = is_with_decimal_comma(word, point);
    commas.all_decimal &= decimal;
    commas.all_numbers &= decimal || is_with_thousands(word) || parse_double(word, value);
  }
  return commas;
}

char separator_of(std::string_view row, const std::string& where) {
  if (has(row, ';')) return ';';
  if (!has(row, ',')) return ' ';
  constexpr int kFewest = 3;
  const Commas commas = commas_of(row);
  if (commas.not_beside == 0) {
    const bool either = commas.inside > 0 && commas.words >= kFewest && commas.all_numbers;
    if (!either) return ',';
  } else if (commas.beside == 0 && commas.words >= kFewest && commas.all_decimal) {
    return ' ';
  }
  throw InputError(where, "the commas of " + in_quotes(row) +
                              " could be decimal signs or separate numbers; write decimal points, and one "
                              "separator all through");
}

}  // namespace

TableDialect::TableDialect(std::string_view row, const std::string& where)
    : separator_(separator_of(row, where)), decimal_(separator_ == ',' ? '.' : '\0') {}

std::string_view TableDialect::cut(std::string_view& rest) const {
  if (separator_ == ' ') {
    const char* const begin = rest.data();
    const char* const last = begin + rest.size();
    const char* end = begin;
    while (end != last && !is_blank(*end)) ++end;
    const char* next = end;
    while (next != last && is_blank(*next)) ++next;
    rest = {next, last};
    return {begin, end};
  }
  const std::size_t end = std::min(rest.find(separator_), rest.size());
  const std::string_view field = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return without_blanks(field);
}

std::vector<std::string> TableDialect::fields(std::string_view row) const {
  std::vector<std::string> fields;
  while (!row.empty()) fields.emplace_back(cut(row));
  return fields;
}

bool TableDialect::number(std::string_view field, double& value) {
  if (decimal_ == '.') return parse_double(field, value);
  if (decimal_ == 0 && parse_double(field, value)) {
    if (has(field, '.')) decimal_ = '.';
    return true;
  }
  if (!is_with_decimal_comma(field, point_)) return false;
  if (has(field, ',')) decimal_ = ',';
  return parse_double(point_, value);
}

const char* TableDialect::separators() const {
  return separator_ == ' ' ? "blanks" : separator_ == ',' ? "commas" : "semicolons";
}

std::string TableDialect::fault(std::string_view field) const {
  if (field.empty())
    return std::string("no number between two ") + separators() + "; write nan where there is none";
  const bool comma = separator_ != ',' && has(field, ','), point = has(field, '.');
  if (comma && point)
    return in_quotes(field) + " has a comma and a point; write decimal points, and nothing between thousands";
  if (comma && decimal_ == '.')
    return in_quotes(field) +
           " has a comma, where numbers before it have decimal points; write them all alike";
  if (point && decimal_ == ',')
    return in_quotes(field) +
           " has a point, where numbers before it have decimal commas; write them all alike";
  const std::string_view others = separator_ == ' ' ? ",;" : separator_ == ',' ? " \t;" : " \t,";
  if (field.find_first_of(others) != kNowhere && field.find_first_of("\r\n") == kNowhere)
    return in_quotes(field) + " is not a number; " + separators() + " separate the numbers of this table";
  return no_number(field);
}

bool TableDialect::could_be_halves(const std::vector<std::string>& fields) const {
  if (separator_ != ',' || fields.size() < 6 || fields.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string_view half = fields[i];
    const bool is_first = i % 2 == 0;
    const std::size_t sign = is_first && (half.starts_with('-') || half.starts_with('+'));
    const std::size_t digits = digits_at(half.substr(sign));
    if (digits == 0) return false;
    if (sign + digits < half.size() && (is_first || half[digits] != '.')) return false;
  }
  return true;
}

bool TableDialect::has_idle_zero(std::string_view field) {
  return field.size() > 1 && field[0] == '0' && is_digit(field[1]);
}

}  // namespace limpet::io
