// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace limpet::io {

/// How a table writes its rows. One thing separates numbers in all of it: blanks, a comma, or a semicolon
/// (with or without blanks beside it). Where it is not the comma, numbers may have decimal commas instead of
/// points, but not some the one and some the other.
///
/// A row is given without blanks at its ends. Commas could be either, and are told apart so. In `1,5;2,5;3,5`
/// and `1,5 2,5 3,5` something else separates, and a number has one at most: they are decimal signs. In
/// `1,5,2` and `1, 5, 2` nothing else does: they separate. `1,5, 2,5, 3,5` could be three numbers or six, and
/// what is in `1,5,2 3,4,5` is not clear, either: both are refused.
class TableDialect {
 public:
  /// Settles by the first row of numbers what separates them; the decimal sign is settled by the first number
  /// that has one. Errors: InputError, at `where`, when the row does not tell.
  TableDialect(std::string_view row, const std::string& where);

  /// Cuts the next field off `rest`, with the separator behind it; `rest` is empty after the last. A
  /// separator at the end of a row begins no field; between two others lies an empty one.
  std::string_view cut(std::string_view& rest) const;

  /// All fields of a row.
  std::vector<std::string> fields(std::string_view row) const;

  /// Reads a field as a number; false when it is none, or does not fit the numbers before it.
  bool number(std::string_view field, double& value);

  /// What is the matter with a field that number() did not read, for a message.
  std::string fault(std::string_view field) const;

  /// Could the row's fields, two by two, be the halves of numbers with decimal commas or with thousands set
  /// off, as in 101,344,208,474,50,000? Then no second half may begin with a zero that no number needs.
  bool could_be_halves(const std::vector<std::string>& fields) const;
  static bool has_idle_zero(std::string_view field);

 private:
  const char* separators() const;

  char separator_;     ///< ' ' for blanks, ',' or ';'
  char decimal_ = 0;   ///< '.' or ','; 0: all numbers so far are whole
  std::string point_;  ///< a number being read, written with a point
};

}  // namespace limpet::io
