// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/io/error.hpp>
#include <limpet/io/pcd_header.hpp>
#include <limpet/io/text.hpp>
#include <map>

namespace limpet::io {
namespace {

constexpr std::size_t kMaxRecordBytes = 1 << 16;

class PcdHeaderReader {
 public:
  explicit PcdHeaderReader(ByteSource& source) : source_(source) {}

  PcdHeader read() {
    for (;;) {
      std::string_view line;
      if (!source_.line(line)) fail("the file ends within its header, before 'DATA' (truncated?)");
      const std::string_view word = next_token(line);
      if (word.empty() || word.starts_with('#')) continue;
      if (!is_known(word)) fail(in_quotes(word) + " is no word of a PCD header");
      std::vector<std::string>& values = entries_[std::string(word)];
      if (!values.empty()) fail(in_quotes(word) + " is there twice");
      for (auto token = next_token(line); !token.empty(); token = next_token(line))
        values.emplace_back(token);
      if (values.empty()) fail(in_quotes(word) + " says nothing");
      if (word == "DATA") break;
    }
    read_fields();
    read_points();
    read_viewpoint();
    read_encoding();
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(source_.here_line(), what); }

  static bool is_known(std::string_view word) {
    for (const char* known : {"VERSION", "FIELDS", "COLUMNS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT",
                              "VIEWPOINT", "POINTS", "DATA"}) {
      if (word == known) return true;
    }
    return false;
  }

  const std::vector<std::string>& entry(const char* word) { return entries_[word]; }

  std::int64_t number(const std::string& text) {
    std::int64_t value = 0;
    if (!parse_integer(text, value) || value < 0) fail(in_quotes(text) + " is not a count");
    return value;
  }

  NumberType type(const std::string& letter, std::int64_t size) {
    using enum NumberType;
    if (letter == "F" && size == 4) return kFloat;
    if (letter == "F" && size == 8) return kDouble;
    if (letter == "I" || letter == "U") {
      const bool is_signed = letter == "I";
      if (size == 1) return is_signed ? kInt8 : kUint8;
      if (size == 2) return is_signed ? kInt16 : kUint16;
      if (size == 4) return is_signed ? kInt32 : kUint32;
      if (size == 8) return is_signed ? kInt64 : kUint64;
    }
    fail("no number has TYPE " + in_quotes(letter) + " and SIZE " + std::to_string(size));
  }

  void read_fields() {
    const auto& names = entry("FIELDS").empty() ? entry("COLUMNS") : entry("FIELDS");
    const auto &sizes = entry("SIZE"), &types = entry("TYPE"), &counts = entry("COUNT");
    if (names.empty()) fail("the header has no FIELDS");
    if (sizes.size() != names.size() || types.size() != names.size() ||
        (!counts.empty() && counts.size() != names.size())) {
      fail("FIELDS, SIZE, TYPE and COUNT are not of one length");
    }
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      PcdField& field = header_.fields.emplace_back();
      field.name = names[i];
      field.type = type(types[i], number(sizes[i]));
      if (!counts.empty()) field.count = static_cast<std::size_t>(number(counts[i]));
      if (field.count > kMaxRecordBytes) fail("a point of more than 64 KiB");
      bytes += field.count * size_of(field.type);
      if (bytes > kMaxRecordBytes) fail("a point of more than 64 KiB");
    }
  }

  void read_points() {
    std::int64_t grid = -1;
    if (!entry("WIDTH").empty()) {
      const std::int64_t width = number(entry("WIDTH")[0]);
      const std::int64_t height = entry("HEIGHT").empty() ? 1 : number(entry("HEIGHT")[0]);
      if (__builtin_mul_overflow(width, height, &grid))
        fail("WIDTH times HEIGHT is more than any file holds");
    }
    if (entry("POINTS").empty() && grid < 0) fail("the header has neither POINTS nor WIDTH");
    header_.points = entry("POINTS").empty() ? grid : number(entry("POINTS")[0]);
    if (grid >= 0 && grid != header_.points) fail("POINTS is not WIDTH times HEIGHT");
  }

  void read_viewpoint() {
    const auto& pose = entry("VIEWPOINT");
    if (pose.empty()) return;
    if (pose.size() != 7) fail("VIEWPOINT has " + std::to_string(pose.size()) + " numbers, not 7");
    Eigen::Vector3d at;
    for (int i = 0; i < 3; ++i) {
      if (!parse_double(pose[i], at[i])) fail(in_quotes(pose[i]) + " is not a number");
    }
    if (at.allFinite()) header_.viewpoint = at;
  }

  void read_encoding() {
    const std::string& encoding = entry("DATA")[0];
    if (encoding == "ascii") {
      header_.encoding = PcdHeader::Encoding::kAscii;
    } else if (encoding == "binary") {
      header_.encoding = PcdHeader::Encoding::kBinary;
    } else if (encoding == "binary_compressed") {
      header_.encoding = PcdHeader::Encoding::kCompressed;
    } else {
      fail("DATA is " + in_quotes(encoding) + ", not ascii, binary or binary_compressed");
    }
  }

  ByteSource& source_;
  std::map<std::string, std::vector<std::string>> entries_;
  PcdHeader header_;
};

}  // namespace

PcdHeader read_pcd_header(ByteSource& source) { return PcdHeaderReader(source).read(); }

}  // namespace limpet::io
