// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/file_roles.hpp>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <limpet/app/arguments.hpp>
#include <limpet/io/mesh_writer.hpp>
#include <optional>
#include <tuple>

namespace limpet::app {
namespace {

namespace fs = std::filesystem;

/// What a file is, whatever it is called: itself, or where there is none yet, its name in a folder.
struct Identity {
  dev_t device;
  ino_t inode;
  std::string name;  ///< empty: the file itself
  bool operator==(const Identity& other) const {
    return std::tie(device, inode, name) == std::tie(other.device, other.inode, other.name);
  }
};

/// Where a link that leads to nothing would lead. The file is not touched by this name.
std::string end_of_links(const std::string& path) {
  fs::path target = path;
  std::error_code error;
  for (int links = 0; links < 40 && fs::is_symlink(target, error); ++links) {
    const fs::path next = fs::read_symlink(target, error);
    if (error) break;
    target = target.parent_path() / next;  // which is `next` where that is absolute
  }
  return target.string();
}

/// Nothing: a device, or no file at all.
std::optional<Identity> identity_of(const std::string& path, bool written) {
  struct stat found;
  const bool exists = path == "-" ? ::fstat(written ? STDOUT_FILENO : STDIN_FILENO, &found) == 0
                                  : ::stat(path.c_str(), &found) == 0;
  if (exists && (S_ISREG(found.st_mode) || S_ISFIFO(found.st_mode) || S_ISBLK(found.st_mode)))
    return Identity{found.st_dev, found.st_ino, {}};
  if (exists || path == "-") return std::nullopt;
  const fs::path target = end_of_links(path);
  const std::string folder = target.has_parent_path() ? target.parent_path().string() : ".";
  if (::stat(folder.c_str(), &found) != 0) return std::nullopt;
  return Identity{found.st_dev, found.st_ino, target.filename().string()};
}

std::string words_for(const std::string& role, const std::string& path, bool written) {
  if (path == "-") return role + (written ? " (standard output)" : " (standard input)");
  return role.empty() ? path : role + " " + path;
}

std::string another_name_for(const std::string& role) { return "give " + role + " another name"; }

}  // namespace

void FileRoles::reads(const std::string& role, const std::string& path) {
  if (!path.empty()) files_.push_back({role, path, false});
}

void FileRoles::writes(const std::string& role, const std::string& path) {
  if (!path.empty()) files_.push_back({role, path, true});
}

void FileRoles::writes_model(const std::string& role, const std::string& path) {
  require_model_name(path);
  writes(role, path);
  const std::string beside = io::side_file(path);
  if (beside.empty()) return;
  writes("the colours of " + path + ",", beside);
  side_files_.push_back(beside);
}

void FileRoles::require_outputs() const {
  for (const File& file : files_)
    if (file.written && file.path != "-") require_writable(file.path);
  for (const std::string& beside : side_files_)
    if (io::is_foreign_side_file(beside))
      throw UsageError(beside +
                       ": is there already, and not by limpet, and would be replaced; move it, or give "
                       "-o another name");
}

void FileRoles::require_apart() const {
  require_outputs();
  std::vector<File> files = files_;
  const auto to_standard_output = [](const File& file) { return file.written && file.path == "-"; };
  if (std::none_of(files.begin(), files.end(), to_standard_output))
    files.push_back({"what is said", "-", true});
  std::vector<std::optional<Identity>> identities;
  for (const File& file : files) identities.push_back(identity_of(file.path, file.written));
  for (std::size_t i = 0; i < files.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const File &a = files[j], &b = files[i];
      const bool same_stream = a.path == "-" && b.path == "-" && a.written == b.written;
      if (!same_stream && (!identities[i] || identities[i] != identities[j])) continue;
      const std::string both =
          words_for(a.role, a.path, a.written) + " and " + words_for(b.role, b.path, b.written);
      if (a.written || b.written) {
        const bool to_elsewhere = b.path == "-" && a.path != "-";
        throw UsageError(both + " are the same file; " +
                         (to_elsewhere ? "send standard output elsewhere"
                                       : another_name_for(b.written ? b.role : a.role)));
      }
      struct stat found;
      const bool once = same_stream || (::stat(a.path.c_str(), &found) == 0 && S_ISFIFO(found.st_mode));
      if (once) throw UsageError(both + " are the same, which can be read only once");
    }
}

}  // namespace limpet::app
