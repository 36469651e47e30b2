// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/arguments.hpp>

#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limpet/io/error.hpp>
#include <limpet/io/mesh_writer.hpp>
#include <limpet/io/output_file.hpp>
#include <limpet/io/text.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace limpet::app {
namespace {

std::optional<double> to_number(std::string_view text) {
  double value = 0;
  if (!io::parse_double(text, value) || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Numbers separated by commas; nothing when one of them is none.
std::vector<double> to_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (;;) {
    const auto comma = text.find(',');
    const auto number = to_number(text.substr(0, comma));
    if (!number) return {};
    numbers.push_back(*number);
    if (comma == std::string_view::npos) return numbers;
    text.remove_prefix(comma + 1);
  }
}

/// A file of another user in a folder such as /tmp (the sticky bit).
bool only_owners_replace_files_there(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const std::string folder = fs::canonical(path, error).parent_path().string();
  struct stat file, in;
  if (error || ::stat(path.c_str(), &file) != 0 || ::stat(folder.c_str(), &in) != 0) return false;
  const uid_t user = ::geteuid();
  return (in.st_mode & S_ISVTX) != 0 && user != 0 && user != file.st_uid && user != in.st_uid;
}

}  // namespace

Eigen::Vector3d parse_vector(const std::string& option, const std::string& text) {
  const auto numbers = to_numbers(text);
  if (numbers.size() != 3) {
    throw UsageError(option + " '" + text + "': give three numbers separated by commas, as in " + option +
                     " 0,0,1.5");
  }
  return {numbers[0], numbers[1], numbers[2]};
}

double parse_length(const std::string& option, const std::string& text, bool zero) {
  const auto number = to_number(text);
  if (!number) throw UsageError(option + " '" + text + "': is not a number");
  if (*number < 0 || (!zero && *number == 0)) {
    throw UsageError(option + " " + text + ": must be " + (zero ? "0 or more" : "more than 0"));
  }
  return *number;
}

survey::ResolutionLaw parse_resolution(const std::string& option, const std::string& text) {
  const auto numbers = to_numbers(text);
  if (numbers.empty() || numbers.size() > 2)
    throw UsageError(option + " '" + text + "': give a; or a,b for a + b times the range");
  if (!(numbers[0] > 0)) throw UsageError(option + " " + text + ": must be greater than 0");
  const double growth = numbers.size() > 1 ? numbers[1] : 0;
  if (growth < 0 || growth > model::kMostResolutionGrowth)
    throw UsageError(option + " " + text + ": may grow by 0 to 0.25 times the range");
  return {numbers[0], growth};
}

survey::NoiseLaw parse_noise(const std::string& option, const std::string& text) {
  auto numbers = to_numbers(text);
  if (numbers.empty() || numbers.size() > 3) {
    throw UsageError(option + " '" + text +
                     "': give a; or a,b for a + b times the range; or a,b,c for c times its square more");
  }
  numbers.resize(3);
  const survey::NoiseLaw noise{numbers[0], numbers[1], numbers[2]};
  if (noise.fixed < 0 || noise.per_range < 0 || noise.per_range2 < 0)
    throw UsageError(option + " " + text + ": must be 0 or more");
  return noise;
}

RedundancyArgument parse_redundancy(const std::string& option, const std::string& text) {
  const auto numbers = to_numbers(text);
  if (numbers.size() != 2 || numbers[0] < 0 || numbers[1] < 0)
    throw UsageError(option + " '" + text + "': give a count and a ratio, 0 or more, as in " + option +
                     " 20,0.05");
  return {numbers[0], numbers[1]};
}

LinkSensors parse_link_sensors(const std::string& option, const std::string& text) {
  if (text == "range") return LinkSensors::range;
  if (text == "switches") return LinkSensors::switches;
  throw UsageError(option + " '" + text + "': give range or switches");
}

std::vector<std::pair<std::int64_t, std::int64_t>> parse_ranges(const std::string& option,
                                                                const std::string& text) {
  std::vector<std::pair<std::int64_t, std::int64_t>> ranges;
  std::string_view rest = text;
  for (;;) {
    const auto comma = rest.find(',');
    const std::string_view part = rest.substr(0, comma);
    const auto dots = part.find("..");
    std::int64_t first = 0, last = 0;
    const bool good = io::parse_integer(part.substr(0, dots), first) &&
                      io::parse_integer(dots == part.npos ? part : part.substr(dots + 2), last);
    if (!good || last < first) {
      std::string complaint = option;
      complaint.append(" '").append(text).append("': give whole numbers or ranges, as in ");
      complaint.append(option).append(" 0..9,255");
      throw UsageError(complaint);
    }
    ranges.emplace_back(first, last);
    if (comma == rest.npos) return ranges;
    rest.remove_prefix(comma + 1);
  }
}

void require_writable(const std::string& path) {
  namespace fs = std::filesystem;
  if (path.empty()) throw io::OutputError("the name of an output file is empty");
  std::error_code error;
  const fs::path target(path);
  if (fs::is_directory(target, error)) throw io::OutputError(path + ": is a folder; give a file name");
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    throw io::OutputError(path + ": there is no folder " + folder.string());
  }
  const bool exists = fs::exists(target, error);
  if (exists && ::access(path.c_str(), W_OK) != 0) throw io::OutputError(path + ": may not be written");
  if (exists && !fs::is_regular_file(target, error)) return;
  if (::access(folder.c_str(), W_OK) != 0) {
    throw io::OutputError(path + ": the folder " + folder.string() + " cannot be written to");
  }
  if (exists && only_owners_replace_files_there(path))
    throw io::OutputError(path +
                          ": belongs to another user, in a folder where only its owner may replace it");
}

void require_model_name(const std::string& path) {
  const std::string extension = io::extension_of(path);
  if (extension != "limpet" && !io::is_mesh_extension(extension))
    throw UsageError("-o " + path + ": a model is written as .limpet, .off, .ply, .obj, .stl, .glb or .vtp");
}

void refuse_folder(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw io::InputError(path, "is a folder; give the name of a file in it");
  }
}

void save_text(const std::string& path, const std::string& text) {
  if (path == "-") {
    std::cout << text << std::flush;
    if (!std::cout) throw io::OutputError("standard output: cannot be written");
    return;
  }
  io::OutputFile file(path);
  file.write(text);
  file.close();
}

}  // namespace limpet::app
