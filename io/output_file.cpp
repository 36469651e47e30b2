// Copyright the limpet authors. GPL-3.0-or-later.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limpet/io/error.hpp>
#include <limpet/io/output_file.hpp>

namespace limpet::io {
namespace {

constexpr std::size_t kBufferBytes = 1 << 20;
constexpr int kAttempts = 100;

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// The file that a symbolic link names, whether it exists or not: the output takes its place, and the link
/// stays.
std::string followed(const std::string& path) {
  std::filesystem::path target = path;
  std::error_code none;
  for (int links = 0; links < 40 && std::filesystem::is_symlink(target, none); ++links) {
    const std::filesystem::path next = std::filesystem::read_symlink(target, none);
    if (none) break;
    target = target.parent_path() / next;  // which is `next` where that is absolute
  }
  return target.string();
}

std::string name_of(int file) { return "/proc/self/fd/" + std::to_string(file); }

/// The process number keeps two programs that write the same file from writing the same bytes aside.
std::string aside_name(const std::string& target, int attempt) {
  return target + ".part" + std::to_string(::getpid()) + "-" + std::to_string(attempt);
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)), target_(path_) {
  struct stat found;
  const bool exists = ::stat(path_.c_str(), &found) == 0;
  if (exists && S_ISDIR(found.st_mode)) {
    throw OutputError(path_ + ": is a folder; give the name of a file in it");
  }
  if (exists && !S_ISREG(found.st_mode)) {  // a device or a pipe must be written to, never replaced
    device_ = true;
    file_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    target_ = followed(path_);
    open_unnamed();
    if (file_ < 0) open_aside();
  }
  if (file_ < 0) fail("cannot be written");
  buffer_.reserve(kBufferBytes);
}

/// Opens a file without a name (O_TMPFILE); leaves file_ at -1 where the file system has none.
void OutputFile::open_unnamed() {
  file_ = ::open(folder_of(target_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (file_ < 0 || ::access(name_of(file_).c_str(), F_OK) == 0) return;
  ::close(file_);  // without /proc it cannot be given a name
  file_ = -1;
}

void OutputFile::open_aside() {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    aside_ = aside_name(target_, attempt);
    file_ = ::open(aside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file_ >= 0 || errno != EEXIST) return;
  }
}

bool OutputFile::link_to(const std::string& name) {
  if (::linkat(AT_FDCWD, name_of(file_).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) return true;
  if (errno != EEXIST) fail("cannot be written");
  return false;
}

/// The final name if it is free; else, for a link takes no other's place, one aside that is renamed. The name
/// aside is always the same: what a program that was killed in between has left there goes.
void OutputFile::give_name() {
  const std::string aside = target_ + ".part-of-limpet";
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (link_to(target_)) return;
    if (!link_to(aside)) {
      ::unlink(aside.c_str());
    } else if (::rename(aside.c_str(), target_.c_str()) == 0) {
      return;
    } else if (errno != ENOENT) {  // else another program has just taken the name for a leftover
      const int reason = errno;
      ::unlink(aside.c_str());
      errno = reason;
      break;
    }
  }
  fail("cannot be written");
}

/// So that the name is on the disk, too. Some file systems cannot, and some folders may not be read.
void OutputFile::sync_folder() const {
  const int folder = ::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  ::fsync(folder);
  ::close(folder);
}

OutputFile::~OutputFile() {
  if (file_ < 0) return;
  ::close(file_);
  if (!aside_.empty()) ::unlink(aside_.c_str());
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
  if (buffer_.size() + bytes.size() > kBufferBytes) flush();
  if (bytes.size() > kBufferBytes) {
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
  if (!device_ && aside_.empty()) give_name();
  const int file = file_;
  file_ = -1;
  const bool closed = ::close(file) == 0;
  if (closed && (aside_.empty() || ::rename(aside_.c_str(), target_.c_str()) == 0)) {
    if (!device_) sync_folder();
    return;
  }
  const int reason = errno;
  if (!aside_.empty()) ::unlink(aside_.c_str());
  errno = reason;
  fail("cannot be written");
}

}  // namespace limpet::io
