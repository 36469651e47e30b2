// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/point_spool.hpp>

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limpet/io/error.hpp>
#include <string>

namespace limpet::survey {
namespace {

[[noreturn]] void fail() {
  throw io::OutputError(std::string("a temporary file for standard input cannot be written: ") +
                        std::strerror(errno) + "; set TMPDIR to a folder with space, or give a file");
}

}  // namespace

PointSpool::PointSpool() {
  std::error_code error;
  std::string name = (std::filesystem::temp_directory_path(error) / "limpet-XXXXXX").string();
  const int file = error ? -1 : ::mkstemp(name.data());
  if (file < 0) fail();
  ::unlink(name.c_str());
  file_ = ::fdopen(file, "w+b");
  if (file_ == nullptr) {
    ::close(file);
    fail();
  }
}

PointSpool::~PointSpool() { std::fclose(file_); }

void PointSpool::write(const Entry& entry) {
  const double numbers[3] = {entry.position.x(), entry.position.y(), entry.position.z()};
  const bool done = std::fwrite(numbers, sizeof numbers, 1, file_) == 1 &&
                    std::fwrite(&entry.skipped, sizeof entry.skipped, 1, file_) == 1;
  if (!done) fail();
}

void PointSpool::rewind() {
  if (std::fflush(file_) != 0) fail();
  std::rewind(file_);
}

bool PointSpool::read(Entry& entry) {
  double numbers[3];
  if (std::fread(numbers, sizeof numbers, 1, file_) != 1) return false;
  entry.position = {numbers[0], numbers[1], numbers[2]};
  return std::fread(&entry.skipped, sizeof entry.skipped, 1, file_) == 1;
}

}  // namespace limpet::survey
