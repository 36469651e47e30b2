// Copyright the limpet authors. GPL-3.0-or-later.
#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limpet/io/error.hpp>
#include <limpet/io/output_file.hpp>
#include <utility>
#include <vector>

namespace limpet::io {
namespace {

constexpr std::size_t kWriteBytes = 1 << 20;
constexpr int kAttempts = 100;

std::string name_of(int file) { return "/proc/self/fd/" + std::to_string(file); }

/// As good as never the name of a file; nothing is ever written over one that has it. Short, for the folder
/// may hold names of the greatest length.
std::string random_name() {
  std::uint64_t numbers[2] = {static_cast<std::uint64_t>(::getpid()), 0};
  const ssize_t drawn = ::getrandom(numbers, sizeof numbers, 0);
  static std::uint64_t counter = 0;
  if (drawn < static_cast<ssize_t>(sizeof numbers)) numbers[1] = ++counter;
  char text[64];
  std::snprintf(text, sizeof text, ".limpet-%016llx%016llx.part", static_cast<unsigned long long>(numbers[0]),
                static_cast<unsigned long long>(numbers[1]));
  return text;
}

bool same_file(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

/// Access control lists, where the file system has them.
void copy_access_list(int from, int to) {
  constexpr const char* kName = "system.posix_acl_access";
  const ssize_t size = ::fgetxattr(from, kName, nullptr, 0);
  if (size <= 0) return;
  std::vector<char> list(static_cast<std::size_t>(size));
  if (::fgetxattr(from, kName, list.data(), list.size()) == size)
    (void)::fsetxattr(to, kName, list.data(), list.size(), 0);
}

/// So that the name is on the disk, too. Some file systems cannot, and some folders may not be read.
void sync(int folder) {
  const int readable = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (readable < 0) return;
  ::fsync(readable);
  ::close(readable);
}

void close_file(int& file) {
  if (file >= 0) ::close(file);
  file = -1;
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  try {
    find_target();
    if (!device_) {
      open_unnamed();
      if (file_ < 0) open_aside();
      if (file_ < 0) fail("cannot be written");
      take_over_permissions();
    }
    buffer_.reserve(kWriteBytes);
  } catch (...) {
    abandon();
    throw;
  }
}

/// The system opens the old file, and so says whether it may be written and whether a link may be followed.
void OutputFile::find_target() {
  struct stat found;
  const bool exists = ::stat(path_.c_str(), &found) == 0;
  if (!exists && errno != ENOENT) fail("cannot be written");
  if (exists && S_ISDIR(found.st_mode))
    throw OutputError(path_ + ": is a folder; give the name of a file in it");
  if (exists && !S_ISREG(found.st_mode)) {  // a device or a pipe must be written to, never replaced
    device_ = true;
    file_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) fail("cannot be written");
    return;
  }
  const bool is_link = ::lstat(path_.c_str(), &found) == 0 && S_ISLNK(found.st_mode);
  made_old_ = is_link && !exists;
  if (exists || is_link) {
    old_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | (made_old_ ? O_CREAT : 0), 0666);
    if (old_ < 0) fail("cannot be written");
  }
  open_folder();
}

void OutputFile::open_folder() {
  std::string target = path_;
  struct stat link, there, opened;
  if (old_ >= 0 && ::lstat(path_.c_str(), &link) == 0 && S_ISLNK(link.st_mode)) {
    char* resolved = ::realpath(path_.c_str(), nullptr);
    if (resolved == nullptr) fail("cannot be written");
    target = resolved;
    std::free(resolved);
  }
  const auto slash = target.find_last_of('/');
  const std::string folder = slash == target.npos ? "." : target.substr(0, slash + 1);
  name_ = slash == target.npos ? target : target.substr(slash + 1);
  folder_ = ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  if (folder_ < 0) fail("cannot be written");
  if (old_ < 0) return;
  if (::fstatat(folder_, name_.c_str(), &there, AT_SYMLINK_NOFOLLOW) != 0 || ::fstat(old_, &opened) != 0)
    fail("cannot be written");
  if (!same_file(there, opened)) throw OutputError(path_ + ": is another file than a moment ago");
}

/// Opens a file without a name (O_TMPFILE); leaves file_ at -1 where the file system has none.
void OutputFile::open_unnamed() {
  file_ = ::openat(folder_, ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (file_ < 0 || ::access(name_of(file_).c_str(), F_OK) == 0) return;
  close_file(file_);  // without /proc it cannot be given a name
}

void OutputFile::open_aside() {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    aside_ = random_name();
    file_ = ::openat(folder_, aside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file_ >= 0) return;
    if (errno != EEXIST) break;
  }
  aside_.clear();
}

/// Of the old file, before any byte is in the new one. Where its group cannot be kept, another group gets no
/// more than everybody.
void OutputFile::take_over_permissions() {
  struct stat old, mine;
  if (old_ < 0 || made_old_ || ::fstat(old_, &old) != 0 || ::fstat(file_, &mine) != 0) return;
  const bool owner = old.st_uid == mine.st_uid || ::fchown(file_, old.st_uid, static_cast<gid_t>(-1)) == 0;
  const bool group = old.st_gid == mine.st_gid || ::fchown(file_, static_cast<uid_t>(-1), old.st_gid) == 0;
  mode_t mode = old.st_mode & 07777;
  if (!owner) mode &= ~static_cast<mode_t>(S_ISUID);
  if (!group) mode &= ~static_cast<mode_t>(S_ISGID | 070) | (mode & 07) << 3;
  if (::fchmod(file_, mode) != 0) fail("cannot be given the permissions of the old file");
  if (group) copy_access_list(old_, file_);
}

void OutputFile::no_more_readable_than(const std::string& path) {
  struct stat theirs, mine;
  if (device_ || ::fstat(file_, &mine) != 0) return;
  if (::stat(path.c_str(), &theirs) != 0 || !S_ISREG(theirs.st_mode)) theirs.st_mode = 0;
  mode_t may = theirs.st_mode & 044;
  const bool group = theirs.st_mode == 0 || theirs.st_gid == mine.st_gid ||
                     ::fchown(file_, static_cast<uid_t>(-1), theirs.st_gid) == 0;
  if (!group) may &= 04 | (may & 04) << 3;
  if (::fchmod(file_, mine.st_mode & 07777 & ~(044 & ~may)) != 0) fail("cannot be made private");
}

bool OutputFile::link_to(const std::string& name) {
  if (::linkat(AT_FDCWD, name_of(file_).c_str(), folder_, name.c_str(), AT_SYMLINK_FOLLOW) == 0) return true;
  if (errno != EEXIST) fail("cannot be written");
  return false;
}

/// The final name if it is free; else, for a link takes no other's place, one aside, which is renamed.
void OutputFile::give_name() {
  if (old_ < 0 && link_to(name_)) return;
  for (int attempt = 0; aside_.empty() && attempt < kAttempts; ++attempt)
    if (const std::string aside = random_name(); link_to(aside)) aside_ = aside;
  if (aside_.empty() || ::renameat(folder_, aside_.c_str(), folder_, name_.c_str()) != 0)
    fail("cannot be written");
  aside_.clear();
}

OutputFile::~OutputFile() { abandon(); }

void OutputFile::abandon() {
  if (!aside_.empty()) ::unlinkat(folder_, aside_.c_str(), 0);
  struct stat made, there;
  if (made_old_ && old_ >= 0 && ::fstat(old_, &made) == 0 && made.st_size == 0 && folder_ >= 0 &&
      ::fstatat(folder_, name_.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0 && same_file(made, there))
    ::unlinkat(folder_, name_.c_str(), 0);
  close_file(file_);
  close_file(old_);
  close_file(folder_);
}

void OutputFile::fail(const char* doing) const {
  throw OutputError(path_ + ": " + doing + ": " + std::strerror(errno));
}

void OutputFile::put(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot be written");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::flush() {
  put(buffer_);
  buffer_.clear();
}

void OutputFile::write(std::string_view bytes) {
  if (buffer_.size() + bytes.size() > kWriteBytes) flush();
  if (bytes.size() > kWriteBytes) {
    put(bytes);
  } else {
    buffer_ += bytes;
  }
}

void OutputFile::overwrite(std::int64_t offset, std::string_view bytes) {
  flush();
  if (::lseek(file_, offset, SEEK_SET) < 0) fail("cannot be rewritten");
  put(bytes);
  if (::lseek(file_, 0, SEEK_END) < 0) fail("cannot be rewritten");
}

void OutputFile::close() {
  flush();
  while (!device_ && ::fsync(file_) != 0)
    if (errno != EINTR) fail("cannot be written");
  if (!device_) {
    give_name();
    sync(folder_);
  }
  if (::close(std::exchange(file_, -1)) != 0) fail("cannot be written");
}

}  // namespace limpet::io
