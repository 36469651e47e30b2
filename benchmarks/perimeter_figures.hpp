// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <limpet/geometry/predicates.hpp>

#include "../tests/cases/perimeter_case.hpp"
#include "child.hpp"

/// What limpet_perimeter_operations counts.
namespace limpet::benchmarks {

inline constexpr std::size_t kKinds = cases::kOperations.size(), kLaws = cases::kPerimeterLaws.size();
inline constexpr std::array kOutcomeNames = {"changed", "nothing_to_do", "refused"};

/// Shared between parent and child: plain numbers.
struct Figures {
  std::uint64_t operations = 0, audited = 0;
  std::array<std::array<std::uint64_t, kOutcomeNames.size()>, kKinds> outcome{};
  std::array<std::array<std::uint64_t, kLaws>, kKinds> broken{};
  std::array<std::uint64_t, kKinds> longest_ns{}, total_ns{}, slow{};
  std::array<std::uint64_t, 8> unite_attempt{};  ///< [k]: unions that succeeded at attempt k
  std::array<std::uint64_t, 5> merger{};
  std::array<std::uint64_t, 65> signals{};  ///< crashes by signal; [0]: those that were an exit
  std::uint64_t crashes = 0, hangs = 0, edges_max = 0, holes_max = 0;
  std::size_t running = kKinds;

  std::uint64_t faults() const {
    std::uint64_t n = crashes + hangs;
    for (const auto& of_kind : broken)
      for (const std::uint64_t count : of_kind) n += count;
    return n;
  }
};

inline std::string json_of(const Figures& f, std::uint64_t seed, double seconds) {
  const auto number = [](auto n) { return std::to_string(n); };
  std::string s = "{\n  \"arithmetic\": \"" + std::string(geometry::arithmetic()) +
                  "\",\n  \"seed\": " + number(seed) + ",\n  \"operations\": " + number(f.operations) +
                  ",\n  \"audited\": " + number(f.audited) + ",\n  \"crashes\": " + number(f.crashes) +
                  ",\n  \"hangs\": " + number(f.hangs) + ",\n  \"most_edges\": " + number(f.edges_max) +
                  ",\n  \"most_holes\": " + number(f.holes_max) + ",\n  \"seconds\": " + number(seconds) +
                  ",\n  \"kinds\": {";
  for (std::size_t k = 0; k < kKinds; ++k) {
    s += std::string(k ? "," : "") + "\n    \"" + cases::kOperations[k] + "\": {";
    std::uint64_t n = 0;
    for (std::size_t o = 0; o < kOutcomeNames.size(); ++o) {
      s += std::string("\"") + kOutcomeNames[o] + "\": " + number(f.outcome[k][o]) + ", ";
      n += f.outcome[k][o];
    }
    for (std::size_t law = 0; law < kLaws; ++law)
      s += std::string("\"broken_") + cases::kPerimeterLaws[law] + "\": " + number(f.broken[k][law]) + ", ";
    s += "\"slow\": " + number(f.slow[k]) + ", ";
    s += "\"longest_ms\": " + number(static_cast<double>(f.longest_ns[k]) * 1e-6) + ", \"mean_us\": " +
         number(static_cast<double>(f.total_ns[k]) * 1e-3 / static_cast<double>(n ? n : 1)) + "}";
  }
  s += "\n  },\n  \"signals\": {";
  bool first = true;
  for (std::size_t k = 0; k < f.signals.size(); ++k) {
    if (f.signals[k] == 0) continue;
    s += (first ? "\"" : ", \"") + (k == 0 ? "exit" : signal_name(static_cast<int>(k))) +
         "\": " + number(f.signals[k]);
    first = false;
  }
  s += "},\n  \"mergers\": {";
  constexpr std::array names = {"contained", "united", "bridged", "too_far", "refused"};
  for (std::size_t k = 0; k < names.size(); ++k)
    s += std::string(k ? ", \"" : "\"") + names[k] + "\": " + number(f.merger[k]);
  s += "},\n  \"unite_succeeded_at_attempt\": [";
  for (std::size_t k = 1; k < f.unite_attempt.size(); ++k)
    s += (k > 1 ? ", " : "") + number(f.unite_attempt[k]);
  return s + "]\n}\n";
}

}  // namespace limpet::benchmarks
