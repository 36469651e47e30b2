// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/progress.hpp>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limpet/io/text.hpp>
#include <utility>

namespace limpet::app {

Progress::Progress(std::string doing, std::int64_t total, bool quiet)
    : doing_(std::move(doing)), total_(total), on_(!quiet && ::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { clear(); }

void Progress::step(std::int64_t done, const std::string& note) {
  if (!on_) return;
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(200);
  show(done, note, std::chrono::duration<double>(now - start_).count());
}

void Progress::show(std::int64_t done, const std::string& note, double seconds) {
  const double rate = static_cast<double>(done) / seconds;
  std::string line = doing_ + " ";
  if (total_ > 0) {
    const double part = std::min(1.0, static_cast<double>(done) / static_cast<double>(total_));
    constexpr int kWidth = 24;
    const int full = static_cast<int>(part * kWidth);
    line += "[" + std::string(static_cast<std::size_t>(full), '#') +
            std::string(static_cast<std::size_t>(kWidth - full), '.') + "] " +
            std::to_string(static_cast<int>(100 * part)) + " %  ";
  }
  line += io::grouped(done) + "  " + io::grouped(static_cast<std::int64_t>(rate)) + "/s";
  if (total_ > 0 && rate > 0) {
    line += "  " + duration_text(std::max(0.0, static_cast<double>(total_ - done) / rate)) + " left";
  }
  if (!note.empty()) line += "  " + note;
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  std::fflush(stderr);
  shown_ = true;
}

void Progress::clear() {
  if (!shown_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  shown_ = false;
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::llround(seconds));
  if (whole < 60) return std::to_string(whole) + " s";
  char text[32];
  if (whole < 3600) {
    std::snprintf(text, sizeof text, "%d:%02d", static_cast<int>(whole / 60), static_cast<int>(whole % 60));
  } else {
    std::snprintf(text, sizeof text, "%d:%02d:%02d", static_cast<int>(whole / 3600),
                  static_cast<int>(whole / 60 % 60), static_cast<int>(whole % 60));
  }
  return text;
}

}  // namespace limpet::app
