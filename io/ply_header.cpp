// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <array>
#include <limpet/io/error.hpp>
#include <limpet/io/ply_header.hpp>
#include <limpet/io/text.hpp>
#include <stdexcept>
#include <utility>

namespace limpet::io {
namespace {

constexpr std::size_t kMaxProperties = 4096, kMaxElements = 256;

/// The older of two names first: that is the one written.
constexpr std::array<std::pair<std::string_view, NumberType>, 16> kTypeNames = {{
    {"char", NumberType::kInt8},
    {"int8", NumberType::kInt8},
    {"uchar", NumberType::kUint8},
    {"uint8", NumberType::kUint8},
    {"short", NumberType::kInt16},
    {"int16", NumberType::kInt16},
    {"ushort", NumberType::kUint16},
    {"uint16", NumberType::kUint16},
    {"int", NumberType::kInt32},
    {"int32", NumberType::kInt32},
    {"uint", NumberType::kUint32},
    {"uint32", NumberType::kUint32},
    {"float", NumberType::kFloat},
    {"float32", NumberType::kFloat},
    {"double", NumberType::kDouble},
    {"float64", NumberType::kDouble},
}};

constexpr std::array<std::pair<std::string_view, PlyHeader::Encoding>, 3> kEncodingNames = {{
    {"ascii", PlyHeader::Encoding::kAscii},
    {"binary_little_endian", PlyHeader::Encoding::kLittleEndian},
    {"binary_big_endian", PlyHeader::Encoding::kBigEndian},
}};

template <class Names, class Value>
std::string name_of(const Names& names, Value value) {
  for (const auto& [name, known] : names) {
    if (known == value) return std::string(name);
  }
  throw std::invalid_argument("a PLY file has no such type");
}

std::size_t fixed_size(const PlyElement& element) {
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties) {
    if (property.is_list) return 0;
    size += size_of(property.type);
  }
  return size;
}

class HeaderReader {
 public:
  explicit HeaderReader(ByteSource& source) : source_(source) {}

  PlyHeader read() {
    next_line("ply");
    if (next_token(rest_) != "ply") fail("expected 'ply'");
    bool has_format = false;
    for (;;) {
      next_line("end_header");
      const std::string_view word = next_token(rest_);
      if (word == "comment" || word == "obj_info" || word.empty()) continue;
      if (word == "end_header") break;
      if (word == "format") {
        read_format();
        has_format = true;
      } else if (word == "element") {
        read_element();
      } else if (word == "property") {
        read_property();
      } else {
        fail(in_quotes(word) + " is no word of a PLY header");
      }
      if (const auto more = next_token(rest_); !more.empty()) fail(in_quotes(more) + " is not expected here");
    }
    if (!has_format) fail("the header has no 'format' line");
    for (PlyElement& element : header_.elements) element.fixed_size = fixed_size(element);
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(source_.here_line(), what); }

  void next_line(const char* wanted) {
    if (!source_.line(rest_)) {
      fail(std::string("the file ends within its header, before '") + wanted + "' (truncated?)");
    }
  }

  void read_format() {
    const std::string_view encoding = next_token(rest_);
    const auto known = std::find_if(kEncodingNames.begin(), kEncodingNames.end(),
                                    [&](const auto& named) { return named.first == encoding; });
    if (known == kEncodingNames.end()) {
      fail("the encoding " + in_quotes(encoding) +
           " is not one of ascii, binary_little_endian, binary_big_endian");
    }
    header_.encoding = known->second;
    if (next_token(rest_) != "1.0") fail("only version 1.0 of the PLY format is known");
  }

  void read_element() {
    if (header_.elements.size() == kMaxElements) fail("more elements than any scan has");
    PlyElement& element = header_.elements.emplace_back();
    element.name = next_token(rest_);
    const std::string_view count = next_token(rest_);
    if (!parse_integer(count, element.count) || element.count < 0) fail(in_quotes(count) + " is not a count");
  }

  NumberType read_type() {
    const std::string_view name = next_token(rest_);
    for (const auto& [known, type] : kTypeNames) {
      if (known == name) return type;
    }
    fail(in_quotes(name) + " is no type of a PLY property");
  }

  void read_property() {
    if (header_.elements.empty()) fail("a property before the first element");
    PlyElement& element = header_.elements.back();
    if (element.properties.size() == kMaxProperties) fail("more properties than any scan has");
    PlyProperty property;
    std::string_view ahead = rest_;
    if (next_token(ahead) == "list") {
      rest_ = ahead;
      property.is_list = true;
      property.count_type = read_type();
      if (!is_integer(property.count_type)) fail("the length of a list is not of an integer type");
    }
    property.type = read_type();
    property.name = next_token(rest_);
    if (property.name.empty()) fail("a property without a name");
    for (const PlyProperty& other : element.properties) {
      if (other.name == property.name) fail("two properties are called " + in_quotes(property.name));
    }
    element.properties.push_back(std::move(property));
  }

  ByteSource& source_;
  std::string_view rest_;
  PlyHeader header_;
};

}  // namespace

PlyHeader read_ply_header(ByteSource& source) { return HeaderReader(source).read(); }

std::string ply_header_text(const PlyHeader& header, std::size_t count_width) {
  std::string text = "ply\nformat " + name_of(kEncodingNames, header.encoding) + " 1.0\n";
  for (const std::string& comment : header.comments) text += "comment " + comment + "\n";
  for (const PlyElement& element : header.elements) {
    const std::string count = std::to_string(element.count);
    text += "element " + element.name + " " +
            std::string(count_width - std::min(count_width, count.size()), ' ') + count + "\n";
    for (const PlyProperty& property : element.properties) {
      text += "property ";
      if (property.is_list) text += "list " + name_of(kTypeNames, property.count_type) + " ";
      text += name_of(kTypeNames, property.type) + " " + property.name + "\n";
    }
  }
  return text + "end_header\n";
}

}  // namespace limpet::io
