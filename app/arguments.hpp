// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limpet/survey/noise_law.hpp>
#include <limpet/survey/resolution_law.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace limpet::app {

/// What was asked for makes no sense. what() is one line that says what to do instead.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// "x,y,z" as given to `option`. Throws UsageError.
Eigen::Vector3d parse_vector(const std::string& option, const std::string& text);

/// A length that must be positive (or, with `zero`, not negative) and finite. Throws UsageError.
double parse_length(const std::string& option, const std::string& text, bool zero);

/// ψ and φ (thesis §2.9).
struct RedundancyArgument {
  double count = 20, ratio = 0.05;
};
/// "N,F", both 0 or more. Throws UsageError.
RedundancyArgument parse_redundancy(const std::string& option, const std::string& text);

/// What the links of a robot are covered with, beside the sensors at its control point (thesis §3.3).
enum class LinkSensors { range, switches };
/// "range" or "switches". Throws UsageError.
LinkSensors parse_link_sensors(const std::string& option, const std::string& text);

/// "a", "a,b" or "a,b,c", all 0 or more. Throws UsageError.
survey::ResolutionLaw parse_resolution(const std::string& option, const std::string& text);
survey::NoiseLaw parse_noise(const std::string& option, const std::string& text);

/// "0", "-1,0" or "0..9,255": whole numbers and ranges of them, both ends in. Throws UsageError.
std::vector<std::pair<std::int64_t, std::int64_t>> parse_ranges(const std::string& option,
                                                                const std::string& text);

/// Refuses, before any work is done, an output whose folder does not exist or cannot be written to, or that
/// exists and may not be written.
/// Throws io::OutputError.
void require_writable(const std::string& path);

/// Refuses the name of a model whose ending is none that a model is written as. Throws UsageError.
void require_model_name(const std::string& path);

/// Refuses the name of a folder where a file is read. Throws io::InputError.
void refuse_folder(const std::string& path);

/// Writes a small text file, "-" being standard output. Throws io::OutputError.
void save_text(const std::string& path, const std::string& text);

}  // namespace limpet::app
