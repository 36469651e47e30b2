// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/kinematics/mesh_path.hpp>

#include <filesystem>
#include <iterator>
#include <system_error>

namespace limpet::kinematics {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> if_there(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error) || fs::is_directory(path, error)) return std::nullopt;
  return path.lexically_normal().string();
}

fs::path without_first_part(const fs::path& path) {
  fs::path rest;
  for (auto part = std::next(path.begin()); part != path.end(); ++part) rest /= *part;
  return rest;
}

/// In a folder, with fewer and fewer of the path's first parts.
std::optional<std::string> find_below(const fs::path& folder, const fs::path& path) {
  for (fs::path rest = path; !rest.empty(); rest = without_first_part(rest))
    if (auto found = if_there(folder / rest)) return found;
  return std::nullopt;
}

}  // namespace

std::optional<std::string> find_robot_file(const std::string& name, const std::string& beside,
                                           const std::vector<std::string>& folders) {
  const auto scheme = name.find("://");
  const bool is_package = scheme != name.npos && name.substr(0, scheme) != "file";
  fs::path path = scheme == name.npos ? name : name.substr(scheme + 3);
  if (path.is_absolute() && !is_package) {
    if (auto found = if_there(path)) return found;
  }
  path = path.relative_path();
  if (path.empty()) return std::nullopt;
  if (auto found = if_there(fs::path(beside) / path)) return found;
  for (const std::string& folder : folders)
    if (auto found = find_below(folder, path)) return found;
  if (!is_package) return std::nullopt;
  std::error_code error;
  fs::path above = fs::absolute(beside.empty() ? "." : beside, error).lexically_normal();
  for (; !error && above.has_relative_path(); above = above.parent_path())
    if (auto found = if_there(above / path)) return found;
  return std::nullopt;
}

}  // namespace limpet::kinematics
