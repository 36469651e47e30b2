// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/temporary_file.hpp>

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limpet/io/error.hpp>
#include <string>

namespace limpet::survey {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw io::OutputError("a temporary file for the scan cannot be " + what + ": " + std::strerror(errno) +
                        "; set TMPDIR to a folder with space");
}

}  // namespace

TemporaryFile::TemporaryFile() {
  std::error_code error;
  std::string name = (std::filesystem::temp_directory_path(error) / "limpet-XXXXXX").string();
  errno = error.value();
  file_ = error ? -1 : ::mkstemp(name.data());
  if (file_ < 0) fail("made");
  ::unlink(name.c_str());
}

TemporaryFile::~TemporaryFile() { ::close(file_); }

void TemporaryFile::append(const void* bytes, std::size_t size) {
  for (auto from = static_cast<const char*>(bytes); size > 0;) {
    const ssize_t written = ::pwrite(file_, from, size, size_);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail("written");
    from += written;
    size_ += written;
    size -= static_cast<std::size_t>(written);
  }
}

void TemporaryFile::read(std::int64_t from, void* bytes, std::size_t size) const {
  for (auto to = static_cast<char*>(bytes); size > 0;) {
    const ssize_t got = ::pread(file_, to, size, from);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail("read");
    to += got;
    from += got;
    size -= static_cast<std::size_t>(got);
  }
}

}  // namespace limpet::survey
