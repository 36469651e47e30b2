// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "file_case.hpp"
#include "perimeter_case.hpp"
#include "perimeter_script.hpp"
#include "stream_case.hpp"

/// Cases of all kinds, from text or from a fuzzer's bytes.
namespace limpet::cases {

/// Hands the case to f, as its own type. Throws CaseError.
template <class F>
auto with_case(std::string_view text, F&& f) {
  CaseLines lines(text);
  if (!lines.next() || lines.size() < 3 || !lines.is("limpet") || lines.word(1) != "case")
    lines.fail("no case");
  const std::string kind = lines.word(2);
  if (kind == PerimeterCase::kKind) return f(perimeter_case(text));
  if (kind == StreamCase::kKind) return f(stream_case(text));
  if (kind == FileCase::kKind) return f(file_case(text));
  lines.fail("there are no cases of kind '" + kind + "'");
}

/// The formats that a fuzzer of files chooses from by the first byte.
inline constexpr std::array kScanFormats = {"ply", "pcd", "xyz", "pwn"};
inline constexpr std::array kMeshFormats = {"off", "stl", "obj", "mesh-ply"};

template <std::size_t N>
FileCase file_of(std::span<const std::uint8_t> bytes, const std::array<const char*, N>& formats) {
  FileCase c;
  c.format = formats[bytes.empty() ? 0 : bytes[0] % N];
  if (bytes.size() > 1) c.bytes.assign(bytes.begin() + 1, bytes.end());
  return c;
}

/// Makes up steps by the bytes, and runs them, until the bytes end; `told` hears of the case before each
/// step.
template <class Told>
std::optional<BrokenLaw> broken_law_of_script(std::span<const std::uint8_t> bytes, PerimeterCase& c,
                                              Told&& told) {
  PerimeterScript script(shapes::Random(bytes), Regime::any);
  c = script.begin();
  PerimeterTrial trial(c.start, c.gap);
  shapes::Random places(std::uint64_t{1});
  while (script.random().left() > 0 && c.steps.size() < 40 && trial.polygon().edge_count() < 400) {
    c.steps.push_back(script.next(trial.polygon()));
    told(c);
    if (!trial.prepare(c.steps.back())) {
      c.steps.pop_back();
      continue;
    }
    trial.apply();
    if (const auto law = trial.judge(places, true))
      return BrokenLaw{kPerimeterLaws[static_cast<std::size_t>(*law)],
                       "step " + std::to_string(c.steps.size())};
  }
  return std::nullopt;
}

/// What a fuzzer's input stands for: a case as text where it begins like one, else choices (perimeter,
/// stream) or the file itself (scan and mesh, with their format in the first byte; native, labels). Nothing:
/// a text that is no case. `told` hears of the case before anything that may crash. Throws CaseError when
/// there is no such kind.
std::optional<BrokenLaw> broken_law_of_bytes(const std::string& kind, std::span<const std::uint8_t> bytes,
                                             const std::function<void(const std::string& text)>& told);

}  // namespace limpet::cases
