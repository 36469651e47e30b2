// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>
#include <limpet/io/error.hpp>
#include <limpet/io/label_source.hpp>
#include <limpet/io/scan_formats.hpp>
#include <limpet/io/text.hpp>

namespace limpet::io {
namespace {

bool is_scan_name(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == "ply" || extension == "pcd" || extension == "xyz" || extension == "pwn";
}

bool begins_like_a_scan(ByteSource& source) {
  const std::string_view head = source.peek(8);
  return head.starts_with("ply\n") || head.starts_with("ply\r") || head.starts_with("# .PCD");
}

}  // namespace

LabelSource::LabelSource(const std::string& path, const std::string& column) {
  bool is_scan = is_scan_name(path);
  if (!is_scan) {
    list_ = std::make_unique<ByteSource>(path);
    list_->skip_byte_order_mark();
    is_scan = begins_like_a_scan(*list_);
  }
  if (!is_scan) {
    if (column.empty()) return;
    throw InputError(list_->name(), "is read as a list of labels, which has no column " + in_quotes(column));
  }
  ScanOptions options;
  options.label_column = column;
  scan_ = list_ ? open_scan(std::move(list_), path, options) : open_scan(path, options);
}

bool LabelSource::next(std::int64_t& label) { return is_list() ? next_of_list(label) : next_of_scan(label); }

bool LabelSource::next_of_list(std::int64_t& label) {
  std::string_view line;
  do {
    if (!list_->line(line)) return false;
  } while (line.starts_with('#'));
  std::string_view rest = line;
  const std::string_view token = next_token(rest);
  constexpr double kExact = 9007199254740992.0;  // 2⁵³
  double number = 0;                             // some programs write whole numbers as 3.0 or 3e0
  if (!parse_integer(token, label)) {
    if (!parse_double(token, number) || !(std::abs(number) < kExact) || std::floor(number) != number) {
      throw InputError(list_->here_line(), in_quotes(line) + " is no label: give a whole number a line");
    }
    label = static_cast<std::int64_t>(number);
  }
  if (!next_token(rest).empty()) {
    throw InputError(list_->here_line(), "more than one number; a list of labels has one a line");
  }
  return true;
}

bool LabelSource::next_of_scan(std::int64_t& label) {
  if (!has_record_ && !ended_) {
    has_record_ = scan_->next(record_);
    ended_ = !has_record_;
    gap_ = scan_->skipped() - skipped_;
    skipped_ = scan_->skipped();
  }
  label = -1;
  if (gap_ > 0) {
    --gap_;
    return true;
  }
  if (!has_record_) return false;
  has_record_ = false;
  label = record_.label;
  return true;
}

}  // namespace limpet::io
