// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <fstream>
#include <initializer_list>
#include <limpet/model/digest.hpp>
#include <string>
#include <string_view>

namespace limpet::app::internal {

/// The lines of a file of a run, taken apart field by field. Whatever is wrong is io::InputError with the
/// line. Counts are promises, never reasons to allocate: what they announce is read line by line.
class RunFields {
 public:
  /// Errors: io::InputError when the file cannot be read.
  explicit RunFields(const std::string& path);

  [[noreturn]] void fail(const std::string& what) const;

  /// Goes to the next whole line. False at the end of the file, also when what is left of it is no whole
  /// line.
  bool next();
  /// Goes to the next line, which begins with this word.
  void line(std::string_view word);
  /// The same; false when there is no further whole line.
  bool line_if_any(std::string_view word);
  /// Nothing is left of the line.
  void done() const;
  /// Nothing is left of the file.
  void nothing_more();

  /// Takes the next field if it is this word.
  bool optional(std::string_view word);
  std::string_view word();
  /// One of these words.
  std::string one_of(std::initializer_list<std::string_view> words);
  /// A finite number.
  double real();
  /// It may be infinite, too.
  double any_real();
  Eigen::Vector3d vector();
  template <class Integer>
  Integer integer();
  std::size_t count() { return integer<std::size_t>(); }
  /// A number below `bound` of what is counted, said as `what`.
  std::size_t index(std::size_t bound, const char* what);

  /// Of the lines before this one.
  std::uint64_t digest() const { return before_.value(); }

 private:
  std::string path_;
  std::ifstream stream_;
  std::string text_;
  std::string_view rest_;
  long line_ = 0;
  model::Digest before_, with_;
};

}  // namespace limpet::app::internal
