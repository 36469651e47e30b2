// Copyright the limpet authors. GPL-3.0-or-later.
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <limpet/io/byte_source.hpp>
#include <limpet/io/error.hpp>

namespace limpet::io {
namespace {
constexpr std::size_t kReadBytes = 1 << 20;
}

ByteSource::ByteSource(const std::string& path, std::function<bool()> stop)
    : name_(path == "-" ? "standard input" : path), stop_(std::move(stop)) {
  // A pipe with a name is opened at once, writer or not, where something can end the wait for one.
  const int flags = O_RDONLY | O_CLOEXEC | (stop_ ? O_NONBLOCK : 0);
  file_ = path == "-" ? STDIN_FILENO : ::open(path.c_str(), flags);
  if (file_ < 0) throw InputError(name_, std::string("cannot be opened: ") + std::strerror(errno));
  if (file_ != STDIN_FILENO && stop_) ::fcntl(file_, F_SETFL, O_RDONLY);
  struct stat found;
  if (::fstat(file_, &found) == 0 && S_ISDIR(found.st_mode)) {
    if (file_ != STDIN_FILENO) ::close(file_);
    throw InputError(name_, "is a folder; give the name of a file in it");
  }
  waits_ = stop_ && !S_ISREG(found.st_mode);
  buffer_.resize(kReadBytes);
}

ByteSource::~ByteSource() {
  if (file_ > STDIN_FILENO) ::close(file_);
}

bool ByteSource::wait() const {
  constexpr int kMilliseconds = 100;
  for (;;) {
    if (stop_()) return false;
    pollfd input{file_, POLLIN, 0};
    const int ready = ::poll(&input, 1, kMilliseconds);
    if (ready > 0 || (ready < 0 && errno != EINTR)) return true;
  }
}

bool ByteSource::fill() {
  if (ended_) return false;
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == buffer_.size()) return false;
  ssize_t got = 0;
  do {
    if (waits_ && !wait()) {
      stopped_ = ended_ = true;
      return false;
    }
    got = ::read(file_, buffer_.data() + end_, buffer_.size() - end_);
  } while (got < 0 && (errno == EINTR || errno == EAGAIN));
  if (got < 0) throw InputError(here_byte(), std::string("cannot be read: ") + std::strerror(errno));
  if (got == 0) ended_ = true;
  end_ += static_cast<std::size_t>(got);
  return got > 0;
}

std::string_view ByteSource::peek(std::size_t count) {
  while (end_ - begin_ < count && fill()) {
  }
  return {buffer_.data() + begin_, end_ - begin_};
}

void ByteSource::skip_byte_order_mark() {
  const std::string_view head = peek(3);
  if (head.starts_with("\xef\xbb\xbf")) skip(3);
  if (head.starts_with("\xff\xfe") || head.starts_with("\xfe\xff"))
    throw InputError(name_, "is text in UTF-16; save it in UTF-8 or ASCII");
}

/// A carriage return ends lines if the first one, or the first few in a row, are not before a line feed.
char ByteSource::first_line_end() {
  char last = 0;
  for (std::size_t at = 0;; ++at) {
    const std::string_view there = peek(at + 1);
    if (there.size() <= at) return last == '\r' ? '\r' : '\n';
    if (there[at] == '\n') return '\n';
    if (last == '\r' && there[at] != '\r') return '\r';
    last = there[at];
  }
}

bool ByteSource::line(std::string_view& text) {
  if (line_end_ == 0) line_end_ = first_line_end();
  std::size_t searched = 0;
  for (;;) {
    const char* from = buffer_.data() + begin_;
    const std::size_t there = end_ - begin_;
    const void* found = std::memchr(from + searched, line_end_, there - searched);
    if (found == nullptr) {
      searched = there;
      if (fill()) continue;
      if (end_ - begin_ == kReadBytes) {
        throw InputError(name_ + ": line " + std::to_string(line_number_ + 1),
                         "longer than 1 MiB; is this a binary file?");
      }
      if (there == 0 || stopped_) return false;  // what is there of a line is not all of it
    }
    const std::size_t length =
        found != nullptr ? static_cast<std::size_t>(static_cast<const char*>(found) - from) : there;
    text = {buffer_.data() + begin_, length};
    const std::size_t taken = found != nullptr ? length + 1 : length;
    begin_ += taken;
    offset_ += static_cast<std::int64_t>(taken);
    ++line_number_;
    while (text.ends_with('\r')) text.remove_suffix(1);
    return true;
  }
}

std::string_view ByteSource::take(std::size_t count) {
  if (end_ - begin_ < count && peek(count).size() < count) return {};
  const std::string_view bytes(buffer_.data() + begin_, count);
  begin_ += count;
  offset_ += static_cast<std::int64_t>(count);
  return bytes;
}

bool ByteSource::skip(std::uint64_t count) {
  while (count > 0) {
    if (begin_ == end_ && !fill()) return false;
    const std::uint64_t there = end_ - begin_, step = count < there ? count : there;
    begin_ += step;
    offset_ += static_cast<std::int64_t>(step);
    count -= step;
  }
  return true;
}

std::string ByteSource::here_line() const { return name_ + ": line " + std::to_string(line_number_); }
std::string ByteSource::here_byte() const { return name_ + ": byte " + std::to_string(offset_); }

}  // namespace limpet::io
