// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace limpet::benchmarks {

/// How instructions are counted here: "perf" (the processor's own counter), "callgrind" where it has none
/// that may be used, as in most virtual machines, or "" where there is neither.
const std::string& instruction_counter();

/// Instructions of a program from its start to its end; nothing where they cannot be counted or it fails.
std::optional<double> count_instructions(const std::vector<std::string>& command, const std::string& scratch);

/// Those within calls of a function (callgrind's pattern) only; by callgrind always.
std::optional<double> count_instructions_within(const std::string& function,
                                                const std::vector<std::string>& command,
                                                const std::string& scratch);

}  // namespace limpet::benchmarks
