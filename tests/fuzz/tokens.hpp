// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "../geometry/perimeter_shapes.hpp"

namespace limpet::fuzz {

/// A part of a text.
struct Span {
  std::size_t begin, length;
};

/// The parts of a text between any of these characters, none of them empty.
inline std::vector<Span> split(const std::string& text, const char* at) {
  std::vector<Span> spans;
  for (std::size_t i = 0; i < text.size();) {
    const auto end = std::min(text.find_first_of(at, i), text.size());
    if (end > i) spans.push_back({i, end - i});
    i = end + 1;
  }
  return spans;
}

/// Changes text so that its grammar mostly stays: numbers are moved a little, exchanged with others of the
/// text or replaced by awkward ones; lines are taken away, doubled or exchanged. Mutations byte by byte
/// hardly ever get past a strict reader.
class TokenMutator {
 public:
  explicit TokenMutator(std::uint64_t seed) : random_(seed) {}

  std::string operator()(std::string text) {
    for (auto n = random_.whole(1, 3); n > 0; --n)
      text = random_.chance(0.7) ? with_token(text) : with_lines(text);
    return text;
  }

 private:
  Span any(const std::vector<Span>& spans) {
    return spans[static_cast<std::size_t>(random_.whole(0, static_cast<std::int64_t>(spans.size()) - 1))];
  }

  std::string changed(const std::string& token) {
    static const char* const kAwkward[] = {"0",
                                           "-1",
                                           "1",
                                           "2",
                                           "0.5",
                                           "-0",
                                           "1e-300",
                                           "1e300",
                                           "1e17",
                                           "4096",
                                           "nan",
                                           "inf",
                                           "4294967296",
                                           "18446744073709551615",
                                           "9223372036854775807",
                                           "-9223372036854775808"};
    if (random_.chance(0.3)) return kAwkward[random_.whole(0, 15)];
    if (token.find_first_not_of("-0123456789") != std::string::npos || token.size() > 17) {
      std::string other = token;
      auto& c =
          other[static_cast<std::size_t>(random_.whole(0, static_cast<std::int64_t>(token.size()) - 1))];
      c = static_cast<char>('0' + random_.whole(0, 9));
      return other;
    }
    const std::int64_t by[] = {1, -1, 2, -2, 16, -16, 1000, -1000};
    return std::to_string(std::strtoll(token.c_str(), nullptr, 10) + by[random_.whole(0, 7)]);
  }

  std::string with_token(std::string text) {
    const auto tokens = split(text, " \n");
    if (tokens.empty()) return text;
    const Span at = any(tokens), other = any(tokens);
    const std::string token = text.substr(at.begin, at.length);
    const std::string better = random_.chance(0.25) ? text.substr(other.begin, other.length) : changed(token);
    return text.replace(at.begin, at.length, better);
  }

  std::string with_lines(std::string text) {
    const auto lines = split(text, "\n");
    if (lines.empty()) return text;
    const Span at = any(lines), other = any(lines);
    const std::string line = text.substr(at.begin, at.length + 1),
                      copy = text.substr(other.begin, other.length + 1);
    switch (random_.whole(0, 2)) {
      case 0:
        return text.erase(at.begin, at.length + 1);
      case 1:
        return text.insert(at.begin, copy);
      default:
        return text.replace(at.begin, line.size(), copy);
    }
  }

  shapes::Random random_;
};

}  // namespace limpet::fuzz
