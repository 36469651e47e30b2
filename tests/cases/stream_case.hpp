// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <limpet/model/model.hpp>

#include "case.hpp"

namespace limpet::cases {

/// A stream of sensor points and what the model is built to. After every set: the oracle finds nothing (law
/// audit), no reading is lost (readings), the changes tell all that happened (changes), nothing is thrown
/// (exception). Half way, and at the end, the native file reads back to the same bytes (native); half way,
/// too, the model is made anew from its state, which is as it was (state), and goes on.
struct StreamCase {
  static constexpr const char* kKind = "stream";
  model::Parameters parameters;
  std::vector<std::vector<model::SensorPoint>> sets;
  std::string law;  ///< that it once broke
};

/// What a run of a stream counts.
struct StreamFigures {
  std::uint64_t sets = 0;        ///< judged, finishing among them
  std::uint64_t longest_ns = 0;  ///< of processor time, that one of them took
};

/// Runs the stream and finishes the model; the first broken law. Adds to `figures`, if given.
std::optional<BrokenLaw> broken_law(const StreamCase&, StreamFigures* figures = nullptr);

/// A stream as bytes choose it (see shapes::Random): the degenerate pieces of tests/model/random_streams.hpp,
/// or, every other time, readings on a small lattice.
StreamCase stream_of(std::span<const std::uint8_t> bytes);

std::string to_text(const StreamCase&);
/// Throws CaseError.
StreamCase stream_case(std::string_view text);
std::vector<StreamCase> reductions(const StreamCase&);

}  // namespace limpet::cases
