// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/survey/backlog.hpp>

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limpet/io/error.hpp>
#include <string>

namespace limpet::survey {
namespace {

constexpr std::size_t kInMemory = 100'000;

[[noreturn]] void fail() {
  throw io::OutputError(std::string("a temporary file for the scan cannot be written: ") +
                        std::strerror(errno) + "; set TMPDIR to a folder with space, or give a file");
}

std::FILE* temporary_file() {
  std::error_code error;
  std::string name = (std::filesystem::temp_directory_path(error) / "limpet-XXXXXX").string();
  const int file = error ? -1 : ::mkstemp(name.data());
  if (file < 0) fail();
  ::unlink(name.c_str());
  std::FILE* stream = ::fdopen(file, "w+b");
  if (stream == nullptr) {
    ::close(file);
    fail();
  }
  return stream;
}

/// As it lies in the file.
struct Stored {
  std::array<double, 7> numbers;
  std::int64_t skipped, has_axis;
};

Stored stored(const ReadPoint& p) {
  const Eigen::Vector3d &at = p.point.position, &axis = p.point.axis;
  return {{at.x(), at.y(), at.z(), axis.x(), axis.y(), axis.z(), p.point.range}, p.skipped, p.has_axis};
}

ReadPoint restored(const Stored& s) {
  const auto& n = s.numbers;
  return {{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n[6]}, s.has_axis != 0, s.skipped};
}

void write(std::FILE* file, const ReadPoint& point) {
  const Stored bytes = stored(point);
  if (std::fwrite(&bytes, sizeof bytes, 1, file) != 1) fail();
}

bool read(std::FILE* file, ReadPoint& point) {
  Stored bytes;
  if (std::fread(&bytes, sizeof bytes, 1, file) != 1) return false;
  point = restored(bytes);
  return true;
}

void go_to(std::FILE* file, int end) {
  if (std::fflush(file) != 0 || std::fseek(file, 0, end) != 0) fail();
}

}  // namespace

Backlog::Backlog() = default;
Backlog::~Backlog() = default;
Backlog::Backlog(Backlog&&) noexcept = default;
Backlog& Backlog::operator=(Backlog&&) noexcept = default;

void Backlog::add(const ReadPoint& point) {
  ++size_;
  if (in_memory_.size() < kInMemory && !file_) {
    in_memory_.push_back(point);
    return;
  }
  if (!file_) file_.reset(temporary_file());
  if (reading_) go_to(file_.get(), SEEK_END);
  reading_ = false;
  write(file_.get(), point);
}

void Backlog::for_each(std::int64_t most, const std::function<void(const ReadPoint&)>& look) {
  for (const ReadPoint& point : in_memory_)
    if (most-- > 0) look(point);
  if (!file_) return;
  go_to(file_.get(), SEEK_SET);
  reading_ = true;
  for (ReadPoint point; most-- > 0 && read(file_.get(), point);) look(point);
  go_to(file_.get(), SEEK_END);
  reading_ = false;
}

bool Backlog::take(ReadPoint& point) {
  if (!in_memory_.empty()) {
    point = in_memory_.front();
    in_memory_.pop_front();
  } else if (!file_) {
    return false;
  } else {
    if (!reading_) go_to(file_.get(), SEEK_SET);
    reading_ = true;
    if (!read(file_.get(), point)) {
      file_.reset();
      reading_ = false;
      return false;
    }
  }
  --size_;
  return true;
}

}  // namespace limpet::survey
