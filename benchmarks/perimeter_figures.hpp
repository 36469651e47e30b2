// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <limpet/geometry/predicates.hpp>

/// What limpet_perimeter_operations counts.
namespace limpet::benchmarks {

enum Kind { kExtend, kMerge, kUnite, kFill, kKinds };
constexpr std::array<const char*, kKinds> kKindNames = {"extend_to_point", "merge_polygons", "unite",
                                                        "fill_fissures"};
enum Outcome { kChanged, kNothing, kRefused, kOutcomes };
constexpr std::array<const char*, kOutcomes> kOutcomeNames = {"changed", "nothing_to_do", "refused"};
/// What can be wrong with a result.
enum Fault { kBroken, kAudit, kIdentity, kTouched, kShrunk, kLocate, kException, kFaults };
constexpr std::array<const char*, kFaults> kFaultNames = {
    "broken_results", "broken_by_audit", "identity_faults", "refused_but_changed",
    "area_lost",      "wrong_sides",     "exceptions"};

/// Shared between parent and child: plain numbers.
struct Figures {
  std::uint64_t operations = 0, audited = 0;
  std::array<std::array<std::uint64_t, kOutcomes>, kKinds> outcome{};
  std::array<std::array<std::uint64_t, kFaults>, kKinds> fault{};
  std::array<std::uint64_t, kKinds> longest_ns{}, total_ns{};
  std::array<std::uint64_t, 8> unite_attempt{};  ///< [k]: unions that succeeded at attempt k
  std::array<std::uint64_t, 5> merger{};
  std::uint64_t crashes = 0, hangs = 0, edges_max = 0, holes_max = 0;
  Kind running = kKinds;
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
    s += std::string(k ? "," : "") + "\n    \"" + kKindNames[k] + "\": {";
    std::uint64_t n = 0;
    for (std::size_t o = 0; o < kOutcomes; ++o) {
      s += std::string("\"") + kOutcomeNames[o] + "\": " + number(f.outcome[k][o]) + ", ";
      n += f.outcome[k][o];
    }
    for (std::size_t o = 0; o < kFaults; ++o)
      s += std::string("\"") + kFaultNames[o] + "\": " + number(f.fault[k][o]) + ", ";
    s += "\"longest_ms\": " + number(static_cast<double>(f.longest_ns[k]) * 1e-6) + ", \"mean_us\": " +
         number(static_cast<double>(f.total_ns[k]) * 1e-3 / static_cast<double>(n ? n : 1)) + "}";
  }
  s += "\n  },\n  \"mergers\": {";
  constexpr std::array names = {"contained", "united", "bridged", "too_far", "refused"};
  for (std::size_t k = 0; k < names.size(); ++k)
    s += std::string(k ? ", \"" : "\"") + names[k] + "\": " + number(f.merger[k]);
  s += "},\n  \"unite_succeeded_at_attempt\": [";
  for (std::size_t k = 1; k < f.unite_attempt.size(); ++k)
    s += (k > 1 ? ", " : "") + number(f.unite_attempt[k]);
  return s + "]\n}\n";
}

}  // namespace limpet::benchmarks
