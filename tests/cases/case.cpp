// Copyright the limpet authors. GPL-3.0-or-later.
#include "case.hpp"

#include <charconv>

namespace limpet::cases {

bool CaseLines::next() {
  if (kept_) return kept_ = false, true;
  words_.clear();
  while (words_.empty() && !rest_.empty()) {
    const auto end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_;
    if (line.starts_with('#')) continue;
    while (!line.empty()) {
      const auto space = line.find(' ');
      if (space != 0) words_.emplace_back(line.substr(0, space));
      line.remove_prefix(space == std::string_view::npos ? line.size() : space + 1);
    }
  }
  return !words_.empty();
}

const std::string& CaseLines::word(std::size_t i) const {
  if (i >= words_.size()) fail("a word is missing");
  return words_[i];
}

double CaseLines::real(std::size_t i) const {
  const std::string& text = word(i);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) fail("'" + text + "' is no number");
  return value;
}

long long CaseLines::whole(std::size_t i) const {
  const std::string& text = word(i);
  long long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) fail("'" + text + "' is no whole number");
  return value;
}

void CaseLines::fail(const std::string& what) const {
  throw CaseError("line " + std::to_string(line_) + ": " + what);
}

std::string shown(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, end};
}

}  // namespace limpet::cases
