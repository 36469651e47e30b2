// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limpet/survey/random.hpp>
#include <string>
#include <vector>

#include "../fuzz/tokens.hpp"

namespace limpet::app::testing {

/// Damages a file as accidents and malice do: bytes, numbers (of text, and the four or eight bytes of binary
/// ones) that become extreme, lines that are lost, doubled, exchanged or cut, ends that are lost.
class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  std::string operator()(std::string bytes) {
    for (auto left = 1 + random_.below(2); left > 0 && !bytes.empty(); --left) damage(bytes);
    return bytes;
  }

 private:
  using Span = fuzz::Span;

  void damage(std::string& bytes) {
    switch (random_.below(12)) {
      case 0:
        bytes[any(bytes)] = static_cast<char>(random_.below(256));
        break;
      case 1:
        bytes[any(bytes)] ^= static_cast<char>(1 << random_.below(8));
        break;
      case 2:
        bytes.erase(any(bytes), 1 + random_.below(16));
        break;
      case 3:
        bytes.resize(any(bytes));
        break;
      case 4:
      case 5:
        damage_lines(bytes);
        break;
      case 6:
        damage_binary_number(bytes);
        break;
      default:
        damage_number(bytes);
    }
  }

  std::size_t any(const std::string& bytes) { return random_.below(bytes.size()); }

  void damage_lines(std::string& bytes) {
    const std::vector<Span> lines = fuzz::split(bytes, "\n");
    if (lines.empty()) return;
    const Span at = lines[random_.below(lines.size())], other = lines[random_.below(lines.size())];
    const std::string line = bytes.substr(at.begin, at.length + 1),
                      copy = bytes.substr(other.begin, other.length + 1);
    switch (random_.below(4)) {
      case 0:
        bytes.erase(at.begin, line.size());
        break;
      case 1:
        bytes.insert(at.begin, line);
        break;
      case 2:
        bytes.erase(at.begin + random_.below(at.length), at.length);
        break;
      default:  // the later first, so that the earlier stays where it is
        bytes.replace(std::max(at.begin, other.begin), (at.begin > other.begin ? line : copy).size(),
                      at.begin > other.begin ? copy : line);
        bytes.replace(std::min(at.begin, other.begin), (at.begin > other.begin ? copy : line).size(),
                      at.begin > other.begin ? line : copy);
    }
  }

  void damage_number(std::string& bytes) {
    const std::vector<Span> words = fuzz::split(bytes, " \n\t/");
    std::vector<Span> numbers;
    for (const Span& word : words)
      if (std::strchr("-.0123456789", bytes[word.begin])) numbers.push_back(word);
    if (numbers.empty()) return;
    // Counts and limits stand at the front: a quarter of the damage is done there.
    const std::size_t reach =
        random_.below(4) == 0 ? std::min<std::size_t>(numbers.size(), 40) : numbers.size();
    const Span at = numbers[random_.below(reach)], other = numbers[random_.below(numbers.size())];
    bytes.replace(at.begin, at.length,
                  random_.below(5) == 0 ? bytes.substr(other.begin, other.length)
                                        : extreme(bytes.substr(at.begin, at.length)));
  }

  std::string extreme(const std::string& number) {
    static const char* const extremes[] = {"0",
                                           "-0",
                                           "1",
                                           "-1",
                                           "2",
                                           "0.5",
                                           "1e20",
                                           "-1e20",
                                           "1e30",
                                           "1e60",
                                           "-1e75",
                                           "1e100",
                                           "1e154",
                                           "1e200",
                                           "1e308",
                                           "-1e308",
                                           "1e-20",
                                           "1e-100",
                                           "1e-308",
                                           "5e-324",
                                           "nan",
                                           "inf",
                                           "-inf",
                                           "1e400",
                                           "4096",
                                           "1e9",
                                           "1e12",
                                           "1e15",
                                           "1e18",
                                           "65536",
                                           "2147483647",
                                           "-2147483648",
                                           "4294967295",
                                           "4294967296",
                                           "281474976710656",
                                           "281474976710657",
                                           "562949953421312",
                                           "1099511627777",
                                           "9007199254740993",
                                           "4611686018427387904",
                                           "9223372036854775807",
                                           "-9223372036854775808",
                                           "9223372036854775808",
                                           "18446744073709551615",
                                           "170141183460469231731687303715884105727",
                                           "-170141183460469231731687303715884105728"};
    switch (random_.below(8)) {
      case 0:
        return number.starts_with('-') ? number.substr(1) : "-" + number;
      case 1:
        return number + std::to_string(random_.below(100));
      case 2:
        return number + "e" + std::to_string(random_.below(40));
      case 3:
        return std::to_string(std::strtoll(number.c_str(), nullptr, 10) +
                              2 * static_cast<int>(random_.below(2)) - 1);
      default:
        return extremes[random_.below(std::size(extremes))];
    }
  }

  void damage_binary_number(std::string& bytes) {
    static const double extremes[] = {0, -0.0, 1e20, -1e30, 3e38, 1e308, 5e-324, 1e-40, 0.0 / 0.0, 1 / 0.0};
    const double value = extremes[random_.below(std::size(extremes))];
    const auto single = static_cast<float>(value);
    const std::uint32_t count =
        random_.below(2) == 0 ? 0xffffffffu : static_cast<std::uint32_t>(random_.next());
    char raw[8];
    std::size_t size = 4;
    switch (random_.below(3)) {
      case 0:
        std::memcpy(raw, &value, size = 8);
        break;
      case 1:
        std::memcpy(raw, &single, size);
        break;
      default:
        std::memcpy(raw, &count, size);
    }
    if (bytes.size() < size) return;
    bytes.replace(random_.below(bytes.size() - size + 1), size, raw, size);
  }

  survey::Random random_;
};

}  // namespace limpet::app::testing
