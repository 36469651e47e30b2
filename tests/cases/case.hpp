// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <iosfwd>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Cases: small inputs as plain text, each with the laws that must hold for it. What fuzzing finds is reduced
/// and kept as such a text in tests/corpus; the tests replay all of them, and the fuzzers start from them.
namespace limpet::cases {

/// A law that did not hold, and where.
struct BrokenLaw {
  std::string law;   ///< its name, one word
  std::string what;  ///< one line
};

/// Collects the broken laws of one trial: empty, all hold.
class Verdicts {
 public:
  void require(bool holds, const char* law, const std::string& what) {
    if (!holds) broken_.push_back({law, what});
  }
  bool sound() const { return broken_.empty(); }
  const std::vector<BrokenLaw>& broken() const { return broken_; }

 private:
  std::vector<BrokenLaw> broken_;
};

/// A text that is no case; what() names the line.
class CaseError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The lines of a case, word by word; comments (#) and empty lines are passed over.
class CaseLines {
 public:
  explicit CaseLines(std::string_view text) : rest_(text) {}

  /// Goes to the next line; false at the end.
  bool next();
  /// Lets next() give the same line again.
  void back() { kept_ = true; }
  const std::string& word(std::size_t i) const;
  double real(std::size_t i) const;
  long long whole(std::size_t i) const;
  std::size_t size() const { return words_.size(); }
  bool is(std::string_view first) const { return !words_.empty() && words_[0] == first; }
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string_view rest_;
  std::vector<std::string> words_;
  int line_ = 0;
  bool kept_ = false;
};

/// A double as the shortest text that reads back to it.
std::string shown(double);

/// The first line says of what kind a case is: "limpet case perimeter".
inline constexpr std::string_view kCaseMagic = "limpet case ";

}  // namespace limpet::cases
