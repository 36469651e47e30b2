// Copyright the limpet authors. GPL-3.0-or-later.
#include <cstring>
#include <limits>
#include <limpet/io/binary_number.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/output_file.hpp>
#include <limpet/io/ply_header.hpp>
#include <limpet/io/scan_writer.hpp>
#include <limpet/io/text.hpp>
#include <stdexcept>

namespace limpet::io {
namespace {

/// Digits kept free in the header for the number of points, which is known only at the end.
constexpr std::size_t kCountDigits = 19;

std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

std::int32_t checked_label(std::int64_t label) {
  if (label < std::numeric_limits<std::int32_t>::min() || label > std::numeric_limits<std::int32_t>::max()) {
    throw std::invalid_argument("a label of more than 32 bits: " + std::to_string(label));
  }
  return static_cast<std::int32_t>(label);
}

bool writes_ranges(const ScanWriterOptions& options) { return options.axes && options.ranges; }

void append_line(std::string& text, const ScanRecord& record, const ScanWriterOptions& options) {
  const auto append_vector = [&](const Eigen::Vector3d& v) {
    for (int i = 0; i < 3; ++i) {
      append(text, v[i]);
      text += ' ';
    }
  };
  append_vector(record.point.position);
  if (options.axes) append_vector(record.point.axis);
  if (writes_ranges(options)) {
    append(text, record.point.range);
    text += ' ';
  }
  if (options.labels) {
    append(text, static_cast<std::int64_t>(checked_label(record.label)));
    text += ' ';
  }
  text.back() = '\n';
}

class PlyWriter final : public ScanWriter {
 public:
  PlyWriter(const std::string& path, const ScanWriterOptions& options) : file_(path), options_(options) {
    PlyHeader header;
    header.encoding = options.ascii ? PlyHeader::Encoding::kAscii : PlyHeader::Encoding::kLittleEndian;
    if (!options.comment.empty()) header.comments.push_back(one_line(options.comment));
    PlyElement& vertex = header.elements.emplace_back();
    vertex.name = "vertex";
    for (const char* name : {"x", "y", "z"}) vertex.properties.push_back({name, NumberType::kDouble});
    if (options.axes) {
      for (const char* name : {"ax", "ay", "az"}) vertex.properties.push_back({name, NumberType::kDouble});
    }
    if (writes_ranges(options)) vertex.properties.push_back({"range", NumberType::kDouble});
    if (options.labels) vertex.properties.push_back({"face", NumberType::kInt32});
    const std::string text = ply_header_text(header, kCountDigits);
    // The comment is one line, so that no other line begins like this.
    const std::string before = "\nelement vertex ";
    count_offset_ = static_cast<std::int64_t>(text.find(before) + before.size());
    file_.write(text);
  }

  void write(const ScanRecord& record) override {
    ++count_;
    if (options_.ascii) {
      line_.clear();
      append_line(line_, record, options_);
      file_.write(line_);
      return;
    }
    char bytes[7 * sizeof(double) + sizeof(std::int32_t)];
    char* at = bytes;
    const auto put = [&](const void* from, std::size_t size) {
      std::memcpy(at, from, size);
      at += size;
    };
    put(record.point.position.data(), 3 * sizeof(double));
    if (options_.axes) put(record.point.axis.data(), 3 * sizeof(double));
    if (writes_ranges(options_)) put(&record.point.range, sizeof record.point.range);
    if (options_.labels) {
      const std::int32_t label = checked_label(record.label);
      put(&label, sizeof label);
    }
    file_.write({bytes, static_cast<std::size_t>(at - bytes)});
  }

  void close() override {
    const std::string digits = std::to_string(count_);
    file_.overwrite(count_offset_, std::string(kCountDigits - digits.size(), ' ') + digits);
    file_.close();
  }

 private:
  OutputFile file_;
  ScanWriterOptions options_;
  std::string line_;
  std::int64_t count_offset_ = 0, count_ = 0;
};

class XyzWriter final : public ScanWriter {
 public:
  XyzWriter(const std::string& path, const ScanWriterOptions& options) : file_(path), options_(options) {
    if (!options.comment.empty()) file_.write("# " + one_line(options.comment) + "\n");
    std::string names = "# x y z";
    if (options.axes) names += " ax ay az";
    if (writes_ranges(options)) names += " range";
    if (options.labels) names += " face";
    file_.write(names + "\n");
  }

  void write(const ScanRecord& record) override {
    line_.clear();
    append_line(line_, record, options_);
    file_.write(line_);
  }

  void close() override { file_.close(); }

 private:
  OutputFile file_;
  ScanWriterOptions options_;
  std::string line_;
};

}  // namespace

std::unique_ptr<ScanWriter> create_scan(const std::string& path, const ScanWriterOptions& options) {
  const std::string extension = extension_of(path);
  if (extension == "ply") return std::make_unique<PlyWriter>(path, options);
  if (extension == "xyz") return std::make_unique<XyzWriter>(path, options);
  throw OutputError(path + ": a scan is written as .ply or .xyz, not as " + in_quotes(extension));
}

}  // namespace limpet::io
