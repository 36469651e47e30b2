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
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)), target_(path_) {
  struct stat found;
  const bool exists = ::stat(path_.c_str(), &found) == 0;
  if (exists && S_ISDIR(found.st_mode)) {
    throw OutputError(path_ + ": is a folder; give the name of a file in it");
  }
  if (exists && !S_ISREG(found.st_mode)) {  // a device or a pipe must be written to, never replaced
    file_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    if (exists) target_ = std::filesystem::canonical(path_).string();  // a link stays a link
    open_aside();
  }
  if (file_ < 0) fail("cannot be written");
  buffer_.reserve(kBufferBytes);
}

void OutputFile::open_aside() {
  // The process number keeps two programs that write the same file from writing the same bytes aside.
  for (int attempt = 0; attempt < 100; ++attempt) {
    aside_ = target_ + ".part" + std::to_string(::getpid()) + "-" + std::to_string(attempt);
    file_ = ::open(aside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file_ >= 0 || errno != EEXIST) return;
  }
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
  const int file = file_;
  file_ = -1;
  const bool closed = ::close(file) == 0;
  if (closed && (aside_.empty() || ::rename(aside_.c_str(), target_.c_str()) == 0)) return;
  const int reason = errno;
  if (!aside_.empty()) ::unlink(aside_.c_str());
  errno = reason;
  fail("cannot be written");
}

}  // namespace limpet::io
